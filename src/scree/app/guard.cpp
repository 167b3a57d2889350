#include "scree/app/guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scree/base/error.h"
#include "scree/particles/contact_state.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

std::string place_of(const Particles& p, std::size_t i) {
  const double* m = p.motion.row(i);
  return fmt::format("particle {} at ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.6g}, {:.6g}, {:.6g}) m/s", p.id[i], m[0],
                     m[1], m[2], m[lane::vx], m[lane::vy], m[lane::vz]);
}

bool is_finite(const Particles& p, std::size_t i) {
  const double* m = p.motion.row(i);
  return std::all_of(m, m + 8, [](double x) { return std::abs(x) < 1e150; });
}

/// What is no number has no sign that means anything.
double shown(double x) { return std::isnan(x) ? std::abs(x) : x; }

/// The axis along which a particle is outside the domain; -1 without one.
int axis_left(const ParticleSystem& s, std::size_t i) {
  for (int k = 0; k < 3; ++k) {
    const double x = s.particles.motion.row(i)[k];
    if (!s.domain.periodic[k] && (x < s.domain.low(k) || x >= s.domain.high(k))) return k;
  }
  return -1;
}

/// The periodic axis along which a particle is outside the domain even after it was wrapped; -1 without one.
int axis_overrun(const ParticleSystem& s, std::size_t i) {
  for (int k = 0; k < 3; ++k) {
    const double x = s.particles.motion.row(i)[k];
    if (s.domain.periodic[k] && !(x >= s.domain.low(k) && x < s.domain.high(k))) return k;
  }
  return -1;
}

/// The row of the lowest id among those of which `is_astray` is true; empty without one.
template <class IsAstray>
std::optional<std::size_t> lowest(const Particles& p, IsAstray&& is_astray) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (is_astray(i) && (!found || p.id[i] < p.id[*found])) found = i;
  return found;
}

std::optional<std::size_t> lowest_unsound(const Particles& p) {
  return lowest(p, [&](std::size_t i) { return !is_finite(p, i); });
}

std::optional<std::size_t> lowest_lost(const ParticleSystem& s) {
  return lowest(s.particles, [&](std::size_t i) { return axis_overrun(s, i) >= 0 || axis_left(s, i) >= 0; });
}

[[noreturn]] void report_unsound(const Particles& p, double time, const std::string& last_seen) {
  if (const auto i = lowest_unsound(p))
    throw PhysicsError(
        fmt::format("t = {:.9g} s: the motion of {} is no longer finite.{} The time step is too long for "
                    "the forces: see `scree check`",
                    time, place_of(p, *i), last_seen));
  throw PhysicsError(fmt::format("t = {:.9g} s: a speed is no longer finite", time));
}

[[noreturn]] void report_lost(const ParticleSystem& s, double time) {
  const auto i = lowest_lost(s);
  if (i && axis_overrun(s, *i) >= 0)
    throw PhysicsError(
        fmt::format("t = {:.9g} s: {} has gone further than a whole period along {} in a step. The time step is too "
                    "long for the forces: see `scree check`",
                    time, place_of(s.particles, *i), "xyz"[axis_overrun(s, *i)]));
  if (i) {
    const int k = axis_left(s, *i);
    throw PhysicsError(
        fmt::format("t = {:.9g} s: {} has left the domain through its {} {} face. Close it with a wall, make it "
                    "an outlet ([[outlets]]), make the axis periodic, or enlarge [domain]",
                    time, place_of(s.particles, *i),
                    s.particles.motion.row(*i)[k] < s.domain.min[k] ? "lower" : "upper", "xyz"[k]));
  }
  throw PhysicsError(fmt::format("t = {:.9g} s: a particle has left the domain", time));
}

/// Bodies that overlap, and by how much of the smaller radius.
struct Overlap {
  double share = -1;
  std::string who;
  std::string reason = "The material is too soft for these speeds, or the time step too long: see `scree check`";
};

Overlap deepest_pair(const ParticleSystem& s) {
  const Particles& p = s.particles;
  Overlap worst;
  std::size_t a = 0, b = 0;
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
    const double share =
        overlap_of_pair(s, c) / std::min(inscribed_radius(p, i, s.forms), inscribed_radius(p, j, s.forms));
    if (share <= worst.share) continue;
    worst.share = share;
    a = static_cast<std::size_t>(i);
    b = static_cast<std::size_t>(j);
  }
  // Who is named first does not depend on who is stored first.
  if (worst.share > 0 && p.id[b] < p.id[a]) std::swap(a, b);
  if (worst.share > 0) worst.who = place_of(p, a) + " and " + place_of(p, b);
  return worst;
}

/// Overlap of a particle with the wall of its contact c, over its radius; negative if they are apart.
double share_of(const ParticleSystem& s, std::size_t particle, std::int32_t c) {
  const std::size_t face = static_cast<std::size_t>(s.wall_contacts.wall[c]);
  const double* m = s.particles.motion.row(particle);
  const sc_vec x = sc_make_vec(m[lane::x], m[lane::y], m[lane::z]);
  if (!s.walls.pose_of(face).present) return -1;
  if (!is_sphere(s.particles, particle)) {
    // As the last pass saw it.
    const double* shape = &s.wall_contacts.shape[wall_memory * std::size_t(c)];
    return s.wall_contacts.active[c] ? shape[wall_scratch + 1] / inscribed_radius(s.particles, particle, s.forms) : -1;
  }
  return 1 - sc_gap_to_wall(s.walls.faces[face], s.walls.pose_of(face), x).distance / m[lane::radius];
}

/// Why a particle is deep in a wall, and what to do: perhaps another wall presses it there.
std::string reason_at_wall(const ParticleSystem& s, std::size_t particle) {
  for (std::int32_t c = s.wall_contacts.first[particle]; c < s.wall_contacts.first[particle + 1]; ++c) {
    if (share_of(s, particle, c) <= 0) continue;
    const std::size_t face = static_cast<std::size_t>(s.wall_contacts.wall[c]);
    const sc_wall_pose& pose = s.walls.pose_of(face);
    if (pose.changed)
      return fmt::format("Wall '{}' appears where the particle is: let it appear (walls.from) at another time or place",
                         s.walls.name_of(face));
    if (pose.moves)
      return fmt::format("Wall '{}' closes on the particle: leave room between walls, or slow it down (walls.motion)",
                         s.walls.name_of(face));
  }
  return Overlap().reason;
}

Overlap deepest_at_wall(const ParticleSystem& s) {
  Overlap worst;
  for (std::size_t i = 0; i + 1 < s.wall_contacts.first.size(); ++i)
    for (std::int32_t c = s.wall_contacts.first[i]; c < s.wall_contacts.first[i + 1]; ++c) {
      const double share = share_of(s, i, c);
      if (share <= worst.share) continue;
      const std::string& name = s.walls.name_of(static_cast<std::size_t>(s.wall_contacts.wall[c]));
      worst = {share, place_of(s.particles, i) + " and wall '" + name + "'", reason_at_wall(s, i)};
    }
  return worst;
}

/// Names the deepest contact there is now, one step after it was noticed. Hard collisions have taken it apart by then.
[[noreturn]] void report_deep(const ParticleSystem& s, double deepest, double limit, double time) {
  const std::string what =
      fmt::format("t = {:.9g} s: an overlap of {:.3g} of the smaller radius exceeds simulation.max_overlap = {:.3g}",
                  time, deepest, limit);
  if (s.vertices && s.hard)
    throw PhysicsError(what +
                       ". Vertices find bodies late that meet between them: set contact.detection = 'certified', or "
                       "take more vertices or another contact.spacing (docs/vertices.md), or a shorter time step");
  if (s.hard)
    throw PhysicsError(what +
                       ". Hard collisions are found late by up to a step, in which fast or thin bodies go deep into "
                       "each other: shorten simulation.time_step, or hard.travel from which it follows");
  const Overlap pair = deepest_pair(s), wall = deepest_at_wall(s);
  const Overlap& worst = wall.share > pair.share ? wall : pair;
  throw PhysicsError(what + ", between " + worst.who + ". " + worst.reason);
}

}  // namespace

void guard_stride(const ParticleSystem& s, double stride, double dt, double time) {
  if (!(stride > 1)) return;
  const Particles& p = s.particles;
  std::size_t worst = 0;
  double longest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double* m = p.motion.row(i);
    const double way = dt * std::hypot(m[lane::vx], m[lane::vy], m[lane::vz]) / m[lane::radius];
    if (way > longest) worst = i;
    longest = std::max(longest, way);
  }
  throw PhysicsError(fmt::format(
      "t = {:.9g} s: a body goes {:.3g} of its radius, or of its smallest half axis, in a step, so that hard "
      "collisions may be missed; the "
      "fastest is {}. Use a shorter simulation.time_step, or a higher simulation.top_speed with \"auto\"",
      time, stride, place_of(p, worst)));
}

void guard_fields(const Particles& particles, const Buffer<sc_field>& field, double time) {
  const auto i = lowest(particles, [&](std::size_t k) { return !sc_is_finite_field(field[k]); });
  if (!i) return;
  const sc_vec &a = field[*i].acceleration, &u = field[*i].fluid;
  // The flow first: where it is no number, its forces are none.
  const bool flows = std::isfinite(u.x + u.y + u.z);
  const sc_vec& bad = flows ? a : u;
  throw PhysicsError(
      fmt::format("t = {:.9g} s: the {} is no finite number, ({}, {}, {}), at {}. Mend the formulas, or keep "
                  "particles away from there",
                  time, flows ? "body force (gravity)" : "velocity of the flow (flow)", shown(bad.x), shown(bad.y),
                  shown(bad.z), place_of(particles, *i)));
}

bool is_sound(const SweepFindings& findings, double max_overlap) {
  return findings.sound && findings.inside && findings.deepest <= max_overlap;
}

std::int64_t first_astray(const ParticleSystem& s, const SweepFindings& findings) {
  const auto row = !findings.sound ? lowest_unsound(s.particles) : lowest_lost(s);
  return row ? s.particles.id[*row] : -1;
}

void guard_step(const ParticleSystem& system, const SweepFindings& findings, double max_overlap, double time,
                const std::string& last_seen) {
  if (is_sound(findings, max_overlap)) return;
  if (!findings.sound) report_unsound(system.particles, time, last_seen);
  if (findings.deepest > max_overlap) report_deep(system, findings.deepest, max_overlap, time);
  report_lost(system, time);
}

}  // namespace scree
