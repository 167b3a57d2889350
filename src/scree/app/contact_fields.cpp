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

void append(std::vector<double>& to, const sc_vec& v) { to.insert(to.end(), {v.x, v.y, v.z}); }

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

}  // namespace

std::vector<FrameColumn> contact_columns(const Sample& sample) {
  std::vector<std::int64_t> first, second;
  std::vector<std::int32_t> wall;
  std::vector<double> position, normal, force, normal_force, tangential_force;
  for (const ContactForce& c : contact_forces(sample)) {
    first.push_back(c.first_id);
    second.push_back(c.second_id);
    wall.push_back(c.wall);
    append(position, point_of(sample.system, c));
    append(normal, c.normal);
    append(force, c.force);
    normal_force.push_back(-sc_dot(c.force, c.normal));
    append(tangential_force, sc_reject(c.force, c.normal));
  }
  std::vector<FrameColumn> out;
  out.push_back(column("first", "1", "Id of the first particle, the lower one.", std::move(first), 1));
  out.push_back(column("second", "1", "Id of the second particle; -1 at a wall.", std::move(second), 1));
  out.push_back(
      column("wall", "1", "Place of the wall in the case, from 0; -1 between particles.", std::move(wall), 1));
  out.push_back(column("position", "m", "Contact point, inside the periodic box.", std::move(position), 3));
  out.push_back(column("normal", "1", "Unit vector from the first to the second.", std::move(normal), 3));
  out.push_back(column("force", "N", "On the first particle.", std::move(force), 3));
  out.push_back(column("normal_force", "N", "Along the normal, positive when pressed.", std::move(normal_force), 1));
  out.push_back(
      column("tangential_force", "N", "Part of the force across the normal.", std::move(tangential_force), 3));
  return out;
}

}  // namespace scree
