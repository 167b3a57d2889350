// Heat of the particles.
#include "scree/input/keys.h"

namespace scree {

const Section& heat_section() {
  using S = HeatKeys;
  static const std::vector<std::string> solved = {"solved"};
  static const Section section = {
      "heat",
      "[heat]",
      "The temperature of particles: what they exchange with a fluid that carries heat, with each other and with "
      "walls. Columns particle_heat, particle_heat_from_fluid, particle_heat_from_walls, particle_heat_error, "
      "particle_temperature_lowest, _mean, _highest of the series, field temperature of frames.",
      {key("type", &S::type, "none: particles have no temperature; solved: each has one").one_of({"none", "solved"}),
       key("exchange", &S::exchange,
           "law of the heat between particles and a fluid with [fluid.heat]: that of one sphere, or of spheres among "
           "others (docs/fluid_forces.md)")
           .one_of({"none", "ranz_marshall", "gunn"})
           .only_with("type", solved),
       key("conduction", &S::conduction,
           "whether heat passes through contacts: the circle of Hertz for the radii of equal volume and the overlap")
           .only_with("type", solved),
       key("contact_radius", &S::contact_radius,
           "what the radius of that circle is multiplied by: springs softer than the material make it too large, by "
           "the cube root of the ratio of the moduli at rest")
           .above(0)
           .at_most(1)
           .only_with("type", solved),
       key("every", &S::every, "steps of the particles between two looks at their contacts for conduction")
           .between(1, 1e9)
           .only_with("type", solved)},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
