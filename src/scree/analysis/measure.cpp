#include "scree/analysis/measure.h"

#include <cmath>

#include "scree/base/exact_sum.h"
#include "scree/mpi/together.h"
#include "scree/particles/holdings.h"

namespace scree {
namespace {

void add(ExactVectorSum& sum, sc_vec v) { sum.add(v.x, v.y, v.z); }

struct Sums {
  ExactSum kinetic, rotational, scale, free_mass;
  ExactSum loss[4], work[4];  // by lane, as the particles keep them
  ExactVectorSum momentum, impulse, angular, angular_impulse;

  /// The accounts of those that are gone.
  void add_gone(const Passage& passage) {
    impulse.add(passage.impulse);
    angular_impulse.add(passage.angular_impulse);
    for (int k = 0; k < 4; ++k) {
      loss[k].add(passage.loss[k]);
      work[k].add(passage.work[k]);
    }
  }

  void add_particle(const Sample& sample, const Fields& fields, std::size_t i) {
    const Particles& p = sample.system.particles;
    for (int k = 0; k < 4; ++k) {
      loss[k].add(p.loss.row(i)[k]);
      work[k].add(p.work.row(i)[k]);
    }
    add(impulse, vec_of(p.impulse.row(i)));
    add(angular_impulse, vec_of(p.angular_impulse.row(i)));
    if (p.motion.row(i)[lane::inverse_mass] == 0) return;
    const Holdings h = holdings_of(p, i);
    kinetic.add(h.kinetic);
    rotational.add(h.rotational);
    scale.add(p.mass[i] * sc_norm(vec_of(p.motion.row(i) + lane::vx)));
    free_mass.add(p.mass[i]);
    add(momentum, h.momentum);
    add(angular, h.angular_momentum);
    work[1].add(gravity_work(p, sample.system.domain, fields.uniform, i));
  }
};

}  // namespace

Measured measure(const Sample& sample, const Fields& fields, double time, const Passage& passage, const Ranks& ranks) {
  Sums s;
  for (std::size_t i = 0; i < sample.system.particles.size(); ++i) s.add_particle(sample, fields, i);
  add_up_sums(s, ranks);
  s.add_gone(passage);
  // Impulse of uniform gravity.
  add(s.impulse, sc_scale(s.free_mass.value() * time, fields.uniform));
  Measured out;
  out.kinetic = s.kinetic.value();
  out.rotational = s.rotational.value();
  out.elastic = sample.stored.elastic;
  out.cohesive = sample.stored.cohesive;
  out.drag_work = s.work[0].value();
  out.body_work = s.work[1].value();
  out.prescribed_work = s.work[2].value();
  out.wall_work = s.work[3].value();
  out.dissipated_normal = s.loss[0].value();
  out.dissipated_sliding = s.loss[1].value();
  out.dissipated_rolling = s.loss[2].value();
  out.relocation_work = 0.0 - s.loss[3].value();
  out.inserted = passage.inserted.energy.value();
  out.removed = passage.removed.energy.value();
  out.momentum = s.momentum.value();
  out.impulse = s.impulse.value();
  out.inserted_momentum = passage.inserted.momentum.value();
  out.removed_momentum = passage.removed.momentum.value();
  out.angular_momentum = s.angular.value();
  out.angular_impulse = s.angular_impulse.value();
  out.inserted_angular_momentum = passage.inserted.angular_momentum.value();
  out.removed_angular_momentum = passage.removed.angular_momentum.value();
  out.momentum_scale = s.scale.value();
  return out;
}

Speeds measure_speeds(const Sample& sample, const Ranks& ranks) {
  const Particles& p = sample.system.particles;
  Speeds out;
  ExactSum sum;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.motion.row(i)[lane::inverse_mass] == 0) continue;
    const double speed = sc_norm(vec_of(p.motion.row(i) + lane::vx));
    out.largest = std::max(out.largest, speed);
    sum.add(speed);
    ++count;
  }
  add_up_sums(sum, ranks);
  out.largest = ranks.largest(out.largest);
  count = ranks.total(count);
  if (count) out.mean = sum.value() / static_cast<double>(count);
  return out;
}

std::vector<Bond> bonds_of(const ParticleSystem& system) {
  std::vector<Bond> bonds;
  const auto& pairs = system.contacts.pairs;
  for (std::size_t c = 0; c < pairs.count; ++c)
    if (system.contacts.active[c]) bonds.push_back({pairs.owner[c], pairs.partner[c]});
  return bonds;
}

std::vector<std::int32_t> count_contacts(const ParticleSystem& s) {
  std::vector<std::int32_t> count(s.particles.held(), 0);
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (!s.contacts.active[c]) continue;
    ++count[s.contacts.pairs.owner[c]];
    ++count[s.contacts.pairs.partner[c]];
  }
  for (std::size_t p = 0; p + 1 < s.wall_contacts.first.size(); ++p)
    for (std::int32_t w = s.wall_contacts.first[p]; w < s.wall_contacts.first[p + 1]; ++w)
      count[p] += s.wall_contacts.active[w] != 0;
  count.resize(s.particles.size());
  return count;
}

}  // namespace scree
