// A flow that is solved for.
#include <fmt/format.h>

#include "scree/input/keys.h"

namespace scree {
namespace {

Section segments_of(const char* axis) {
  using S = FluidSegmentKeys;
  return {
      fmt::format("fluid.{}", axis),
      fmt::format("[[fluid.{}]]", axis),
      fmt::format("A piece of the grid along {}; the next one begins where it ends, the last one ends with the domain. "
                  "In place of cells, for this axis.",
                  axis),
      {key("to", &S::to, "where the piece ends").unit("m").required(),
       key("cells", &S::cells, "how many cells it has").between(1, 1e6).required(),
       key("ratio", &S::ratio,
           "width of its last cell over that of its first; between them widths grow by equal factors")
           .between(1e-3, 1e3)},
      [] { return std::make_shared<S>(); }};
}

const Section& x_section() {
  static const Section section = segments_of("x");
  return section;
}

const Section& y_section() {
  static const Section section = segments_of("y");
  return section;
}

const Section& z_section() {
  static const Section section = segments_of("z");
  return section;
}

const Section& blocks_section() {
  using S = FluidBoxKeys;
  static const Section section = {"fluid.blocks",
                                  "[[fluid.blocks]]",
                                  "A box of fluid. Blocks lie side by side in one grid and together make the region of "
                                  "the flow, an L-shaped channel "
                                  "say; without any it is the whole domain.",
                                  {key("name", &S::name, "name in messages, and for patches")
                                       .is_a(TextKind::name)
                                       .defaults_to("block0, block1, ..."),
                                   key("min", &S::min, "lower corner, on faces of the grid").unit("m").required(),
                                   key("max", &S::max, "upper corner, on faces of the grid").unit("m").required()},
                                  [] { return std::make_shared<S>(); }};
  return section;
}

const Section& obstacles_section() {
  using S = FluidBoxKeys;
  static const Section section = {
      "fluid.obstacles",
      "[[fluid.obstacles]]",
      "A box in the flow that is no fluid. Its surface is a wall at rest unless patches say otherwise.",
      {key("name", &S::name, "name in messages, and for patches")
           .is_a(TextKind::name)
           .defaults_to("obstacle0, obstacle1, ..."),
       key("min", &S::min, "lower corner, on faces of the grid").unit("m").required(),
       key("max", &S::max, "upper corner, on faces of the grid").unit("m").required()},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& patches_section() {
  using S = FluidPatchKeys;
  static const Section section = {
      "fluid.patches",
      "[[fluid.patches]]",
      "A face of the domain, of a block or of an obstacle, or a part of it, and what it does to the fluid. What no "
      "patch "
      "covers is a wall at rest. The series has its flow rate out of the fluid, NAME_flow, and the force of the fluid "
      "on it, NAME_force_x, _y, _z.",
      {key("name", &S::name, "name in messages and results").is_a(TextKind::name).defaults_to("patch0, patch1, ..."),
       key("face", &S::face, "which face; of an obstacle, x_min is its own face towards smaller x")
           .one_of({"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"})
           .required(),
       key("of", &S::of, "the block or obstacle whose face it is").defaults_to("the domain"),
       key("min", &S::min, "lower corner of the part of the face: cells count whose middle is inside")
           .unit("m")
           .defaults_to("the whole face"),
       key("max", &S::max, "upper corner of the part").unit("m").defaults_to("the whole face"),
       key("type", &S::type,
           "wall: the fluid moves with it; slip, symmetry: it passes along without friction; inlet: it passes with a "
           "given velocity, in or out; outlet: it passes at a given pressure; permeable: a porous plate, as under a "
           "fluidised bed: it passes straight through as the pressures on both sides drive it")
           .one_of({"wall", "slip", "symmetry", "inlet", "outlet", "permeable"}),
       key("velocity", &S::velocity, "of the wall, or of the fluid in the inlet")
           .unit("m/s")
           .only_with("type", {"wall", "inlet"}),
       key("pressure", &S::pressure, "of the outlet, or beyond the plate: a formula of x, y, z and t")
           .is_a(TextKind::formula)
           .unit("Pa")
           .only_with("type", {"outlet", "permeable"}),
       key("resistance", &S::resistance,
           "of the plate: how much pressure a speed takes, the volume that passes over area and time")
           .unit("Pa s/m")
           .at_least(0)
           .only_with("type", {"permeable"}),
       key("quadratic_resistance", &S::quadratic_resistance, "of the plate: how much the square of that speed takes")
           .unit("Pa s2/m2")
           .at_least(0)
           .only_with("type", {"permeable"}),
       key("temperature", &S::temperature,
           "with [fluid.heat]: of the wall, of what comes in through the inlet, or of what comes back through the "
           "outlet: a formula of x, y, z and t")
           .is_a(TextKind::formula)
           .unit("K")
           .defaults_to("no heat through walls; what comes back through outlets is as warm as the fluid there")
           .only_with("type", {"wall", "slip", "inlet", "outlet", "permeable"}),
       key("heat_flux", &S::heat_flux, "with [fluid.heat]: that a wall gives to the fluid: a formula of x, y, z and t")
           .is_a(TextKind::formula)
           .unit("W/m2")
           .defaults_to("none")
           .only_with("type", {"wall", "slip"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& probes_section() {
  using S = FluidProbeKeys;
  static const Section section = {
      "fluid.probes",
      "[[fluid.probes]]",
      "Places at which the series has velocity and pressure, linear between the middles of cells: columns NAME_u_x, "
      "NAME_u_y, NAME_u_z, NAME_p; of several points NAME0_u_x and so on.",
      {key("name", &S::name, "name of its columns").is_a(TextKind::name).defaults_to("probe0, probe1, ..."),
       key("points", &S::points, "the places").unit("m").required()},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const Section& lines_section() {
  using S = FluidLineKeys;
  static const Section section = {
      "fluid.lines",
      "[[fluid.lines]]",
      "A straight line along which velocity and pressure go into a table of their own, lines/NAME.csv.",
      {key("name", &S::name, "name of its table").is_a(TextKind::name).defaults_to("line0, line1, ..."),
       key("from", &S::from, "where it begins").unit("m").required(),
       key("to", &S::to, "where it ends").unit("m").required(),
       key("points", &S::points, "how many places on it, both ends among them").between(2, 1e6),
       key("every", &S::every, "time between two samples").unit("s").above(0).defaults_to("as the series")},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const Section& fluid_averages_section() {
  using S = FluidAverageKeys;
  static const Section section = {
      "fluid.averages",
      "[fluid.averages]",
      "Means over time, and what fluctuates about them: more fields of the frames, see docs/files.md.",
      {key("from", &S::from, "when they begin").unit("s").at_least(0).defaults_to("no averages"),
       key("every", &S::every, "how many steps from one sample to the next").between(1, 1e6)},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& reference_section() {
  using S = FluidReferenceKeys;
  static const Section section = {
      "fluid.reference",
      "[fluid.reference]",
      "A solution with which the fluid is compared: columns error_velocity, error_velocity_rms, error_pressure_rms of "
      "the series. The mean of the pressure does not count where no outlet gives it.",
      {key("type", &S::type, "formulas: of x, y, z and t").one_of({"none", "formulas"}),
       key("velocity", &S::velocity, "the velocity").unit("m/s").required().only_with("type", {"formulas"}),
       key("pressure", &S::pressure, "the pressure").is_a(TextKind::formula).unit("Pa").only_with("type", {"formulas"}),
       key("temperature", &S::temperature, "the temperature: columns error_temperature, error_temperature_rms")
           .is_a(TextKind::formula)
           .unit("K")
           .defaults_to("not compared")
           .only_with("type", {"formulas"})},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const std::vector<std::string> solved = {"incompressible"};

std::vector<Key> grid_keys() {
  using S = FluidKeys;
  return {key("cells", &S::cells, "of an even grid over the domain: along x, y, z")
              .defaults_to("segments of every axis")
              .only_with("type", solved),
          tables<S, FluidSegmentKeys>(
              "x", [](S & s) -> auto& { return s.x; }, x_section())
              .only_with("type", solved),
          tables<S, FluidSegmentKeys>(
              "y", [](S & s) -> auto& { return s.y; }, y_section())
              .only_with("type", solved),
          tables<S, FluidSegmentKeys>(
              "z", [](S & s) -> auto& { return s.z; }, z_section())
              .only_with("type", solved),
          tables<S, FluidBoxKeys>(
              "blocks", [](S & s) -> auto& { return s.blocks; }, blocks_section())
              .only_with("type", solved),
          tables<S, FluidBoxKeys>(
              "obstacles", [](S & s) -> auto& { return s.obstacles; }, obstacles_section())
              .only_with("type", solved),
          tables<S, FluidPatchKeys>(
              "patches", [](S & s) -> auto& { return s.patches; }, patches_section())
              .only_with("type", solved),
          table("heat", &S::heat, fluid_heat_section()).only_with("type", solved),
          tables<S, FluidScalarKeys>(
              "scalars", [](S & s) -> auto& { return s.scalars; }, fluid_scalars_section())
              .only_with("type", solved),
          table("turbulence", &S::turbulence, fluid_turbulence_section()).only_with("type", solved)};
}

std::vector<Key> flow_keys() {
  using S = FluidKeys;
  return {
      key("velocity", &S::velocity, "at the start").unit("m/s").only_with("type", solved),
      key("force", &S::force, "on the fluid, per volume, beside gravity").unit("N/m3").only_with("type", solved),
      key("void_fraction", &S::void_fraction,
          "fraction of the volume that is fluid, where something else is in it: a formula of x, y, z and t")
          .is_a(TextKind::formula)
          .only_with("type", solved),
      key("model", &S::model,
          "which momentum equation. a: gradient of the pressure and friction act on what else is in the fluid, too; "
          "b: on the fluid alone, and all forces on it are divided by the void fraction. Equal where a uniform flow "
          "is steady")
          .one_of({"a", "b"})
          .only_with("type", solved),
      key("drag", &S::drag,
          "K of the drag of what is in the flow: it acts on the fluid with K (drag_velocity - velocity) per volume")
          .is_a(TextKind::formula)
          .unit("kg/(m3 s)")
          .only_with("type", solved),
      key("drag_velocity", &S::drag_velocity, "of what is in the flow").unit("m/s").only_with("type", solved)};
}

std::vector<Key> method_keys() {
  using S = FluidKeys;
  return {
      key("convection", &S::convection,
          "what a face carries. central: linear between two cells; symmetric: their mean, which keeps the energy on "
          "any grid; upwind: first order; van_leer, superbee: limited slopes (TVD); quick: a parabola")
          .one_of({"central", "symmetric", "upwind", "van_leer", "superbee", "quick"})
          .only_with("type", solved),
      key("time_step", &S::time_step, "time step; \"auto\" follows courant")
          .unit("s")
          .above(0)
          .or_word("auto")
          .only_with("type", solved),
      key("courant", &S::courant,
          "of an automatic time step: the part of a cell's fluid that flows through it in a step, at most")
          .above(0)
          .at_most(1)
          .only_with("type", solved),
      key("longest_step", &S::longest_step, "of an automatic time step, whatever the flow")
          .unit("s")
          .above(0)
          .defaults_to("a hundredth of the run")
          .only_with("type", solved),
      key("correctors", &S::correctors,
          "how often a step is solved, each time with what the last one found; two are better where the void "
          "fraction changes in time")
          .between(1, 20)
          .only_with("type", solved),
      key("divergence_tolerance", &S::divergence_tolerance,
          "error of the volume of a cell that a step may make, over its volume")
          .above(0)
          .below(1)
          .only_with("type", solved),
      key("viscous_tolerance", &S::viscous_tolerance, "by which the error of the viscous solve falls")
          .above(0)
          .below(1)
          .only_with("type", solved),
      key("pressure_solver", &S::pressure_solver,
          "multigrid: conjugate gradients with hypre's PFMG; bicgstab: a plain solver, for comparison")
          .one_of({"multigrid", "bicgstab"})
          .only_with("type", solved),
      key("steady", &S::steady,
          "ends the run when the velocity changes by less than this part of the highest speed while the flow passes "
          "a cell; 0: never")
          .at_least(0)
          .only_with("type", solved)
          .may_change_at_restart(),
      tables<S, FluidProbeKeys>(
          "probes", [](S & s) -> auto& { return s.probes; }, probes_section())
          .only_with("type", solved),
      tables<S, FluidLineKeys>(
          "lines", [](S & s) -> auto& { return s.lines; }, lines_section())
          .only_with("type", solved),
      table("averages", &S::averages, fluid_averages_section()).only_with("type", solved),
      table("reference", &S::reference, reference_section()).only_with("type", solved)};
}

}  // namespace

const Section& fluid_section() {
  using S = FluidKeys;
  static const Section section = [] {
    Section s = {
        "fluid",
        "[fluid]",
        "A fluid whose flow is solved for, on a rectilinear grid over the domain.",
        {key("type", &S::type, "incompressible: the Navier-Stokes equations at constant density")
             .one_of({"none", "incompressible"}),
         key("density", &S::density, "of the fluid").unit("kg/m3").above(0).required().only_with("type", solved),
         key("viscosity", &S::viscosity, "dynamic viscosity of the fluid")
             .unit("Pa s")
             .at_least(0)
             .required()
             .only_with("type", solved)},
        [] { return std::make_shared<S>(); }};
    for (const auto& keys : {grid_keys(), flow_keys(), method_keys()})
      s.keys.insert(s.keys.end(), keys.begin(), keys.end());
    return s;
  }();
  return section;
}

}  // namespace scree
