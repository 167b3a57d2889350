#include "scree/app/encounters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/app/build_materials.h"
#include "scree/particles/sizes.h"
#include "scree/physics/contact/collision_time.h"
#include "scree/physics/math.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A body of one size.
struct Body {
  const BodyKind* kind;
  double diameter;

  double inscribed_radius() const { return 0.5 * diameter * kind->inscribed; }
  double inverse_mass() const { return kind->free ? 1 / (kind->density * sphere_volume(diameter)) : 0.0; }
  HitBody hit() const { return {&kind->places, inverse_mass(), 0.5 * diameter}; }
};

std::vector<Body> extremes(const BodyKind& kind) {
  if (kind.smallest == kind.largest) return {{&kind, kind.smallest}};
  return {{&kind, kind.smallest}, {&kind, kind.largest}};
}

std::string named(const Body& b) { return fmt::format("'{}' ({:.4g} m)", b.kind->name, b.diameter); }

Encounter meeting(const Materials& materials, const Body& a, const Body& b) {
  Encounter e;
  e.what = fmt::format("{} with {}", named(a), named(b));
  e.law = materials.pair(a.kind->material, b.kind->material);
  e.restitution = materials.restitution[materials.index(a.kind->material, b.kind->material)];
  e.mass = 1 / (a.inverse_mass() + b.inverse_mass());
  e.radius = 0.5 / (1 / a.diameter + 1 / b.diameter);
  const HitBody first = a.hit(), second = b.hit();
  e.least_mass = least_mass(first, &second);
  e.quickest = quickest_hertz(first, &second);
  e.smaller_radius = std::min(a.inscribed_radius(), b.inscribed_radius());
  e.reach = 0.5 * (a.kind->effect_gap + b.kind->effect_gap);
  return e;
}

Encounter meeting(const Materials& materials, const Body& a, const std::string& wall, int wall_material) {
  Encounter e;
  e.what = fmt::format("{} with wall '{}'", named(a), wall);
  e.wall = wall;
  e.law = materials.pair(a.kind->material, wall_material);
  e.restitution = materials.restitution[materials.index(a.kind->material, wall_material)];
  e.mass = 1 / a.inverse_mass();
  e.radius = 0.5 * a.diameter;
  e.least_mass = least_mass(a.hit(), nullptr);
  e.quickest = quickest_hertz(a.hit(), nullptr);
  e.smaller_radius = a.inscribed_radius();
  e.reach = 0.5 * a.kind->effect_gap;
  return e;
}

}  // namespace

std::vector<Encounter> encounters(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds) {
  std::vector<Encounter> all;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    for (std::size_t j = i; j < kinds.size(); ++j) {
      if ((!kinds[i].free && !kinds[j].free) || (i == j && kinds[i].count < 2)) continue;
      for (const Body& a : extremes(kinds[i]))
        for (const Body& b : extremes(kinds[j]))
          if (i != j || a.diameter <= b.diameter) all.push_back(meeting(materials, a, b));
    }
  for (const BodyKind& kind : kinds)
    for (const WallKeys& wall : c.walls)
      if (kind.free)
        for (const Body& a : extremes(kind))
          all.push_back(meeting(materials, a, wall.name, material_index(c, wall.material)));
  return all;
}

Encounter typical_encounter(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds) {
  const BodyKind* most = nullptr;
  for (const BodyKind& kind : kinds)
    if (kind.free && (!most || kind.count > most->count)) most = &kind;
  if (!most) return {};
  const Body body{most, most->typical()};
  if (most->count > 1) return meeting(materials, body, body);
  for (const BodyKind& other : kinds)
    if (&other != most) return meeting(materials, body, {&other, other.typical()});
  if (c.walls.empty()) return {};
  return meeting(materials, body, c.walls[0].name, material_index(c, c.walls[0].material));
}

double contact_time(const Encounter& e, const sc_laws& laws, double speed) {
  const double adhesion = e.law.adhesion;
  const auto& [mass, curved] = e.quickest;
  if (laws.cohesion == SC_COHESION_JKR && adhesion > 0) {
    const double radius = sc_cbrt(9 * pi * adhesion * curved * curved / (2 * e.law.young));
    const double bond = pi * std::sqrt(mass / (1.2 * e.law.young * radius));
    return speed > 0 ? std::min(bond, sc_hertz_contact_time(mass, speed, e.law.young, curved)) : bond;
  }
  if (laws.normal == SC_NORMAL_HERTZ)
    return speed > 0 ? sc_hertz_contact_time(mass, speed, e.law.young, curved) : infinity;
  return sc_linear_contact_time(e.least_mass, e.law.stiffness, e.law.damping);
}

double longest_damped_step(const Encounter& e, const sc_laws& laws) {
  if (laws.normal == SC_NORMAL_HERTZ || laws.cohesion == SC_COHESION_JKR) return infinity;
  const double zeta = e.law.damping;
  if (zeta <= 0) return infinity;
  // The root of x^2 + 8 zeta x = 1, written without a difference.
  return std::sqrt(e.least_mass / e.law.stiffness) / (4 * zeta + std::sqrt(1 + 16 * zeta * zeta));
}

double overlap_fraction(const Encounter& e, const sc_laws& laws, double speed) {
  if (laws.normal == SC_NORMAL_HERTZ) return sc_hertz_overlap(e.mass, speed, e.law.young, e.radius) / e.smaller_radius;
  const double cohesion = laws.cohesion == SC_COHESION_LINEAR ? e.law.cohesion_stiffness : 0.0;
  const double stiffness = e.law.stiffness - cohesion;
  if (stiffness <= 0) return infinity;
  // m u^2 + k_c L^2 = (k_e - k_c) delta^2 - 2 k_c L delta
  const double shift = cohesion * e.reach / stiffness;
  const double energy = e.mass * speed * speed + cohesion * e.reach * e.reach;
  return (shift + std::sqrt(shift * shift + energy / stiffness)) / e.smaller_radius;
}

CohesiveImpact cohesive_impact(const Encounter& e, const sc_laws& laws) {
  CohesiveImpact impact;
  impact.mass = e.mass;
  impact.stiffness = e.law.stiffness;
  impact.damping = e.law.damping;
  impact.restitution = e.restitution;
  impact.cohesion = e.law.cohesion_stiffness;
  impact.reach = e.reach;
  impact.tension = laws.normal == SC_NORMAL_LINEAR_PLAIN;
  return impact;
}

}  // namespace scree
