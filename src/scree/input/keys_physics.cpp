// What acts on the particles: gravity, the prescribed flow, and the laws of contact.
#include "scree/input/force_keys.h"
#include "scree/input/keys.h"

namespace scree {

const Section& gravity_section() {
  using S = GravityKeys;
  static const Section section = {
      "gravity",
      "[gravity]",
      "Accelerations that act on every particle.",
      {key("type", &S::type,
           "uniform: one acceleration; central: towards a point; expression: formulas; rotating: the forces of a "
           "rotating frame (centrifugal, Coriolis, Euler) and a uniform acceleration")
           .one_of({"none", "uniform", "central", "expression", "rotating"}),
       key("acceleration", &S::acceleration,
           "uniform acceleration; in a rotating frame it is the one felt in that frame")
           .unit("m/s2")
           .only_with("type", {"uniform", "rotating"}),
       key("center", &S::center, "central: the attracting point; rotating: a point on the axis")
           .unit("m")
           .only_with("type", {"central", "rotating"}),
       key("strength", &S::strength,
           "gravitational constant times attracting mass; the acceleration is strength / distance^2")
           .unit("m3/s2")
           .required()
           .only_with("type", {"central"}),
       key("expression", &S::expression, "components of the acceleration")
           .unit("m/s2")
           .required()
           .only_with("type", {"expression"}),
       key("angular_velocity", &S::angular_velocity, "of the rotating frame")
           .unit("rad/s")
           .required()
           .only_with("type", {"rotating"}),
       key("angular_acceleration", &S::angular_acceleration, "of the rotating frame")
           .unit("rad/s2")
           .only_with("type", {"rotating"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& flow_section() {
  using S = FlowKeys;
  static const std::vector<std::string> flowing = {"still", "uniform", "taylor_green", "shear", "expression"};
  static const Section section = [] {
    Section all = {
        "flow",
        "[flow]",
        "A prescribed flow of a fluid, which the particles do not change, and its drag.",
        {key("type", &S::type,
             "still: at rest; uniform: one velocity; taylor_green: (-A sin ax cos ay cos az, -A cos ax sin ay cos az, "
             "2 A cos ax cos ay sin az); shear: u_x grows with y; expression: formulas")
             .one_of({"none", "still", "uniform", "taylor_green", "shear", "expression"}),
         key("drag", &S::drag,
             "law of the drag. That of the sphere of equal volume: stokes; schiller_naumann, with the drag coefficient "
             "24 / Re (1 + 0.15 Re^0.687), 0.44 from Re = 1000. By the shape: haider_levenspiel, by its sphericity. By "
             "shape and orientation, with the lift and the torques that belong to it: stokes_ellipsoid, exact for "
             "ellipsoids in creeping flow; ganser; holzer_sommerfeld, by its shadows; zastawny, for ellipsoids of "
             "2:2:5 and 4:4:5 (docs/fluid_forces.md)")
             .one_of({"none", "stokes", "schiller_naumann", "stokes_ellipsoid", "haider_levenspiel", "ganser",
                      "holzer_sommerfeld", "zastawny"})
             .only_with("type", flowing),
         key("density", &S::density, "of the fluid; drag at finite Reynolds numbers, torques and buoyancy need it")
             .unit("kg/m3")
             .at_least(0)
             .only_with("type", flowing),
         key("viscosity", &S::viscosity, "dynamic viscosity of the fluid; any drag needs it")
             .unit("Pa s")
             .at_least(0)
             .only_with("type", flowing),
         key("buoyancy", &S::buoyancy,
             "whether the fluid carries its part of the weight: particles then fall in uniform gravity g with g (1 - "
             "fluid density / particle density)")
             .only_with("type", flowing),
         key("velocity", &S::velocity, "of the uniform flow").unit("m/s").required().only_with("type", {"uniform"}),
         key("amplitude", &S::amplitude, "A of the Taylor-Green flow")
             .unit("m/s")
             .required()
             .only_with("type", {"taylor_green"}),
         key("wavenumber", &S::wavenumber,
             "a of the Taylor-Green flow: 2 pi divided by its period; a vortex is pi / a wide")
             .unit("1/m")
             .above(0)
             .required()
             .only_with("type", {"taylor_green"}),
         key("shear_rate", &S::shear_rate, "u_x = shear_rate (y - shear_origin)")
             .unit("1/s")
             .required()
             .only_with("type", {"shear"}),
         key("shear_origin", &S::shear_origin, "height y at which the shear flow is at rest")
             .unit("m")
             .only_with("type", {"shear"}),
         key("expression", &S::expression, "components of the velocity")
             .unit("m/s")
             .required()
             .only_with("type", {"expression"}),
         key("pressure_force", &S::pressure_force,
             "whether the pressure and the friction that accelerate the flow act on particles by their volume; that of "
             "the weight of the fluid is buoyancy")
             .only_with("type", flowing)},
        [] { return std::make_shared<S>(); }};
    for (Key& key : fluid_force_keys<S>()) all.keys.push_back(std::move(key.only_with("type", flowing)));
    return all;
  }();
  return section;
}

// A choice's number is its place in the list.
static_assert(SC_NORMAL_LINEAR == 0 && SC_NORMAL_LINEAR_PLAIN == 1 && SC_NORMAL_HERTZ == 2);
static_assert(SC_TANGENTIAL_NONE == 0 && SC_TANGENTIAL_SLIDING == 1 && SC_TANGENTIAL_STEP_SPRING == 2);
static_assert(SC_TANGENTIAL_COLLISION_SPRING == 3 && SC_TANGENTIAL_COLLISION_SPRING_DAMPED == 4);
static_assert(SC_TANGENTIAL_HISTORY == 5 && SC_TANGENTIAL_MINDLIN == 6 && SC_TANGENTIAL_MINDLIN_STRETCH == 7);
static_assert(SC_ROLLING_NONE == 0 && SC_ROLLING_SPRING == 1 && SC_TWISTING_NONE == 0 && SC_TWISTING_SPRING == 1);
static_assert(SC_COHESION_NONE == 0 && SC_COHESION_LINEAR == 1 && SC_COHESION_JKR == 2);

const Section& contact_section() {
  using S = ContactKeys;
  static const std::vector<std::string> springs = {"step_spring", "collision_spring", "collision_spring_damped",
                                                   "history"};
  static const Section section = {
      "contact",
      "[contact]",
      "The laws of contact, chosen independently of each other.",
      {key("collision", &S::collision,
           "soft: springs and dashpots, the laws below; hard: impulses with restitution and friction, and with the "
           "limits of rolling and twisting where these laws are chosen ([hard] says how they are solved). This one key "
           "switches between both: what only the other model reads may stand in the case and has no effect (scree "
           "check names it); cohesion alone is of soft collisions only")
           .one_of({"soft", "hard"}),
       key("detection", &S::detection,
           "how contacts of particles that are no spheres are found. certified: where the bodies touch when they grow "
           "or shrink, with a proof; vertices: by vertices of each surface that lie in the other body or behind a flat "
           "wall, which misses contacts and does not keep the energy of elastic ones, for comparison "
           "(docs/vertices.md); hard collisions take one point of a contact from them, also where bodies lie flat")
           .one_of({"certified", "vertices"}),
       key("vertices", &S::vertices, "N of the N x N vertices on each surface")
           .between(4, 100)
           .only_with("detection", {"vertices"}),
       key("spacing", &S::spacing,
           "of the vertices. linear: equal steps of both angles of the parametric form; exponential: the same around "
           "the axis, denser at the equator along it; radial: even on faces; normal: dense where the surface is "
           "curved; mixed: half radial, half normal")
           .one_of({"linear", "exponential", "radial", "normal", "mixed"})
           .only_with("detection", {"vertices"}),
       law("normal", &sc_laws::normal,
           "linear: spring and dashpot that never pull, the damping corrected for it; linear_plain: the same, but it "
           "may pull at the end of a contact; hertz: Hertz's spring with Tsuji's damping")
           .one_of({"linear", "linear_plain", "hertz"}),
       law("tangential", &sc_laws::tangential,
           "sliding: Coulomb friction only; step_spring: spring stretched by one time step's sliding; "
           "collision_spring, collision_spring_damped: spring stretched by the velocity times the duration of the "
           "collision, without and with a dashpot; history: spring with memory; mindlin: the same with Mindlin's "
           "stiffness, in increments so that it never gains energy; mindlin_stretch: Mindlin's stiffness times the "
           "whole stretch, as many codes have it")
           .one_of({"none", "sliding", "step_spring", "collision_spring", "collision_spring_damped", "history",
                    "mindlin", "mindlin_stretch"})
           .defaults_to("history; mindlin with normal = 'hertz'"),
       law("rolling", &sc_laws::rolling,
           "spring: spring, dashpot and slider that resist rolling; with hard collisions the slider alone, an angular "
           "impulse that stops rolling up to the same limit")
           .one_of({"none", "spring"}),
       law("twisting", &sc_laws::twisting,
           "spring: spring, dashpot and slider that resist turning about the normal; with hard collisions likewise")
           .one_of({"none", "spring"}),
       law("cohesion", &sc_laws::cohesion,
           "linear: attraction that grows with the overlap of the effect surfaces; jkr: Johnson, Kendall and Roberts, "
           "in place of Hertz's spring. With soft collisions only: an impulse takes no time in which it could hold "
           "bodies together")
           .one_of({"none", "linear", "jkr"}),
       key("tangential_stiffness_ratio", &S::tangential_stiffness_ratio,
           "tangential over normal stiffness; 2/7 lets both oscillations of a sphere take the same time")
           .above(0)
           .at_most(10)
           .only_with("tangential", springs),
       key("tangential_damping", &S::tangential_damping, "damping ratio of the tangential spring")
           .between(0, 10)
           .defaults_to("as the normal one")
           .only_with("tangential", {"collision_spring_damped", "history", "mindlin", "mindlin_stretch"}),
       key("rolling_stiffness_ratio", &S::rolling_stiffness_ratio, "rolling stiffness over k_t R^2")
           .above(0)
           .only_with("rolling", {"spring"}),
       key("rolling_damping", &S::rolling_damping, "damping ratio of rolling")
           .between(0, 10)
           .only_with("rolling", {"spring"}),
       key("twisting_stiffness_ratio", &S::twisting_stiffness_ratio, "twisting stiffness over k_t R^2")
           .above(0)
           .only_with("twisting", {"spring"}),
       key("twisting_damping", &S::twisting_damping, "damping ratio of twisting")
           .between(0, 10)
           .only_with("twisting", {"spring"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
