#include "scree/particles/sample.h"

#include <omp.h>

#include "scree/base/exact_sum.h"
#include "scree/compute/launch.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/touch/sphere_sphere.h"

namespace scree {
namespace {

sc_vec vec_of(const double* p) { return sc_make_vec(p[0], p[1], p[2]); }

sc_contact_state state_of(const Buffer<std::uint8_t>& active, const Buffer<double>& slide, const Buffer<double>& roll,
                          std::size_t c) {
  sc_contact_state s{};
  s.slide = vec_of(&slide[4 * c]);
  s.approach = slide[4 * c + 3];
  s.acted = active[c] & 1;
  s.slid = active[c] >> 1;
  if (!roll.empty()) {
    s.roll = vec_of(&roll[4 * c]);
    s.twist = roll[4 * c + 3];
  }
  return s;
}

sc_touch touch_of_pair(const ParticleSystem& s, std::size_t c) {
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const double *a = s.particles.motion.row(i), *b = s.particles.motion.row(j);
  double d[3];
  for (int k = 0; k < 3; ++k) {
    d[k] = s.domain.nearest(k, b[k] - a[k]);
  }
  const double *sa = s.particles.spin.row(i), *sb = s.particles.spin.row(j);
  sc_sphere_pair p{};
  p.branch = vec_of(d);
  p.radii = a[lane::radius] + b[lane::radius];
  p.velocity = sc_sub(vec_of(a + lane::vx), vec_of(b + lane::vx));
  p.inverse_mass = a[lane::inverse_mass] + b[lane::inverse_mass];
  p.rim_speed = sc_add(vec_of(sa), vec_of(sb));
  p.inverse_radius = sa[lane::inverse_radius] + sb[lane::inverse_radius];
  p.excess = s.particles.effect_excess[i] + s.particles.effect_excess[j];
  return sc_touch_spheres(p).touch;
}

sc_touch touch_of_wall(const ParticleSystem& s, std::size_t p, std::int32_t face) {
  const double* m = s.particles.motion.row(p);
  sc_sphere_wall w{};
  w.position = vec_of(m);
  w.velocity = vec_of(m + lane::vx);
  w.rim_speed = vec_of(s.particles.spin.row(p));
  w.radius = m[lane::radius];
  w.inverse_mass = m[lane::inverse_mass];
  w.excess = s.particles.effect_excess[p];
  return sc_touch_wall(w, s.walls.faces[face], s.walls.pose_of(face)).touch;
}

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
      const double rate = sc_drag_rate(move.drag, sc_norm(slip), 2 * m[lane::radius], m[lane::inverse_mass],
                                       move.fluid_density, move.fluid_viscosity);
      push = sc_add(sc_add_scaled(push, rate, slip), field[i].acceleration);
    }
    sample.force[4 * i] += p.mass[i] * push.x;
    sample.force[4 * i + 1] += p.mass[i] * push.y;
    sample.force[4 * i + 2] += p.mass[i] * push.z;
  });
}

/// Sums what every contact does to its wall.
std::vector<WallLoad> loads_of(const ParticleSystem& s, const Buffer<double>& load) {
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
  std::vector<WallLoad> out(sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b)
    for (int k = 0; k < 3; ++k) {
      out[b].force[k] = sums[b].force[k].value();
      out[b].torque[k] = sums[b].torque[k].value();
    }
  return out;
}

}  // namespace

StoredEnergy stored_energy(const ParticleSystem& s) {
  std::vector<StoredSums> part(omp_get_max_threads());
  const auto& pairs = s.contacts.pairs;
  const Particles& p = s.particles;
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < pairs.count; ++c) {
    if (!s.contacts.active[c]) continue;
    const sc_pair_law& law = s.materials.pair(p.material[pairs.owner[c]], p.material[pairs.partner[c]]);
    part[omp_get_thread_num()].add(sc_contact_energy_of(
        s.laws, law, touch_of_pair(s, c), state_of(s.contacts.active, s.contacts.slide, s.contacts.roll, c)));
  }
  const WallContacts& walls = s.wall_contacts;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::int32_t w = walls.first[i]; w < walls.first[i + 1]; ++w) {
      if (!walls.active[w]) continue;
      const sc_pair_law& law = s.materials.pair(p.material[i], s.walls.faces[walls.wall[w]].material);
      part[0].add(sc_contact_energy_of(s.laws, law, touch_of_wall(s, i, walls.wall[w]),
                                       state_of(walls.active, walls.slide, walls.roll, w)));
    }
  StoredSums all;
  for (const StoredSums& one : part) {
    all.elastic.add(one.elastic);
    all.cohesive.add(one.cohesive);
  }
  return {all.elastic.value(), all.cohesive.value()};
}

void take_sample(const ParticleSystem& system, ContactLists& lists, sc_move move, sc_contact_time time,
                 const sc_field* field, Sample& out) {
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
  out.findings = sweep(lists.kernels, view, lists.plan);
  out.wall_loads = loads_of(out.system, load);
  add_outside_forces(out, move, field);
  out.stored = stored_energy(out.system);
}

}  // namespace scree
