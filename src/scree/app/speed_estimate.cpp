#include "scree/app/speed_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scree/app/build.h"
#include "scree/app/field_samples.h"
#include "scree/app/wall_motion.h"
#include "scree/base/expression.h"
#include "scree/particles/sizes.h"
#include "scree/physics/drag/drag.h"

namespace scree {
namespace {

double length(const Vec3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

FlowSpeeds sampled(const Case& c, const Expression3& text) {
  const std::vector<std::string> names{"x", "y", "z", "t"};
  Expression x(text[0], names), y(text[1], names), z(text[2], names);
  FlowSpeeds speeds;
  double samples = 0;
  for_samples(c, [&](const std::array<double, 4>& at) {
    const double speed = length({x(at), y(at), z(at)});
    if (!std::isfinite(speed)) return;
    speeds.mean += speed;
    speeds.fastest = std::max(speeds.fastest, speed);
    ++samples;
  });
  speeds.mean /= std::max(1.0, samples);
  return speeds;
}

/// The largest weight of a free particle over its mass and g: 1 unless the fluid lifts it.
double strongest_weight(const Case& c, const std::vector<BodyKind>& kinds) {
  if (c.flow.type == "none" || !c.flow.buoyancy) return 1;
  double strongest = 0;
  for (const BodyKind& kind : kinds)
    if (kind.free) strongest = std::max(strongest, std::abs(1 - c.flow.density / kind.density));
  return strongest;
}

/// The axes along which uniform gravity pulls particles round and round.
bool falls_without_end(const Case& c) {
  bool endless = false;
  for (int k = 0; k < 3; ++k) endless = endless || (c.domain.periodic[k] && c.gravity.acceleration[k] != 0);
  return c.gravity.type == "uniform" && endless;
}

/// Twice the energy per mass that a fall through the domain can release [m2/s2].
double fall_energy(const Case& c) {
  Vec3 extent;
  for (int k = 0; k < 3; ++k) extent[k] = c.domain.max[k] - c.domain.min[k];
  if (c.gravity.type == "uniform" || c.gravity.type == "rotating") {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += std::abs(c.gravity.acceleration[k]) * extent[k];
    return 2 * sum;
  }
  if (c.gravity.type == "expression") return 2 * sampled(c, c.gravity.expression).fastest * length(extent);
  if (c.gravity.type != "central") return 0;
  Vec3 nearest{}, farthest{};
  for (int k = 0; k < 3; ++k) {
    const double low = c.domain.min[k] - c.gravity.center[k], high = c.domain.max[k] - c.gravity.center[k];
    nearest[k] = std::max({low, -high, 0.0});
    farthest[k] = std::max(std::abs(low), std::abs(high));
  }
  // From inside the domain the centre itself would give an infinite speed; a tenth of the domain is as close as counts.
  const double near = std::max(length(nearest), 0.1 * length(farthest));
  return 2 * c.gravity.strength * (1 / near - 1 / length(farthest));
}

double rotation_speed(const Case& c) {
  if (c.gravity.type != "rotating") return 0;
  double farthest = 0;
  const Vec3 w = c.gravity.angular_velocity;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 r;
    for (int k = 0; k < 3; ++k) r[k] = (corner >> k & 1 ? c.domain.max[k] : c.domain.min[k]) - c.gravity.center[k];
    farthest =
        std::max(farthest, length({w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]}));
  }
  return farthest;
}

double fastest_at_start(const Case& c, const std::vector<BodyKind>& kinds) {
  double fastest = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i].free && !c.walls.empty()) fastest = std::max(fastest, length(kinds[i].velocity) + kinds[i].spread);
    for (std::size_t j = 0; j <= i; ++j) {
      if ((!kinds[i].free && !kinds[j].free) || (i == j && kinds[i].count < 2)) continue;
      Vec3 relative;
      for (int k = 0; k < 3; ++k) relative[k] = kinds[i].velocity[k] - kinds[j].velocity[k];
      fastest = std::max(fastest, length(relative) + kinds[i].spread + kinds[j].spread);
    }
  }
  return fastest;
}

/// The fastest that a wall of the case gets, and its name.
TopSpeed fastest_wall(const Case& c, const Walls& walls) {
  const auto moves = [](const WallKeys& wall) { return wall.motion.type != "none"; };
  if (std::none_of(c.walls.begin(), c.walls.end(), moves)) return {};
  TopSpeed fastest;
  for (WallMotion& motion : build_wall_motions(c, walls, build_domain(c))) {
    const double speed = fastest_speed(motion, c.simulation.end);
    if (speed > fastest.value) fastest = {speed, "", motion.wall};
  }
  return fastest;
}

/// Speed at which Stokes drag balances the strongest pull on any kind [m/s]; infinite without drag.
double terminal_speed(const Case& c, const std::vector<BodyKind>& kinds, double pull) {
  if (c.flow.drag == "none") return std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const BodyKind& kind : kinds) fastest = std::max(fastest, pull * relaxation_time(c, kind.density, kind.largest));
  return fastest;
}

/// `top` increased by a fall through the domain, and where that comes from.
TopSpeed after_fall(const Case& c, const std::vector<BodyKind>& kinds, const TopSpeed& top) {
  const double weight = strongest_weight(c, kinds), energy = weight * fall_energy(c);
  if (energy == 0) return top;
  double extent2 = 0;
  for (int k = 0; k < 3; ++k) extent2 += std::pow(c.domain.max[k] - c.domain.min[k], 2);
  const double pull =
      c.gravity.type == "uniform" ? weight * length(c.gravity.acceleration) : energy / std::sqrt(extent2);
  const double settling = terminal_speed(c, kinds, pull), fallen = std::sqrt(top.value * top.value + energy);
  const std::string start = top.value > 0 ? fmt::format("{:.4g} m/s from {}, then ", top.value, top.source) : "";
  const bool endless = falls_without_end(c);
  if (top.value + settling < fallen || (endless && std::isfinite(settling)))
    return {top.value + settling, fmt::format("{}sinking at up to {:.4g} m/s, Stokes", start, settling), ""};
  return {fallen, fmt::format("{}a fall through {} without drag", start, endless ? "one period" : "the domain"), ""};
}

}  // namespace

FlowSpeeds flow_speeds(const Case& c) {
  if (c.flow.type == "taylor_green") {
    const double amplitude = std::abs(c.flow.amplitude);
    return {0.7799416 * amplitude, 2 * amplitude};
  }
  if (c.flow.type == "uniform") return {length(c.flow.velocity), length(c.flow.velocity)};
  if (c.flow.type == "expression") return sampled(c, c.flow.expression);
  if (c.flow.type != "shear") return {};
  FlowSpeeds speeds;
  double samples = 0;
  for_samples(c, [&](const std::array<double, 4>& at) {
    const double speed = std::abs(c.flow.shear_rate * (at[1] - c.flow.shear_origin));
    speeds.mean += speed;
    speeds.fastest = std::max(speeds.fastest, speed);
    ++samples;
  });
  speeds.mean /= samples;
  return speeds;
}

double relaxation_time(const Case& c, double density, double diameter) {
  const double mass = density * sphere_volume(diameter);
  return 1 / sc_drag_rate(SC_DRAG_STOKES, 0.0, diameter, 1 / mass, c.flow.density, c.flow.viscosity);
}

TopSpeed top_speed(const Case& c, const std::vector<BodyKind>& kinds, const Walls& walls) {
  if (c.simulation.top_speed) return {*c.simulation.top_speed, "simulation.top_speed", ""};
  TopSpeed top{fastest_at_start(c, kinds), "the start", ""};
  const double flow = c.flow.drag == "none" ? 0.0 : flow_speeds(c).fastest;
  if (flow > top.value) top = {flow, "the fastest flow", ""};
  top = after_fall(c, kinds, top);
  const TopSpeed wall = fastest_wall(c, walls);
  if (wall.value > 0)
    top = {top.value + wall.value,
           fmt::format("walls that move at up to {:.4g} m/s, added to {}", wall.value, top.source), wall.wall};
  const double rotation = rotation_speed(c);
  if (rotation > 0) top = {top.value + rotation, "rotation of the frame, added to " + top.source, top.wall};
  return top;
}

}  // namespace scree
