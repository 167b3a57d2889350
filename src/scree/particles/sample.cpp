#include "scree/particles/sample.h"

#include <omp.h>

#include <algorithm>
#include <utility>

#include "scree/base/exact_sum.h"
#include "scree/compute/launch.h"
#include "scree/mpi/together.h"
#include "scree/particles/contact_state.h"
#include "scree/particles/hard/sample.h"
#include "scree/particles/rows.h"

namespace scree {
namespace {

struct StoredSums {
  ExactSum elastic, cohesive;

  void add(const sc_contact_energy& e) {
    elastic.add(e.elastic);
    cohesive.add(e.cohesive);
  }
};

/// Adds body forces and drag to the forces of contacts, at the velocities of the sample.
void add_outside_forces(Sample& sample, const sc_move& move, const sc_field* field) {
  const Particles& p = sample.system.particles;
  launch(p.size(), [&](std::size_t i) {
    const double* m = p.motion.row(i);
    if (m[lane::inverse_mass] == 0) return;
    const sc_vec velocity = vec_of(m + lane::vx);
    sc_vec push = sc_add_scaled(move.gravity, 2, sc_cross(velocity, move.rotation));  // Coriolis: -2 w x v
    if (field) {
      const sc_vec slip = sc_sub(field[i].fluid, velocity);
      const double rate =
          sc_rate_of_drag(move, {vec_of(m), velocity, p.radius_by_volume(i), m[lane::inverse_mass]}, field[i]);
      push = sc_add(sc_add_scaled(push, rate, slip), field[i].acceleration);
    }
    sample.force[4 * i] += p.mass[i] * push.x;
    sample.force[4 * i + 1] += p.mass[i] * push.y;
    sample.force[4 * i + 2] += p.mass[i] * push.z;
    // The fluid that goes with it takes its part of all forces.
    const double own = field && move.drag == SC_DRAG_OF_FIELD ? 1 / (1 + field[i].added_mass) : 1.0;
    for (int k = 0; k < 3; ++k) sample.force[4 * i + k] *= own;
  });
}

/// Sums what every contact does to its wall.
std::vector<WallLoad> loads_of(const ParticleSystem& s, const Buffer<double>& load, const Ranks& ranks) {
  struct Sums {
    std::array<ExactSum, 3> force, torque;
  };
  std::vector<Sums> sums(s.walls.poses.size());
  for (std::size_t w = 0; w < s.wall_contacts.wall.size(); ++w) {
    if (!s.wall_contacts.active[w]) continue;
    Sums& of = sums[s.walls.faces[s.wall_contacts.wall[w]].body];
    for (int k = 0; k < 3; ++k) {
      of.force[k].add(load[8 * w + k]);
      of.torque[k].add(load[8 * w + 4 + k]);
    }
  }
  for (Sums& of : sums) add_up_sums(of, ranks);
  std::vector<WallLoad> out(sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b)
    for (int k = 0; k < 3; ++k) {
      out[b].force[k] = sums[b].force[k].value();
      out[b].torque[k] = sums[b].torque[k].value();
    }
  return out;
}

/// A pass in which no two pairs share a slot, so that the force of each can be read afterwards.
SweepFindings sweep_apart(const ContactLists& lists, SweepView view, Sample& out) {
  const Candidates& pairs = out.system.contacts.pairs;
  SweepPlan plan = lists.plan;
  give_own_slots(pairs, out.system.particles, plan);
  const std::size_t size = slot_size(out.system);
  Buffer<double> slots(size * pairs.count), couples(view.couples ? 4 * pairs.count : 0);
  view.slot = plan.slot.data();
  view.gather_first = plan.gather_first.data();
  view.gather = plan.gather.data();
  view.slots = slots.data();
  Buffer<std::uint8_t> full;
  if (out.system.particles.shaped()) full = no_marks(plan);
  view.shapes.full = full.data();
  if (view.couples) view.couples = couples.data();
  const SweepFindings findings = sweep(lists.kernels, view, plan);
  out.pair_force.resize(4 * pairs.count);
  launch(pairs.count, [&](std::size_t c) { std::copy_n(&slots[size * c], 4, &out.pair_force[4 * c]); });
  return findings;
}

}  // namespace

StoredEnergy stored_energy(const ParticleSystem& s, const Ranks& ranks) {
  std::vector<StoredSums> part(omp_get_max_threads());
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c)
    if (s.contacts.active[c] && counts_here(s, c)) part[omp_get_thread_num()].add(energy_of_pair(s, c));
  const WallContacts& walls = s.wall_contacts;
  for (std::size_t i = 0; i < s.particles.size(); ++i)
    for (std::int32_t w = walls.first[i]; w < walls.first[i + 1]; ++w)
      if (walls.active[w]) part[0].add(energy_of_wall(s, i, w));
  StoredSums all;
  for (const StoredSums& one : part) {
    all.elastic.add(one.elastic);
    all.cohesive.add(one.cohesive);
  }
  add_up_sums(all, ranks);
  return {all.elastic.value(), all.cohesive.value()};
}

void take_sample(const ParticleSystem& system, ContactLists& lists, sc_move move, sc_contact_time time,
                 const sc_field* field, Sample& out) {
  if (system.hard) {
    take_hard_sample(system, lists, time.dt, out);
    out.findings = agree(lists.ranks, out.findings);
    out.wall_loads = loads_of(out.system, out.wall_load, lists.ranks);
    add_outside_forces(out, move, field);
    return;
  }
  out.system = system;
  out.force.resize(4 * system.particles.size());
  // The kick that brings velocities to the time of the positions: none where they are there already.
  move.kick = time.lead;
  move.drift = 0;
  time.kick = time.lead;
  SweepView view = view_of(out.system, lists, move, time, field);
  view.force = out.force.data();
  Buffer<double> load(8 * out.system.wall_contacts.wall.size());
  view.walls.load = load.data();
  out.findings = out.with_contact_forces ? sweep_apart(lists, view, out) : sweep(lists.kernels, view, lists.plan);
  for (const std::int32_t c : lists.counted_elsewhere) out.findings.contacts -= out.system.contacts.active[c] != 0;
  out.findings = agree(lists.ranks, out.findings);
  out.wall_loads = loads_of(out.system, load, lists.ranks);
  if (out.with_contact_forces) out.wall_load = std::move(load);
  add_outside_forces(out, move, field);
  out.stored = stored_energy(out.system, lists.ranks);
}

}  // namespace scree
