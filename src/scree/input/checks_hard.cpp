// Hard collisions: what they cannot do. Keys of the two models may stand side by side, so that one key switches.
#include "scree/input/checks.h"

namespace scree {

void check_hard(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"contact.collision", "contact.cohesion"}) || !is_hard(c)) return;
  if (c.contact.laws.cohesion != SC_COHESION_NONE)
    check.fail("E164", "contact.cohesion", "cohesion has no form for hard collisions",
               "it pulls for as long as bodies are near each other, and an impulse takes no time",
               "choose cohesion = 'none', or contact.collision = 'soft', where bodies stick");
}

}  // namespace scree
