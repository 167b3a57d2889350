#include "scree/particles/reach.h"

#include <algorithm>
#include <cmath>

#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

/// How far a JKR neck may be drawn out [m].
double longest_neck(const ParticleSystem& s, double contact_radius) {
  if (s.laws.cohesion != SC_COHESION_JKR) return 0;
  double longest = 0;
  for (const sc_pair_law& law : s.materials.law)
    longest = std::max(longest, sc_longest_neck(s.laws, law, contact_radius));
  return longest;
}

/// How far apart two shapes may be over how far their overlap is below zero. A gap g makes the growth distance at least
/// 1 + g/(R_A + R_B) with the bounding radii, and the overlap goes with that times the support of both bodies along
/// some direction, which is no less than the sum of the radii of the spheres inside.
double gap_over_overlap(const ParticleSystem& s) {
  double most = 1;
  for (const Form& form : s.forms) most = std::max(most, 1 / form.shape.inscribed);
  return (1 + 1e-9) * most;
}

/// Makes room for all of the particles; returns the sum of their radii [m].
double widen(Sizes& sizes, const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double radius = p.motion.row(i)[lane::radius];
    sum += radius;
    sizes.radius = std::max(sizes.radius, radius);
    sizes.excess = std::max(sizes.excess, p.effect_excess[i]);
    sizes.effect_radius = std::max(sizes.effect_radius, radius + p.effect_excess[i]);
    // Against a wall the effective radius of a sphere is its own.
    sizes.contact_radius = std::max(sizes.contact_radius, radius);
    if (p.shaped())
      sizes.contact_radius = std::max(sizes.contact_radius, sc_largest_contact_radius(p.radius_by_volume(i)));
  }
  return sum;
}

}  // namespace

Sizes sizes_of(const Particles& particles, const Ranks& ranks, const Particles& coming) {
  Sizes own;
  double sum = widen(own, particles);
  std::size_t count = particles.size();
  const double of_coming = widen(own, coming);
  if (ranks.root()) {
    sum += of_coming;
    count += coming.size();
  }
  std::vector<double> largest{own.radius, own.excess, own.effect_radius, own.contact_radius};
  ranks.find_largest(largest);
  Sizes out{largest[0], largest[1], largest[2], largest[3], 0};
  // In whole parts of the largest, so that it is the same sum on every rank.
  constexpr double parts = 1 << 20;
  std::vector<std::int64_t> sums{static_cast<std::int64_t>(count),
                                 out.radius > 0 ? std::llround(sum / out.radius * parts) : 0};
  ranks.add_up(sums);
  if (sums[0] > 0) out.mean_radius = static_cast<double>(sums[1]) / parts * out.radius / static_cast<double>(sums[0]);
  return out;
}

double reach_beyond_bodies(const ParticleSystem& s, const Sizes& sizes) {
  const double overlap =
      s.laws.cohesion == SC_COHESION_LINEAR ? 2 * sizes.excess : longest_neck(s, sizes.contact_radius);
  return s.particles.shaped() ? gap_over_overlap(s) * overlap : overlap;
}

double reach_beyond_effects(const ParticleSystem& s, const Sizes& sizes) {
  const double between_effects = s.laws.cohesion == SC_COHESION_LINEAR ? 2 * sizes.excess : 0;
  return reach_beyond_bodies(s, sizes) - between_effects;
}

double margin_of(const ParticleSystem& s, const Sizes& sizes) {
  return std::max(reach_beyond_bodies(s, sizes), 2 * sizes.excess);
}

}  // namespace scree
