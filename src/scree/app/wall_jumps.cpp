#include "scree/app/wall_jumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/app/build.h"
#include "scree/app/wall_motion.h"

namespace scree {
namespace {

/// A step and how far the wall goes in it.
struct Jump {
  double time = 0, way = 0;
};

/// The step between two instants in which the wall goes farthest, found by halving.
Jump steepest(WallMotion& motion, double from, double to, double dt) {
  while (to - from > dt) {
    const double middle = 0.5 * (from + to);
    const double first = greatest_way(motion, from, middle), second = greatest_way(motion, middle, to);
    (first >= second ? to : from) = middle;
  }
  return {from, greatest_way(motion, from, from + dt)};
}

}  // namespace

std::vector<Remark> remarks_on_jumps(const Case& c, const Walls& walls, double dt, double radius) {
  std::vector<Remark> out;
  if (!(dt > 0) || !(radius > 0)) return out;
  const double end = c.simulation.end;
  const int samples = static_cast<int>(std::clamp(end / dt, 1.0, 2000.0));
  for (WallMotion& motion : build_wall_motions(c, walls, build_domain(c))) {
    Jump worst;
    for (int k = 0; k < samples && motion.kind != WallMotion::Kind::none; ++k) {
      const double from = end * k / samples, to = end * (k + 1) / samples;
      if (greatest_way(motion, from, to) <= std::max(radius, worst.way)) continue;
      const Jump found = steepest(motion, from, to, dt);
      if (found.way > worst.way) worst = found;
    }
    if (worst.way > radius)
      out.push_back(
          {fmt::format("wall '{}'", motion.wall),
           fmt::format("goes {:.3g} m in one step at t = {:.4g} s, more than the smallest radius of {:.3g} m: "
                       "it may pass over particles",
                       worst.way, worst.time, radius),
           "let it move smoothly (walls.motion), or take a shorter time step"});
  }
  return out;
}

}  // namespace scree
