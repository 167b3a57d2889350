// Saving a simulation, continuing it, and the hash that tells whether two are the same to the last bit.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "scree/app/simulation.h"
#include "scree/app/take_over.h"
#include "scree/base/error.h"
#include "scree/base/hash.h"

namespace scree {
namespace {

/// Contacts with memory, by key: of pairs the ids, with directions from the lower to the higher; of walls id and face.
struct KeyedContacts {
  std::vector<std::int64_t> ids;  // [contacts][2]
  std::vector<double> memory;     // [contacts][9]: slide x y z, approach, roll x y z, twist, slid
  std::vector<double> shape;      // [contacts][what of the memory of shapes lasts], or empty
};

/// Order of rows of two numbers.
std::vector<std::size_t> order_of(const std::vector<std::int64_t>& keys) {
  std::vector<std::size_t> order(keys.size() / 2);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    // Several places of one face stay in their order.
    return std::tuple(keys[2 * a], keys[2 * a + 1], a) < std::tuple(keys[2 * b], keys[2 * b + 1], b);
  });
  return order;
}

/// Rows of a table in another order; an empty table stays so.
template <class T>
void reorder(std::vector<T>& table, const std::vector<std::size_t>& order) {
  if (table.empty()) return;
  const std::size_t width = table.size() / order.size();
  std::vector<T> out;
  out.reserve(table.size());
  for (const std::size_t k : order) out.insert(out.end(), &table[width * k], &table[width * k] + width);
  table = std::move(out);
}

KeyedContacts in_order(KeyedContacts contacts) {
  const std::vector<std::size_t> order = order_of(contacts.ids);
  reorder(contacts.ids, order);
  reorder(contacts.memory, order);
  reorder(contacts.shape, order);
  return contacts;
}

/// The memory of contact c of a list that holds pairs or walls.
template <class Contacts>
void append_memory(std::vector<double>& to, const Contacts& contacts, std::size_t c, double sign) {
  const auto &slide = contacts.slide, &roll = contacts.roll;
  for (int k = 0; k < 3; ++k) to.push_back(sign * slide[4 * c + k]);
  to.push_back(slide[4 * c + 3]);
  for (int k = 0; k < 3; ++k) to.push_back(roll.empty() ? 0.0 : sign * roll[4 * c + k]);
  to.push_back(roll.empty() ? 0.0 : roll[4 * c + 3]);
  to.push_back(contacts.active[c] == contact_code(true, true) ? 1.0 : 0.0);
}

KeyedContacts keyed_pairs(const ParticleSystem& s) {
  KeyedContacts out;
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (!s.contacts.active[c]) continue;
    const std::int64_t a = s.particles.id[s.contacts.pairs.owner[c]], b = s.particles.id[s.contacts.pairs.partner[c]];
    out.ids.push_back(std::min(a, b));
    out.ids.push_back(std::max(a, b));
    append_memory(out.memory, s.contacts, c, a < b ? 1 : -1);
    if (!s.contacts.remembers_shapes) continue;
    const double* shape = &s.contacts.shape[pair_memory * c];
    out.shape.insert(out.shape.end(), shape, shape + pair_scratch);
  }
  return in_order(std::move(out));
}

KeyedContacts keyed_walls(const ParticleSystem& s) {
  KeyedContacts out;
  for (std::size_t p = 0; p + 1 < s.wall_contacts.first.size(); ++p)
    for (std::int32_t w = s.wall_contacts.first[p]; w < s.wall_contacts.first[p + 1]; ++w) {
      if (!s.wall_contacts.active[w]) continue;
      out.ids.push_back(s.particles.id[p]);
      out.ids.push_back(s.wall_contacts.wall[w]);
      append_memory(out.memory, s.wall_contacts, w, 1);
      if (s.wall_contacts.shape.empty()) continue;
      const double* shape = &s.wall_contacts.shape[wall_memory * std::size_t(w)];
      out.shape.insert(out.shape.end(), shape, shape + wall_scratch);
    }
  return in_order(std::move(out));
}

/// -0 and 0 are the same state.
double plain(double x) { return x + 0.0; }

std::unordered_map<std::int64_t, std::int32_t> rows_by_id(const Particles& p) {
  std::unordered_map<std::int64_t, std::int32_t> row;
  row.reserve(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) row[p.id[i]] = static_cast<std::int32_t>(i);
  return row;
}

/// Pairs as lists of one contact each, ready to be carried over into real lists.
PairContacts contacts_of(std::span<const std::int64_t> ids, std::span<const double> memory,
                         std::span<const double> shape, const Particles& p, bool rolling) {
  const auto row = rows_by_id(p);
  const std::size_t count = ids.size() / 2;
  PairContacts out;
  out.remembers_rolling = rolling;
  out.remembers_shapes = p.shaped();
  out.pairs.count = count;
  out.pairs.owner.resize(count);
  out.pairs.partner.resize(count);
  out.active.resize(count);
  out.slide.resize(4 * count);
  if (rolling) out.roll.resize(4 * count);
  if (p.shaped()) out.shape.resize(pair_memory * count);
  for (std::size_t c = 0; c < count; ++c) {
    const auto a = row.find(ids[2 * c]), b = row.find(ids[2 * c + 1]);
    if (a == row.end() || b == row.end()) throw InputError("a contact names a particle that is not there");
    out.pairs.owner[c] = a->second;
    out.pairs.partner[c] = b->second;
    out.active[c] = contact_code(true, memory[9 * c + 8] != 0);
    std::copy_n(&memory[9 * c], 4, &out.slide[4 * c]);
    if (rolling) std::copy_n(&memory[9 * c + 4], 4, &out.roll[4 * c]);
    if (p.shaped()) std::copy_n(&shape[pair_scratch * c], pair_scratch, &out.shape[pair_memory * c]);
  }
  return out;
}

WallContacts walls_of(std::span<const std::int64_t> ids, std::span<const double> memory, std::span<const double> shape,
                      const Particles& p, std::size_t faces) {
  const auto row = rows_by_id(p);
  std::vector<std::vector<std::size_t>> mine(p.size());
  for (std::size_t c = 0; c < ids.size() / 2; ++c) {
    const auto found = row.find(ids[2 * c]);
    if (found == row.end() || ids[2 * c + 1] >= static_cast<std::int64_t>(faces))
      throw InputError("a contact names a particle or a wall that is not there");
    mine[found->second].push_back(c);
  }
  WallContacts out;
  out.first.resize(p.size() + 1);
  out.wall.resize(ids.size() / 2);
  out.active.resize(ids.size() / 2);
  out.slide.resize(2 * ids.size());
  out.roll.resize(2 * ids.size());
  out.gap.resize(ids.size() / 2);
  if (!shape.empty()) out.shape.resize(wall_memory * (ids.size() / 2));
  std::int32_t next = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const std::size_t c : mine[i]) {
      out.wall[next] = static_cast<std::int32_t>(ids[2 * c + 1]);
      out.active[next] = contact_code(true, memory[9 * c + 8] != 0);
      std::copy_n(&memory[9 * c], 4, &out.slide[4 * std::size_t(next)]);
      std::copy_n(&memory[9 * c + 4], 4, &out.roll[4 * std::size_t(next)]);
      if (!shape.empty())
        std::copy_n(&shape[wall_scratch * c], wall_scratch, &out.shape[wall_memory * std::size_t(next)]);
      ++next;
    }
    out.first[i + 1] = next;
  }
  return out;
}

}  // namespace

std::string Simulation::state_hash() const {
  Sha256 hash;
  const auto add = [&hash](const double* x, int count) {
    for (int k = 0; k < count; ++k) {
      const double value = plain(x[k]);
      hash.update(&value, sizeof value);
    }
  };
  const double time = clock_.now();
  add(&time, 1);
  const Particles& p = system_.particles;
  for (const std::uint32_t i : order_by_id(p)) {
    hash.update(&p.id[i], sizeof p.id[i]);
    add(p.motion.row(i), 8);
    add(p.spin.row(i), 4);
    if (!p.shaped()) continue;
    hash.update(&p.form[i], sizeof p.form[i]);
    add(p.orientation.row(i), 4);
    add(p.angular_momentum.row(i), 3);  // the way of the surface serves the lists, which change nothing
  }
  const KeyedContacts pairs = keyed_pairs(system_);
  hash.update(pairs.ids.data(), pairs.ids.size() * sizeof(std::int64_t));
  add(pairs.memory.data(), static_cast<int>(pairs.memory.size()));
  add(pairs.shape.data(), static_cast<int>(pairs.shape.size()));
  const KeyedContacts walls = keyed_walls(system_);
  hash.update(walls.ids.data(), walls.ids.size() * sizeof(std::int64_t));
  add(walls.memory.data(), static_cast<int>(walls.memory.size()));
  add(walls.shape.data(), static_cast<int>(walls.shape.size()));
  return hash.hex();
}

Archive Simulation::save() const {
  Archive out;
  out.set("step", clock_.step);
  out.set("time", clock_.now());
  out.set("time_step", clock_.dt);
  out.set("contact_evaluations", tally_.contacts);
  out.set("wall_contact_evaluations", tally_.wall_contacts);
  out.set("impacts", tally_.impacts);
  out.set("impact_speed", tally_.impact_speed);
  Particles p = system_.particles;
  save_forms(system_.forms, out);
  out.set("particles", static_cast<std::int64_t>(p.size()));
  out.set("groups", group_names(case_));
  p.for_each_field([&](std::string_view name, auto& column, Travels, bool saved, auto) {
    if (saved) out.put(std::string(name), std::move(column.values), column.components);
  });
  KeyedContacts pairs = keyed_pairs(system_);
  out.put("pair_ids", std::move(pairs.ids), 2);
  out.put("pair_memory", std::move(pairs.memory), 9);
  if (p.shaped()) out.put("pair_shape", std::move(pairs.shape), pair_scratch);
  KeyedContacts walls = keyed_walls(system_);
  out.put("wall_ids", std::move(walls.ids), 2);
  out.put("wall_memory", std::move(walls.memory), 9);
  if (p.shaped()) out.put("wall_shape", std::move(walls.shape), wall_scratch);
  exchange_.save(out);
  return out;
}

void Simulation::restore(const Archive& archive) {
  if (archive.number("time_step") != clock_.dt)
    throw InputError(
        fmt::format("{} was written with time step {} s, the case has {} s: a run continues with its own time "
                    "step",
                    archive.origin, archive.number("time_step"), clock_.dt));
  Particles saved = particles_of(archive);
  exchange_.restore(archive);
  clock_.step = archive.integer("step");
  tally_ = {archive.integer("contact_evaluations"), archive.integer("wall_contact_evaluations"),
            archive.integer("impacts"), archive.integer("impact_speed")};
  system_.particles = std::move(saved);
  system_.forms = forms_of(archive);
  if (system_.vertices) {
    for (std::size_t i = 1; i < system_.forms.size(); ++i) system_.forms[i].shape.is_sphere = 0;
    system_.vertices = make_vertices(system_.forms, system_.vertices->side, system_.vertices->spacing);
  }
  const bool shaped = system_.particles.shaped();
  const auto rows = [&](const char* name, int width) {
    return shaped ? archive.get<double>(name, width) : std::span<const double>();
  };
  system_.contacts =
      contacts_of(archive.get<std::int64_t>("pair_ids", 2), archive.get<double>("pair_memory", 9),
                  rows("pair_shape", pair_scratch), system_.particles, system_.contacts.remembers_rolling);
  system_.wall_contacts = walls_of(archive.get<std::int64_t>("wall_ids", 2), archive.get<double>("wall_memory", 9),
                                   rows("wall_shape", wall_scratch), system_.particles, system_.walls.size());
  lists_ = prepare_lists(system_, case_.simulation.skin);
  findings_.fastest2 = fastest_square(system_.particles);
  sampled_step_ = -1;
}

}  // namespace scree
