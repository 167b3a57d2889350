#include "scree/app/contact_fields.h"

#include <memory>
#include <utility>

#include "scree/particles/contact_forces.h"

namespace scree {
namespace {

template <class T>
FrameColumn column(const char* name, const char* unit, const char* meaning, std::vector<T> values,
                   std::uint64_t components) {
  const auto kept = std::make_shared<const std::vector<T>>(std::move(values));
  return {name, unit, meaning, array_view(kept->data(), kept->size() / components, components), kept};
}

/// -0 as 0: the sign of a zero depends on which partner a contact was computed from, and that on the lists.
double plain(double x) { return x + 0.0; }

void append(std::vector<double>& to, const sc_vec& v) { to.insert(to.end(), {plain(v.x), plain(v.y), plain(v.z)}); }

/// The contact point, inside the periodic box.
sc_vec point_of(const ParticleSystem& s, const ContactForce& c) {
  const double* x = s.particles.motion.row(c.first);
  double at[3] = {x[0] + c.arm.x, x[1] + c.arm.y, x[2] + c.arm.z};
  for (int k = 0; k < 3; ++k) {
    if (at[k] < s.domain.min[k]) at[k] += s.domain.period(k);
    if (at[k] >= s.domain.max[k]) at[k] -= s.domain.period(k);
  }
  return sc_make_vec(at[0], at[1], at[2]);
}

/// What a file tells of contacts, one value or vector for each.
struct ContactTable {
  std::vector<std::int64_t> first, second;
  std::vector<std::int32_t> wall;
  std::vector<double> position, normal, force, normal_force, tangential_force;
};

std::vector<FrameColumn> columns_of(ContactTable t) {
  std::vector<FrameColumn> out;
  out.push_back(column("first", "1", "Id of the first particle, the lower one.", std::move(t.first), 1));
  out.push_back(column("second", "1", "Id of the second particle; -1 at a wall.", std::move(t.second), 1));
  out.push_back(
      column("wall", "1", "Place of the wall in the case, from 0; -1 between particles.", std::move(t.wall), 1));
  out.push_back(column("position", "m", "Contact point, inside the periodic box.", std::move(t.position), 3));
  out.push_back(column("normal", "1", "Unit vector from the first to the second.", std::move(t.normal), 3));
  out.push_back(column("force", "N", "On the first particle.", std::move(t.force), 3));
  out.push_back(column("normal_force", "N", "Along the normal, positive when pressed.", std::move(t.normal_force), 1));
  out.push_back(
      column("tangential_force", "N", "Part of the force across the normal.", std::move(t.tangential_force), 3));
  return out;
}

}  // namespace

std::vector<FrameColumn> contact_columns(const Sample& sample) {
  ContactTable table;
  for (const ContactForce& c : contact_forces(sample)) {
    table.first.push_back(c.first_id);
    table.second.push_back(c.second_id);
    table.wall.push_back(c.wall);
    append(table.position, point_of(sample.system, c));
    append(table.normal, c.normal);
    append(table.force, c.force);
    table.normal_force.push_back(plain(-sc_dot(c.force, c.normal)));
    append(table.tangential_force, sc_reject(c.force, c.normal));
  }
  return columns_of(std::move(table));
}

std::vector<RowKey> contact_keys(std::span<const FrameColumn> columns, std::int64_t next_id) {
  const auto* first = static_cast<const std::int64_t*>(columns[0].values.data);
  const auto* second = static_cast<const std::int64_t*>(columns[1].values.data);
  std::vector<RowKey> keys;
  for (std::uint64_t k = 0; k < columns[0].values.rows; ++k)
    // The walls of one particle are on one rank, in the order of their faces.
    keys.push_back({first[k] + (second[k] < 0 ? next_id : 0), second[k]});
  return keys;
}

std::size_t file_bytes_per_contact() {
  std::size_t bytes = sizeof(std::int32_t);  // of the list of vertices
  for (const FrameColumn& c : columns_of({})) bytes += c.values.columns * element_size(c.values.element);
  return bytes;
}

}  // namespace scree
