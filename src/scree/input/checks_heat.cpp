// Temperatures of particles: what they need, and what is given to nobody.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "scree/input/checks.h"

namespace scree {
namespace {

void refuse_idle(const Check& check) {
  const Case& c = check.c;
  const auto refuse = [&](const std::string& path, const std::optional<double>& given) {
    if (given)
      check.fail("E150", path, "a temperature is given and particles have none", "needs [heat] type = 'solved'",
                 "remove it, or give the particles their heat   (scree explain heat)");
  };
  for (std::size_t i = 0; i < c.particles.size(); ++i)
    refuse(item_path("particles", i) + ".temperature", c.particles[i].temperature);
  for (std::size_t i = 0; i < c.walls.size(); ++i)
    refuse(item_path("walls", i) + ".temperature", c.walls[i].temperature);
}

/// A group needs a temperature, and a material that can hold and conduct heat.
void check_group(const Check& check, std::size_t i) {
  const Case& c = check.c;
  const ParticleKeys& group = c.particles[i];
  const std::string path = item_path("particles", i);
  if (!check.sound({path})) return;
  if (!group.temperature)
    check.fail("E163", path + ".temperature", fmt::format("the particles '{}' have no temperature", group.name),
               "[heat] is solved", "give the group a temperature");
  const auto material = std::ranges::find(c.materials, group.material, &MaterialKeys::name);
  if (material == c.materials.end()) return;
  const std::string of = item_path("materials", static_cast<std::size_t>(std::distance(c.materials.begin(), material)));
  const auto want = [&](const char* key, const std::optional<double>& given) {
    if (!given && check.sound({of}))
      check.fail("E163", of + "." + key, fmt::format("material '{}' has no {}", material->name, key),
                 fmt::format("the particles '{}' have a temperature", group.name),
                 fmt::format("give the material its {}   (scree explain materials.{})", key, key));
  };
  want("heat_capacity", material->heat_capacity);
  if (c.heat.conduction) want("conductivity", material->conductivity);
}

/// Whether a formula is the number 0.
bool is_nought(const std::string& formula) {
  char* end = nullptr;
  return !formula.empty() && std::strtod(formula.c_str(), &end) == 0 && *end == '\0';
}

/// Laws of heat transfer go by the Reynolds and the Prandtl number.
void check_heat_exchange(const Check& check) {
  const Case& c = check.c;
  if (!exchanges_heat(c) || !check.sound({"fluid"})) return;
  const std::string help = "give it, or set heat.exchange = \"none\"";
  const auto& viscosity = c.fluid.heat.viscosity;
  if (viscosity.empty() ? c.fluid.viscosity == 0 : is_nought(viscosity))
    check.fail("E163", viscosity.empty() ? "fluid.viscosity" : "fluid.heat.viscosity",
               "particles and fluid exchange no heat without a viscosity", "it is 0", help);
  if (is_nought(c.fluid.heat.conductivity))
    check.fail("E163", "fluid.heat.conductivity", "particles and fluid exchange no heat without a conductivity",
               "it is 0", help);
}

}  // namespace

void check_heat(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"heat"})) return;
  if (c.heat.type == "none") return refuse_idle(check);
  for (std::size_t i = 0; i < c.particles.size(); ++i) check_group(check, i);
  check_heat_exchange(check);
  if (c.heat.conduction && is_hard(c))
    check.fail("E164", "heat.conduction", "hard collisions leave no contacts to conduct heat",
               "contact.collision is 'hard'", "conduction = false, or collision = \"soft\"");
}

}  // namespace scree
