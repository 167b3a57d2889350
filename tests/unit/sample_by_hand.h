// Samples made by hand: particles that touch nobody.
#pragma once

#include <vector>

#include "scree/particles/sample.h"
#include "scree/particles/sizes.h"

namespace scree::test {

struct Grain {
  std::array<double, 3> x{}, v{};
  double radius = 0.5;
};

/// Particles of density 1000 with ids in the order given.
inline void set_grains(Particles& p, const std::vector<Grain>& grains) {
  p.resize(grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Grain& g = grains[i];
    p.id[i] = static_cast<std::int64_t>(i);
    p.mass[i] = 1000 * sphere_volume(2 * g.radius);
    double* m = p.motion.row(i);
    for (int k = 0; k < 3; ++k) {
      m[k] = g.x[k];
      m[lane::vx + k] = g.v[k];
    }
    m[lane::radius] = g.radius;
    m[lane::inverse_mass] = 1 / p.mass[i];
  }
}

inline Sample sample_of(const Domain& domain, const std::vector<Grain>& grains) {
  Sample s;
  s.system.domain = domain;
  set_grains(s.system.particles, grains);
  s.system.wall_contacts.first.resize(grains.size() + 1);
  return s;
}

}  // namespace scree::test
