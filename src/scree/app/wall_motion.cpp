#include "scree/app/wall_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scree/app/vec3.h"
#include "scree/base/error.h"
#include "scree/physics/math.h"

namespace scree {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

sc_vec unit(sc_vec v) {
  const double length = sc_norm(v);
  return length > 0 ? sc_scale(1 / length, v) : sc_make_vec(0, 0, 1);
}

WallMotion::Kind kind_of(const std::string& word) {
  using Kind = WallMotion::Kind;
  if (word == "velocity") return Kind::velocity;
  if (word == "rotation") return Kind::rotation;
  if (word == "oscillation") return Kind::oscillation;
  if (word == "expression") return Kind::expression;
  return word == "surface" ? Kind::surface : Kind::none;
}

/// Displacement and angle from home.
struct Way {
  sc_vec displacement;
  double angle;
};

/// Time that the motion has gone on for.
double time_of(const WallMotion& m, double time) { return std::clamp(time, m.start, m.stop) - m.start; }

Way way_at(WallMotion& m, double time) {
  using Kind = WallMotion::Kind;
  const double t = time_of(m, time);
  switch (m.kind) {
    case Kind::velocity:
      return {sc_scale(t, m.velocity), 0};
    case Kind::rotation:
      return {sc_zero_vec(), m.rate * t};
    case Kind::oscillation:
      return {sc_scale(sc_sin(m.rate * t + m.phase) - sc_sin(m.phase), m.amplitude), 0};
    case Kind::expression: {
      const double at[1] = {t};
      return {sc_make_vec(m.formulas[0](at), m.formulas[1](at), m.formulas[2](at)), m.formulas[3](at)};
    }
    default:
      return {sc_zero_vec(), 0};
  }
}

/// Velocity of the pivot and of the turning.
struct Rates {
  sc_vec velocity;
  sc_vec spin;
};

Rates rates_between(WallMotion& m, double from, double to) {
  const Way a = way_at(m, from), b = way_at(m, to);
  const double per = 1 / (to - from);
  return {sc_scale(per, sc_sub(b.displacement, a.displacement)), sc_scale(per * (b.angle - a.angle), m.axis)};
}

Rates rates_at(WallMotion& m, double time, double dt) {
  using Kind = WallMotion::Kind;
  if (m.kind == Kind::expression) return rates_between(m, time - 0.5 * dt, time + 0.5 * dt);
  const Rates rest{sc_zero_vec(), sc_zero_vec()};
  if (time < m.start || time >= m.stop) return rest;
  const double phase = m.rate * time_of(m, time) + m.phase;
  switch (m.kind) {
    case Kind::velocity:
      return {m.velocity, sc_zero_vec()};
    case Kind::rotation:
      return {sc_zero_vec(), sc_scale(m.rate, m.axis)};
    case Kind::oscillation:
      return {sc_scale(m.rate * sc_cos(phase), m.amplitude), sc_zero_vec()};
    default:
      return rest;
  }
}

bool present(const WallMotion& m, double time) { return time >= m.from && time < m.until; }

/// Whether turning leaves a face as it is: round ones about the axis, and planes across it.
bool keeps_shape(const WallMotion& m, const sc_wall& face) {
  const bool along = sc_norm(sc_cross(face.b, m.axis)) <= 1e-12;
  if (face.kind == SC_WALL_PLANE) return along;
  const double away = sc_norm(sc_reject(sc_sub(face.a, m.pivot), m.axis));
  return face.kind == SC_WALL_FRUSTUM && along && away <= 1e-12 * std::max(face.start_radius, face.end_radius);
}

/// Farthest point of a face from the axis of rotation [m].
double distance_from_axis(const WallMotion& m, const sc_wall& face) {
  const auto off = [&](sc_vec x) { return sc_norm(sc_reject(sc_sub(x, m.pivot), m.axis)); };
  if (face.kind == SC_WALL_PLANE) return forever;
  if (face.kind == SC_WALL_TRIANGLE) return std::max({off(face.a), off(face.b), off(face.c)});
  if (face.kind == SC_WALL_PLATE) {
    const sc_vec p = sc_add(face.a, face.b), q = sc_add(face.a, face.c);
    return std::max({off(face.a), off(p), off(q), off(sc_add(p, face.c))});
  }
  if (face.kind == SC_WALL_FRUSTUM) {
    const sc_vec end = sc_add_scaled(face.a, face.length, face.b);
    return std::max(off(face.a), off(end)) + std::max(face.start_radius, face.end_radius);
  }
  double farthest = 0;
  for (int k = 0; k < 8; ++k)
    farthest = std::max(farthest, off(sc_make_vec(k & 1 ? face.b.x : face.a.x, k & 2 ? face.b.y : face.a.y,
                                                  k & 4 ? face.b.z : face.a.z)));
  return farthest;
}

/// Particles are in the domain, so parts farther away do not matter.
double distance_from_axis(const WallMotion& m, const Domain& domain) {
  double farthest = 0;
  for (int k = 0; k < 8; ++k) {
    const sc_vec x = sc_make_vec(k & 1 ? domain.max[0] : domain.min[0], k & 2 ? domain.max[1] : domain.min[1],
                                 k & 4 ? domain.max[2] : domain.min[2]);
    farthest = std::max(farthest, sc_norm(sc_reject(sc_sub(x, m.pivot), m.axis)));
  }
  return farthest;
}

WallMotion motion_of(const WallKeys& wall) {
  const MotionKeys& keys = wall.motion;
  WallMotion m;
  m.wall = wall.name;
  m.kind = kind_of(keys.type);
  m.velocity = vec_of(keys.velocity);
  m.amplitude = vec_of(keys.amplitude);
  m.pivot = vec_of(keys.point);
  m.axis = unit(vec_of(keys.axis));
  m.rate = m.kind == WallMotion::Kind::oscillation ? 2 * std::numbers::pi * keys.frequency : keys.angular_velocity;
  m.phase = keys.phase;
  if (m.kind == WallMotion::Kind::expression)
    for (const std::string& text : {keys.displacement[0], keys.displacement[1], keys.displacement[2], keys.angle})
      m.formulas.emplace_back(text, std::vector<std::string>{"t"});
  m.start = keys.start;
  m.stop = keys.stop.value_or(forever);
  m.from = wall.from;
  m.until = wall.until.value_or(forever);
  return m;
}

}  // namespace

std::vector<WallMotion> build_wall_motions(const Case& c, const Walls& walls, const Domain& domain) {
  std::vector<WallMotion> out;
  for (const WallKeys& wall : c.walls) out.push_back(motion_of(wall));
  for (const sc_wall& face : walls.faces) {
    WallMotion& m = out[face.body];
    const double distance = std::min(distance_from_axis(m, face), distance_from_axis(m, domain));
    m.reach = std::max(m.reach, distance);
    if (!keeps_shape(m, face)) m.extent = std::max(m.extent, distance);
  }
  return out;
}

namespace {

void require_finite(const WallMotion& m, const sc_wall_pose& pose, const Way& way, double time) {
  const double way_and_rates = sc_norm(way.displacement) + way.angle + sc_norm(pose.velocity) + sc_norm(pose.spin) +
                               sc_norm(pose.velocity_now) + sc_norm(pose.spin_now);
  if (std::isfinite(way_and_rates)) return;
  throw PhysicsError(fmt::format(
      "t = {:.9g} s: the motion of wall '{}' is no finite number any more (displacement ({}, {}, {}) m, angle "
      "{} rad). Mend the formulas of its walls.motion, or end it before (motion.stop)",
      time, m.wall, way.displacement.x, way.displacement.y, way.displacement.z, way.angle));
}

}  // namespace

sc_wall_pose pose_at(WallMotion& m, double time, double lag, double dt) {
  sc_wall_pose pose = sc_wall_at_home();
  pose.pivot = pose.place = m.pivot;
  pose.present = present(m, time);
  pose.changed = time > 0 && pose.present != present(m, time - dt);
  if (m.kind == WallMotion::Kind::none) return pose;
  pose.moves = 1;
  const Way way = way_at(m, time);
  pose.place = sc_add(m.pivot, way.displacement);
  pose.turn = sc_rotation(m.axis, sc_cos(way.angle), sc_sin(way.angle));
  // Without a step there is no velocity to ask for.
  const Rates rest{sc_zero_vec(), sc_zero_vec()};
  const Rates then = dt > 0 ? rates_at(m, time - lag, dt) : rest, now = dt > 0 ? rates_at(m, time, dt) : rest;
  pose.velocity = then.velocity;
  pose.spin = then.spin;
  pose.velocity_now = now.velocity;
  pose.spin_now = now.spin;
  const bool slips = m.kind == WallMotion::Kind::surface && time >= m.start && time < m.stop;
  if (slips) pose.slip = m.velocity;
  if (m.kind == WallMotion::Kind::expression) require_finite(m, pose, way, time);
  return pose;
}

double fastest_speed(WallMotion& m, double end) {
  using Kind = WallMotion::Kind;
  const double last = std::min(end, m.stop);
  if (m.kind == Kind::none || last <= m.start) return 0;
  if (m.kind == Kind::surface || m.kind == Kind::velocity) return sc_norm(m.velocity);
  if (m.kind == Kind::oscillation) return m.rate * sc_norm(m.amplitude);
  if (m.kind == Kind::rotation) return std::abs(m.rate) * m.reach;
  constexpr int samples = 1000;
  double fastest = 0;
  for (int k = 0; k < samples; ++k) {
    const double from = m.start + (last - m.start) * k / samples, to = m.start + (last - m.start) * (k + 1) / samples;
    const Rates r = rates_between(m, from, to);
    fastest = std::max(fastest, sc_norm(r.velocity) + m.reach * sc_norm(r.spin));
  }
  return fastest;
}

double greatest_way(WallMotion& m, double from, double to) {
  if (m.kind == WallMotion::Kind::none) return 0;
  const Way a = way_at(m, from), b = way_at(m, to);
  return sc_norm(sc_sub(b.displacement, a.displacement)) + m.extent * std::abs(b.angle - a.angle);
}

}  // namespace scree
