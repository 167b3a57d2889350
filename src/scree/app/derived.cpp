#include "scree/app/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/app/build_materials.h"
#include "scree/app/build_walls.h"
#include "scree/app/encounters.h"
#include "scree/app/memory_need.h"
#include "scree/app/speed_estimate.h"
#include "scree/base/error.h"
#include "scree/data/particles.h"
#include "scree/input/checks.h"
#include "scree/input/located.h"
#include "scree/particles/contacts.h"
#include "scree/physics/contact/collision_time.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;

double extent(const Case& c, int axis) { return c.domain.max[axis] - c.domain.min[axis]; }

double shortest_rayleigh_time(const Case& c, const std::vector<BodyKind>& kinds) {
  double shortest = std::numeric_limits<double>::infinity();
  if (c.contact.laws.normal != SC_NORMAL_HERTZ) return shortest;
  for (const BodyKind& kind : kinds) {
    const MaterialKeys& m = c.materials[kind.material];
    if (!kind.free || !m.young || !m.poisson) continue;
    const double shear = *m.young / (2 * (1 + *m.poisson));
    shortest = std::min(shortest, sc_rayleigh_time(0.5 * kind.smallest, kind.density, shear, *m.poisson));
  }
  return shortest;
}

/// Hard collisions take no time; what counts is that nobody goes far in a step: the centre of a body, and the tip of a
/// thin one.
void derive_hard_step(const Case& c, const std::vector<BodyKind>& kinds, DerivedStep& out) {
  constexpr double tips_go_farther = 5;  // by this factor, over the thickness
  double smallest = std::numeric_limits<double>::infinity(), thinnest = smallest;
  for (const BodyKind& kind : kinds) {
    smallest = std::min(smallest, kind.smallest);
    if (kind.tip > 1) thinnest = std::min(thinnest, kind.thickness / kind.tip);
  }
  if (!std::isfinite(smallest) || out.top_speed == 0) return;
  if (out.automatic) out.time_step = c.hard.travel * std::min(smallest, tips_go_farther * thinnest) / out.top_speed;
  out.travel = out.time_step * out.top_speed / smallest;
  out.tip_travel = out.time_step * out.top_speed / thinnest;
}

/// Words about a place of shapes where less than the reduced mass answers; none for spheres.
std::string beside_the_centre(const Encounter& e, const sc_laws& laws) {
  const double share = (laws.normal == SC_NORMAL_HERTZ ? e.quickest.mass : e.least_mass) / e.mass;
  return share < 0.99 ? fmt::format(", beside the centre, where {:.2g} of the mass answers", share) : "";
}

void derive_soft_step(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds, DerivedStep& out) {
  for (const Encounter& e : encounters(c, materials, kinds)) {
    const double time = contact_time(e, c.contact.laws, out.top_speed);
    if (time < out.contact_time) {
      out.contact_time = time;
      out.shortest = e.what + beside_the_centre(e, c.contact.laws);
    }
    const double damped = longest_damped_step(e, c.contact.laws);
    if (damped < out.damped_step) {
      out.damped_step = damped;
      out.damped = e.what;
    }
    const double overlap = overlap_fraction(e, c.contact.laws, out.top_speed);
    // Of walls alike it is the fastest that is hit so hard.
    if (overlap > out.overlap || (overlap == out.overlap && !e.wall.empty() && e.wall == out.fastest_wall)) {
      out.overlap = overlap;
      out.deepest = e.what;
    }
  }
  out.rayleigh_time = shortest_rayleigh_time(c, kinds);
  if (out.automatic && std::isfinite(out.contact_time))
    out.time_step = std::min(out.contact_time / c.simulation.steps_per_contact, out.damped_step);
  else if (out.automatic && std::isfinite(out.rayleigh_time))
    out.time_step = 0.2 * out.rayleigh_time;
  out.steps_per_contact = out.contact_time / out.time_step;
}

std::vector<DerivedLift> derive_lift(const Case& c, const std::vector<BodyKind>& kinds) {
  std::vector<DerivedLift> out;
  if (c.flow.type == "none" || c.flow.density == 0 || c.gravity.type != "uniform") return out;
  for (const BodyKind& kind : kinds) {
    const std::string& material = c.materials[kind.material].name;
    const auto same = [&](const DerivedLift& l) { return l.material == material; };
    if (kind.free && std::none_of(out.begin(), out.end(), same))
      out.push_back({material, c.flow.density / kind.density});
  }
  return out;
}

/// The length over which the flow changes: the side of a vortex cell of Taylor-Green, else the shortest side of the
/// domain [m].
double flow_length(const Case& c) {
  if (c.flow.type == "taylor_green") return pi / std::abs(c.flow.wavenumber);
  return std::min({extent(c, 0), extent(c, 1), extent(c, 2)});
}

DerivedFluid derive_fluid(const Case& c, const std::vector<BodyKind>& kinds, double top) {
  DerivedFluid out;
  if (c.flow.type == "none" || c.flow.drag == "none") return out;
  const FlowSpeeds flow = flow_speeds(c);
  out.flow_speed = flow.mean;
  const BodyKind* most = nullptr;
  for (const BodyKind& kind : kinds) {
    if (!kind.free) continue;
    if (!most || kind.count > most->count) most = &kind;
    out.relaxation_time = std::min(out.relaxation_time, relaxation_time(c, kind.density, kind.smallest));
    const double fastest = std::max(flow.fastest, top);
    out.reynolds = std::max(out.reynolds, c.flow.density * fastest * kind.largest / c.flow.viscosity);
  }
  if (!most || flow.mean == 0) return out;
  out.stokes_length = flow_length(c);
  out.stokes = relaxation_time(c, most->density, most->typical()) * flow.mean / out.stokes_length;
  return out;
}

std::optional<DerivedCohesion> derive_cohesion(const Case& c, const Materials& materials,
                                               const std::vector<BodyKind>& kinds, double speed) {
  const sc_laws& laws = c.contact.laws;
  const Encounter e = typical_encounter(c, materials, kinds);
  if (laws.cohesion == SC_COHESION_NONE || e.what.empty()) return {};
  DerivedCohesion out;
  out.what = e.what;
  out.mass = e.mass;
  out.restitution = e.restitution;
  out.speed = speed;
  if (laws.cohesion == SC_COHESION_JKR) {
    out.pull_off = pull_off_force(e.law.adhesion, e.radius);
    out.elastic_sticking_speed = elastic_sticking_speed(e.law.adhesion, e.radius, e.law.young, e.mass);
    out.sticking_speed = adhesive_sticking_speed(e.law, e.radius, e.mass);
  } else if (laws.normal != SC_NORMAL_HERTZ) {
    out.stickiness = stickiness_number(cohesive_impact(e, laws), speed);
    out.sticking_speed = sticking_speed(cohesive_impact(e, laws));
  }
  return out;
}

/// Candidates listed per particle, each pair once: centres within 1.3 diameters of each other. What lies at rest under
/// gravity is taken as packed.
double expected_pairs(const Case& c, double solid_fraction) {
  const double packed = c.gravity.type == "none" ? solid_fraction : std::max(0.6, solid_fraction);
  return 4 * packed * 1.3 * 1.3 * 1.3;
}

DerivedCost derive_cost(const Case& c, const std::vector<BodyKind>& kinds, const Walls& walls, double steps) {
  DerivedCost out;
  double volume = 0;
  for (const BodyKind& kind : kinds) {
    out.particles += kind.count;
    volume += kind.volume;
  }
  const double n = static_cast<double>(out.particles);
  out.solid_fraction = volume / (extent(c, 0) * extent(c, 1) * extent(c, 2));
  out.bytes_per_particle = static_cast<double>(bytes_per_particle(c));
  out.bytes_per_pair = static_cast<double>(bytes_per_pair(remembers_rolling(c), has_shapes(c)));
  out.pairs_per_particle = expected_pairs(c, out.solid_fraction);
  out.fluid = fluid_cost(c);
  out.memory = n * (out.bytes_per_particle + out.pairs_per_particle * out.bytes_per_pair) + out.fluid.memory;
  add_output_cost(c, walls, steps, out);
  return out;
}

/// Speed at which a typical impact is judged: that of the flow, which sets particles in motion, else the fastest.
double typical_speed(const DerivedFluid& fluid, const DerivedStep& step) {
  return fluid.flow_speed > 0 && std::isfinite(fluid.relaxation_time) ? fluid.flow_speed : step.top_speed;
}

}  // namespace

DerivedStep derive_step(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds,
                        const Walls& walls) {
  DerivedStep out;
  const TopSpeed top = top_speed(c, kinds, walls);
  out.top_speed = top.value;
  out.top_speed_source = top.source;
  out.fastest_wall = top.wall;
  out.automatic = !c.simulation.time_step;
  if (c.simulation.time_step) out.time_step = *c.simulation.time_step;
  if (is_hard(c))
    derive_hard_step(c, kinds, out);
  else
    derive_soft_step(c, materials, kinds, out);
  out.steps = std::ceil(c.simulation.end / out.time_step * (1 - 1e-12));
  return out;
}

Derived derive(const Case& c) {
  const Materials materials = build_materials(c);
  Derived out;
  out.kinds = body_kinds(c);
  out.walls = build_walls(c, &out.meshes);
  out.step = derive_step(c, materials, out.kinds, out.walls);
  out.fluid = derive_fluid(c, out.kinds, out.step.top_speed);
  out.lift = derive_lift(c, out.kinds);
  out.jumps = periodic_jumps(c);
  out.cohesion = derive_cohesion(c, materials, out.kinds, typical_speed(out.fluid, out.step));
  out.cost = derive_cost(c, out.kinds, out.walls, out.step.steps);
  return out;
}

DerivedStep sound_step(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds,
                       const Walls& walls) {
  DerivedStep step = derive_step(c, materials, kinds, walls);
  if (std::isnan(step.time_step))
    throw InputError(std::string("simulation.time_step: \"auto\" has no ") +
                     (is_hard(c) ? "speed to go by, as nothing moves in this case\n"
                                 : "contact to go by, as no two bodies of this case can meet\n") +
                     "  = help: give simulation.time_step in seconds");
  if (step.steps_per_contact < fewest_steps_per_contact)
    throw InputError(fmt::format(
        "simulation: a time step of {:.4g} s gives {:.3g} steps per contact of {}, fewer than {:g}\n"
        "  = help: use a time step of at most {:.3g} s (25 steps per contact), or \"auto\"",
        step.time_step, step.steps_per_contact, step.shortest, fewest_steps_per_contact, step.contact_time / 25));
  if (!(step.steps <= most_steps))
    throw error_at(c, "simulation.end", too_many_steps(c.simulation.end, step.time_step));
  return step;
}

std::optional<CohesiveImpact> typical_impact(const Case& c, const Materials& materials,
                                             const std::vector<BodyKind>& kinds) {
  if (c.contact.laws.cohesion != SC_COHESION_LINEAR) return {};
  const Encounter e = typical_encounter(c, materials, kinds);
  if (e.what.empty()) return {};
  return cohesive_impact(e, c.contact.laws);
}

}  // namespace scree
