// Saving a simulation, continuing it, and the hash that tells whether two are the same to the last bit.
#include <fmt/format.h>

#include "scree/app/fluid_checkpoint.h"
#include "scree/app/simulation.h"
#include "scree/app/take_over.h"
#include "scree/base/error.h"
#include "scree/particles/keyed_contacts.h"
#include "scree/particles/migration.h"

namespace scree {

std::string Simulation::state_hash() {
  call(Call::hash);
  return hash_share();
}

std::string Simulation::hash_share() { return hash_of(save_share(), clock_.now(), ranks_); }

/// This rank's part of the present state.
StateShare Simulation::share() {
  retrieve();
  // Lists cannot be made of places that are no numbers; whoever is there has not changed since they were made.
  if (!ranks_.alone() && findings_.sound) {
    move_walls(clock_.now());
    refresh_neighbours();
  }
  const Stopwatch watch(stages_, "gathering");
  StateShare out = share_of(system_);
  out.head.set("step", clock_.step);
  out.head.set("time", clock_.now());
  out.head.set("time_step", clock_.dt);
  out.head.set("contact_evaluations", tally_.contacts);
  out.head.set("wall_contact_evaluations", tally_.wall_contacts);
  out.head.set("impacts", tally_.impacts);
  out.head.set("impact_speed", tally_.impact_speed);
  out.head.set("groups", group_names(case_));
  save_forms(system_.forms, out.head);
  exchange_.save(out.head);
  if (heat_)
    out.head.put("heat_books", std::vector<double>{heat_books_.start, heat_books_.from_fluid, heat_books_.from_walls,
                                                   heat_books_.inserted, heat_books_.removed});
  if (coupling_) put_coupling(*coupling_, out.head);
  return out;
}

Archive Simulation::save_share() { return archive_of(share(), ranks_); }

Archive Simulation::save() {
  call(Call::save);
  return save_share();
}

void Simulation::keep() {
  call(Call::keep);
  kept_ = share();
}

Archive Simulation::save_kept() {
  call(Call::save_kept);
  return archive_of(*kept_, ranks_);
}

void Simulation::write(const std::filesystem::path& path, const Archive& archive) {
  call(Call::write);
  write_archive(path, archive, ranks_);
}

void Simulation::restore(const Archive& archive) {
  if (archive.number("time_step") != clock_.dt)
    throw InputError(
        fmt::format("{} was written with time step {} s, the case has {} s: a run continues with its own time "
                    "step",
                    archive.origin, archive.number("time_step"), clock_.dt));
  system_.particles = particles_of(archive, ranks_);
  exchange_.restore(archive);
  planes_.restore(case_, archive, ranks_);
  if (heat_) {
    const std::span<const double> b = archive.get<double>("heat_books");
    heat_books_ = {b[0], b[1], b[2], b[3], b[4]};
  }
  clock_.step = archive.integer("step");
  tally_ = {archive.integer("contact_evaluations"), archive.integer("wall_contact_evaluations"),
            archive.integer("impacts"), archive.integer("impact_speed")};
  system_.forms = forms_of(archive);
  know_shapes(fields_.forces, system_.forms);
  if (system_.vertices) {
    for (std::size_t i = 1; i < system_.forms.size(); ++i) system_.forms[i].shape.is_sphere = 0;
    system_.vertices = make_vertices(system_.forms, system_.vertices->side, system_.vertices->spacing);
  }
  lists_ = prepare_lists(system_, case_.simulation.skin);
  findings_.fastest2 = ranks_.largest(fastest_square(system_.particles));
  sampled_step_ = whole_sampled_step_ = -1;
  ranks_.alone() ? restore_contacts(archive) : settle(archive);
  if (coupling_) restore_coupling(*coupling_, archive);
}

namespace {

/// Contacts of pairs or walls as the archive has them.
SavedContacts contacts_in(const Archive& archive, const std::string& of, std::uint64_t width, bool shaped,
                          const Ranks& ranks) {
  const bool couples = archive.contains(of + "_couple");
  return SavedContacts(archive.part<std::int64_t>(of + "_ids", 2, ranks),
                       archive.part<double>(of + "_memory", 9, ranks),
                       couples ? archive.part<double>(of + "_couple", 3, ranks) : std::span<const double>(),
                       shaped ? archive.part<double>(of + "_shape", width, ranks) : std::span<const double>());
}

KeyedContacts copy_of(const SavedContacts& saved) {
  return {{saved.ids.begin(), saved.ids.end()},
          {saved.memory.begin(), saved.memory.end()},
          {saved.couple.begin(), saved.couple.end()},
          {saved.shape.begin(), saved.shape.end()}};
}

}  // namespace

void Simulation::restore_contacts(const Archive& archive) {
  const bool shaped = system_.particles.shaped();
  const RowsById rows = rows_of_held(system_.particles);
  system_.contacts = pairs_of(contacts_in(archive, "pair", pair_scratch, shaped, ranks_), rows,
                              system_.contacts.remembers_rolling, shaped);
  system_.wall_contacts = walls_of(contacts_in(archive, "wall", wall_scratch, shaped, ranks_), rows, system_.particles,
                                   system_.walls.size());
  settle();
}

std::string Simulation::fluid_hash() const {
  call(Call::fluid_hash);
  return scree::fluid_hash(coupling_->fluid);
}

/// Of several ranks each has read some particles and some contacts; all go where they belong.
void Simulation::settle(const Archive& archive) {
  const bool shaped = system_.particles.shaped();
  Luggage read{copy_of(contacts_in(archive, "pair", pair_scratch, shaped, ranks_)),
               copy_of(contacts_in(archive, "wall", wall_scratch, shaped, ranks_))};
  cut_blocks(ranks_);
  lists_.skin = case_.simulation.skin;  // a first one from the sizes of all follows with the lists
  lists_.luggage = bring_home(system_, read, lists_.blocks, ranks_);
}

}  // namespace scree
