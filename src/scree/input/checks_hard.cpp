// Hard collisions: what they cannot do. Keys of the two models may stand side by side, so that one key switches.
#include <fmt/format.h>

#include "scree/input/checks.h"

namespace scree {
namespace {

/// A choice of the soft model that would silently be gone.
void soft_only(const Check& check, const char* path, bool chosen, const char* what) {
  if (!chosen || !check.sound({path})) return;
  check.fail("E164", path, fmt::format("{} has no form for hard collisions", what), "needs contact.collision = 'soft'",
             "choose 'none', or contact.collision = 'soft'");
}

}  // namespace

void check_hard(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"contact.collision"})) return;
  if (!is_hard(c)) return;
  const sc_laws& laws = c.contact.laws;
  soft_only(check, "contact.rolling", laws.rolling != SC_ROLLING_NONE, "resistance to rolling");
  soft_only(check, "contact.twisting", laws.twisting != SC_TWISTING_NONE, "resistance to twisting");
  soft_only(check, "contact.cohesion", laws.cohesion != SC_COHESION_NONE, "cohesion");
  if (check.sound({"simulation.integrator"}) && c.simulation.integrator != "leapfrog")
    check.fail("E164", "simulation.integrator", "hard collisions have an integrator of their own",
               fmt::format("'{}' is for soft collisions", c.simulation.integrator),
               "remove it, or set contact.collision = 'soft'");
}

}  // namespace scree
