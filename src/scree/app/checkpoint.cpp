// Saving a simulation, continuing it, and the hash that tells whether two are the same to the last bit.
#include <fmt/format.h>

#include <algorithm>

#include "scree/app/simulation.h"
#include "scree/app/take_over.h"
#include "scree/base/error.h"
#include "scree/base/hash.h"
#include "scree/particles/keyed_contacts.h"

namespace scree {
namespace {

/// -0 and 0 are the same state.
double plain(double x) { return x + 0.0; }

}  // namespace

std::string Simulation::state_hash() {
  const ParticleSystem& system = whole();
  Sha256 hash;
  const auto add = [&hash](const double* x, int count) {
    for (int k = 0; k < count; ++k) {
      const double value = plain(x[k]);
      hash.update(&value, sizeof value);
    }
  };
  const double time = clock_.now();
  add(&time, 1);
  const Particles& p = system.particles;
  for (const std::uint32_t i : order_by_id(p)) {
    hash.update(&p.id[i], sizeof p.id[i]);
    add(p.motion.row(i), 8);
    add(p.spin.row(i), 4);
    if (!p.shaped()) continue;
    hash.update(&p.form[i], sizeof p.form[i]);
    add(p.orientation.row(i), 4);
    add(p.angular_momentum.row(i), 3);  // the way of the surface serves the lists, which change nothing
  }
  const KeyedContacts pairs = keyed_pairs(system);
  hash.update(pairs.ids.data(), pairs.ids.size() * sizeof(std::int64_t));
  add(pairs.memory.data(), static_cast<int>(pairs.memory.size()));
  add(pairs.shape.data(), static_cast<int>(pairs.shape.size()));
  const KeyedContacts walls = keyed_walls(system);
  hash.update(walls.ids.data(), walls.ids.size() * sizeof(std::int64_t));
  add(walls.memory.data(), static_cast<int>(walls.memory.size()));
  add(walls.shape.data(), static_cast<int>(walls.shape.size()));
  return hash.hex();
}

Archive Simulation::save() {
  const ParticleSystem& system = whole();
  Archive out;
  out.set("step", clock_.step);
  out.set("time", clock_.now());
  out.set("time_step", clock_.dt);
  out.set("contact_evaluations", tally_.contacts);
  out.set("wall_contact_evaluations", tally_.wall_contacts);
  out.set("impacts", tally_.impacts);
  out.set("impact_speed", tally_.impact_speed);
  Particles p = system.particles;
  p.permute(order_by_id(p));
  save_forms(system.forms, out);
  out.set("particles", static_cast<std::int64_t>(p.size()));
  out.set("groups", group_names(case_));
  p.for_each_field([&](std::string_view name, auto& column, Travels, bool saved, auto) {
    if (saved) out.put(std::string(name), std::move(column.values), column.components);
  });
  KeyedContacts pairs = keyed_pairs(system);
  out.put("pair_ids", std::move(pairs.ids), 2);
  out.put("pair_memory", std::move(pairs.memory), 9);
  if (p.shaped()) out.put("pair_shape", std::move(pairs.shape), pair_scratch);
  KeyedContacts walls = keyed_walls(system);
  out.put("wall_ids", std::move(walls.ids), 2);
  out.put("wall_memory", std::move(walls.memory), 9);
  out.put("wall_couple", std::move(walls.couple), 3);
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
  planes_.restore(case_, archive, ranks_);
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
  const auto saved_contacts = [&](const std::string& of, int width) {
    const bool couples = archive.contains(of + "_couple");
    return SavedContacts(archive.get<std::int64_t>(of + "_ids", 2), archive.get<double>(of + "_memory", 9),
                         couples ? archive.get<double>(of + "_couple", 3) : std::span<const double>(),
                         shaped ? archive.get<double>(of + "_shape", width) : std::span<const double>());
  };
  const RowsById rows = rows_of_held(system_.particles);
  system_.contacts = pairs_of(saved_contacts("pair", pair_scratch), rows, system_.contacts.remembers_rolling, shaped);
  system_.wall_contacts = walls_of(saved_contacts("wall", wall_scratch), rows, system_.particles, system_.walls.size());
  lists_ = prepare_lists(system_, case_.simulation.skin);
  findings_.fastest2 = fastest_square(system_.particles);
  sampled_step_ = -1;
  settle();
}

}  // namespace scree
