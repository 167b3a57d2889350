// Materials, what pairs of them have of their own, and walls.
#include "scree/input/keys.h"

namespace scree {

const Section& materials_section() {
  using S = MaterialKeys;
  static const Section section = {
      "materials",
      "[[materials]]",
      "A material of particles or walls.",
      {key("name", &S::name, "name by which particles, walls and pairs refer to it").is_a(TextKind::name).required(),
       key("density", &S::density, "of the solid; materials of walls need none")
           .unit("kg/m3")
           .above(0)
           .defaults_to("none"),
       key("young", &S::young, "Young's modulus, for hertz, mindlin and jkr").unit("Pa").above(0).defaults_to("none"),
       key("poisson", &S::poisson, "Poisson's ratio, for hertz, mindlin and jkr")
           .above(-1)
           .at_most(0.5)
           .defaults_to("none"),
       key("stiffness", &S::stiffness, "of the linear normal spring between two bodies of this material")
           .unit("N/m")
           .above(0)
           .defaults_to("none"),
       key("restitution", &S::restitution,
           "speed after over speed before a head-on collision without cohesion; with cohesion or adhesion, which "
           "lengthen the contact and take their own share, bodies come back more slowly or stay")
           .between(1e-4, 1),
       key("tangential_restitution", &S::tangential_restitution,
           "of hard collisions that stick: sliding speed after over before, backwards")
           .between(0, 1),
       key("friction", &S::friction, "coefficient of friction, static and sliding").between(0, 100),
       key("friction_sliding", &S::friction_sliding, "coefficient while sliding")
           .between(0, 100)
           .defaults_to("as friction"),
       key("rolling_friction", &S::rolling_friction, "largest rolling couple over radius times normal force")
           .between(0, 100),
       key("twisting_friction", &S::twisting_friction, "largest twisting couple over radius times normal force")
           .between(0, 100),
       key("cohesion_stiffness", &S::cohesion_stiffness,
           "of linear cohesion: force over the overlap of the effect surfaces")
           .unit("N/m")
           .at_least(0),
       key("adhesion", &S::adhesion, "work of adhesion of this material against itself, for jkr")
           .unit("J/m2")
           .at_least(0),
       key("heat_capacity", &S::heat_capacity, "of particles with a temperature")
           .unit("J/(kg K)")
           .above(0)
           .defaults_to("none"),
       key("conductivity", &S::conductivity, "for heat, of particles that conduct it through contacts")
           .unit("W/(m K)")
           .above(0)
           .defaults_to("none")},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& pairs_section() {
  using S = PairKeys;
  static const Section section = {
      "pairs",
      "[[pairs]]",
      "What two materials have in common; what is not given is mixed from the two.",
      {key("materials", &S::materials, "names of the two materials; may be the same twice").required(),
       key("stiffness", &S::stiffness, "of the linear normal spring").unit("N/m").above(0).defaults_to("mixed"),
       key("young", &S::young, "effective modulus E* of the pair").unit("Pa").above(0).defaults_to("mixed"),
       key("restitution", &S::restitution, "speed after over speed before a head-on collision without cohesion")
           .between(1e-4, 1)
           .defaults_to("mixed"),
       key("tangential_restitution", &S::tangential_restitution, "of hard collisions that stick")
           .between(0, 1)
           .defaults_to("mixed"),
       key("friction", &S::friction, "coefficient of friction, static and sliding")
           .between(0, 100)
           .defaults_to("mixed"),
       key("friction_sliding", &S::friction_sliding, "coefficient while sliding")
           .between(0, 100)
           .defaults_to("as friction if that is given, else mixed"),
       key("rolling_friction", &S::rolling_friction, "largest rolling couple over radius times normal force")
           .between(0, 100)
           .defaults_to("mixed"),
       key("twisting_friction", &S::twisting_friction, "largest twisting couple over radius times normal force")
           .between(0, 100)
           .defaults_to("mixed"),
       key("cohesion_stiffness", &S::cohesion_stiffness, "of linear cohesion")
           .unit("N/m")
           .at_least(0)
           .defaults_to("mixed"),
       key("adhesion", &S::adhesion, "work of adhesion between the two").unit("J/m2").at_least(0).defaults_to("mixed")},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
