// The case file as a whole, and the tables that frame a run.
#include "scree/input/keys.h"

namespace scree {

const Section& case_section() {
  static const Section section = {
      "",
      "the case file",
      "A case: what is simulated, and what is written.",
      {table("simulation", &Case::simulation, simulation_section()), table("domain", &Case::domain, domain_section()),
       table("gravity", &Case::gravity, gravity_section()), table("flow", &Case::flow, flow_section()),
       table("fluid", &Case::fluid, fluid_section()), table("coupling", &Case::coupling, coupling_section()),
       table("heat", &Case::heat, heat_section()), table("contact", &Case::contact, contact_section()),
       table("hard", &Case::hard, hard_section()),
       tables<Case, MaterialKeys>(
           "materials", [](Case & c) -> auto& { return c.materials; }, materials_section()),
       tables<Case, PairKeys>(
           "pairs", [](Case & c) -> auto& { return c.pairs; }, pairs_section()),
       tables<Case, ParticleKeys>(
           "particles", [](Case & c) -> auto& { return c.particles; }, particles_section()),
       tables<Case, WallKeys>(
           "walls", [](Case & c) -> auto& { return c.walls; }, walls_section()),
       tables<Case, OutletKeys>(
           "outlets", [](Case & c) -> auto& { return c.outlets; }, outlets_section()),
       table("output", &Case::output, output_section()), table("ledger", &Case::ledger, ledger_section()),
       table("analysis", &Case::analysis, analysis_section()), table("verify", &Case::verify, verify_section()),
       tables<Case, ExpectKeys>(
           "expect", [](Case & c) -> auto& { return c.verify.expect; }, expect_section())},
      [] { return std::make_shared<Case>(); }};
  return section;
}

const Section& simulation_section() {
  using S = SimulationKeys;
  static const Section section = {
      "simulation",
      "[simulation]",
      "How long and in which steps the particles are followed.",
      {key("title", &S::title, "what the case is about, in words").may_change_at_restart(),
       key("end", &S::end, "simulated time at which the run ends")
           .unit("s")
           .above(0)
           .required()
           .may_change_at_restart(),
       key("time_step", &S::time_step,
           "time step; \"auto\" is the shortest contact time divided by steps_per_contact, less where dashpots are "
           "strong; for hard collisions what hard.travel says")
           .unit("s")
           .above(0)
           .or_word("auto"),
       key("steps_per_contact", &S::steps_per_contact, "time steps in the shortest contact when time_step is \"auto\"")
           .between(1, 1e6),
       key("top_speed", &S::top_speed, "fastest impact that the automatic time step and `scree check` count with")
           .unit("m/s")
           .above(0)
           .defaults_to("estimated from the initial velocities, the flow and the fall height"),
       key("integrator", &S::integrator,
           "leapfrog: kick and drift with drag integrated exactly, second order; explicit, implicit: Euler's velocity "
           "with trapezoidal position, first order, for comparison. Of soft collisions; hard ones have their own")
           .one_of({"leapfrog", "explicit", "implicit"}),
       key("seed", &S::seed, "seed of every random draw; the same seed gives the same particles on any machine"),
       key("max_overlap", &S::max_overlap,
           "overlap at which the run stops, as a fraction of the smaller of the two radii; at a wall of the particle's "
           "radius; of a particle that is no sphere the radius of a sphere inside it counts: the least half axis, less "
           "where exponents are above 1")
           .above(0)
           .at_most(2)
           .may_change_at_restart(),
       key("skin", &S::skin, "margin of the list of neighbours; 0: chosen by the program").unit("m").at_least(0),
       key("exchange_every", &S::exchange_every,
           "steps between two looks for particles that are due to come (insert = 'rate') or have gone into an outlet")
           .between(1, 1e9)},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& domain_section() {
  using S = DomainKeys;
  static const Section section = {"domain",
                                  "[domain]",
                                  "The box that holds the particles. One that leaves it along an axis that is not "
                                  "periodic is lost, and the run stops, unless the face is an outlet.",
                                  {key("min", &S::min, "lower corner").unit("m").required(),
                                   key("max", &S::max, "upper corner").unit("m").required(),
                                   key("periodic", &S::periodic, "whether the box repeats itself along x, y, z")},
                                  [] { return std::make_shared<S>(); }};
  return section;
}

const Section& output_section() {
  using S = OutputKeys;
  static const Section section = {
      "output",
      "[output]",
      "What the run writes, and how often.",
      {key("frames", &S::frames, "time between two frames of particles; 0: only the first and the last")
           .unit("s")
           .at_least(0),
       key("series", &S::series, "time between two rows of series.csv; 0: 200 rows over the run").unit("s").at_least(0),
       key("checkpoints", &S::checkpoints, "time between two checkpoints; 0: only at the end").unit("s").at_least(0),
       key("tracks", &S::tracks, "ids of particles whose motion is written to tracks.csv at every row of the series"),
       key("fields", &S::fields, "particle fields in the frames, besides id and position which are always there")
           .one_of({"id", "position", "velocity", "angular_velocity", "diameter", "mass", "material", "group",
                    "orientation", "half_axes", "exponents", "shape_file", "temperature", "agglomerate",
                    "agglomerate_size", "force", "unwrapped_position", "effect_diameter", "contacts"})
           .defaults_to(
               "velocity, angular_velocity, diameter, mass, material and group; with analysis.agglomerates "
               "also agglomerate and agglomerate_size; with particles that are no spheres also orientation, "
               "half_axes and exponents, with others than superellipsoids also shape_file; with heat also temperature"),
       key("precision", &S::precision,
           "of floating-point numbers in the frames: double, or single with 7 digits and half the size")
           .one_of({"double", "single"}),
       key("compression", &S::compression,
           "of the frames: whole numbers only, which costs nothing; none; everything, fast or as small as it gets")
           .one_of({"whole_numbers", "none", "fast", "small"}),
       key("contacts", &S::contacts, "whether every frame comes with a file of all contacts and their forces")},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const Section& ledger_section() {
  using S = LedgerKeys;
  static const Section section = {
      "ledger",
      "[ledger]",
      "The books of energy and momentum.",
      {key("every", &S::every, "steps between two closures of the books; 0: at every row of the series")
           .may_change_at_restart(),
       key("energy_tolerance", &S::energy_tolerance,
           "closure error of the energy, as a fraction of the turnover, at which the run stops; 0: never")
           .at_least(0)
           .may_change_at_restart(),
       key("omit", &S::omit, "channels left out of the books on purpose, to see that the check bites")
           .one_of({"normal", "sliding", "rolling", "drag", "body", "prescribed", "walls", "relocation", "inserted",
                    "removed", "momentum_impulse", "angular_impulse"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
