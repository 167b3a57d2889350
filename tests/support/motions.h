// Where the particles of a run are and how they move, and how far two runs are apart.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "unit/engine_cases.h"

namespace scree::test {

/// Place, velocity and rim speed of a particle.
using Motion = std::array<double, 9>;
enum : std::size_t { place = 0, velocity = 3, rim = 6 };

/// Of all particles, by id.
inline std::vector<Motion> motions(Simulation& s) {
  const Particles& p = s.whole().particles;
  std::vector<Motion> out;
  for (const std::uint32_t i : order_by_id(p)) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i);
    out.push_back(
        {m[lane::x], m[lane::y], m[lane::z], m[lane::vx], m[lane::vy], m[lane::vz], spin[0], spin[1], spin[2]});
  }
  return out;
}

/// Lengths of the differences of three numbers: the largest, and the root of the mean square.
struct Apart {
  double most = 0, mean = 0;
};

inline Apart apart(const std::vector<Motion>& a, const std::vector<Motion>& b, std::size_t what) {
  Apart out;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d =
        std::hypot(a[i][what] - b[i][what], a[i][what + 1] - b[i][what + 1], a[i][what + 2] - b[i][what + 2]);
    out.most = std::max(out.most, d);
    sum += d * d;
  }
  out.mean = std::sqrt(sum / static_cast<double>(a.size()));
  return out;
}

}  // namespace scree::test
