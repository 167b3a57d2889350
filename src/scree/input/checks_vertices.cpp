// Contacts by vertices: what they do not go with.
#include "scree/input/checks.h"

namespace scree {

void check_vertices(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"contact.detection", "contact.collision", "particles"}) || !by_vertices(c)) return;
  if (check.sound({"contact.cohesion"}) && c.contact.laws.cohesion != SC_COHESION_NONE)
    check.fail("E164", "contact.detection", "vertices tell nothing of bodies that are apart, where cohesion acts",
               "needs contact.cohesion = 'none'", "set detection = 'certified', or cohesion = 'none'");
  const auto unknown = [](const ParticleKeys& p) { return p.insert == "checkpoint"; };
  if (!has_shapes(c) && std::none_of(c.particles.begin(), c.particles.end(), unknown))
    check.fail("E164", "contact.detection", "vertices are of particles that are no spheres",
               "all particles here are spheres",
               "remove it, or set a shape: one with exponents 1 and equal half axes is round and has vertices   (scree "
               "explain particles.shape)");
}

}  // namespace scree
