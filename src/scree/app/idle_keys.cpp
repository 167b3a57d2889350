#include "scree/app/idle_keys.h"

#include <algorithm>

namespace scree {
namespace {

void note(bool given, const char* key, std::vector<std::string>& to) {
  if (given) to.emplace_back(key);
}

/// What hard collisions do not read.
void note_soft(const Case& c, std::vector<std::string>& to) {
  const ContactKeys& k = c.contact;
  const ContactKeys plain;
  note(c.simulation.integrator != SimulationKeys{}.integrator, "simulation.integrator", to);
  note(c.simulation.steps_per_contact != SimulationKeys{}.steps_per_contact, "simulation.steps_per_contact", to);
  note(k.laws.normal != plain.laws.normal, "contact.normal", to);
  note(k.laws.tangential != plain.laws.tangential, "contact.tangential", to);
  note(k.tangential_stiffness_ratio != plain.tangential_stiffness_ratio, "contact.tangential_stiffness_ratio", to);
  note(k.tangential_damping.has_value(), "contact.tangential_damping", to);
  note(k.rolling_stiffness_ratio != plain.rolling_stiffness_ratio, "contact.rolling_stiffness_ratio", to);
  note(k.rolling_damping != plain.rolling_damping, "contact.rolling_damping", to);
  note(k.twisting_stiffness_ratio != plain.twisting_stiffness_ratio, "contact.twisting_stiffness_ratio", to);
  note(k.twisting_damping != plain.twisting_damping, "contact.twisting_damping", to);
  const auto any = [&](auto member) {
    const auto has = [&](const auto& keys) { return (keys.*member).has_value(); };
    return std::ranges::any_of(c.materials, has);
  };
  note(any(&MaterialKeys::stiffness), "materials.stiffness", to);
  note(any(&MaterialKeys::young), "materials.young", to);
  note(any(&MaterialKeys::poisson), "materials.poisson", to);
}

/// What soft ones do not.
void note_hard(const Case& c, std::vector<std::string>& to) {
  const HardKeys plain;
  note(c.hard.order != plain.order, "hard.order", to);
  note(c.hard.sweeps != plain.sweeps, "hard.sweeps", to);
  note(c.hard.residual != plain.residual, "hard.residual", to);
  note(c.hard.threshold.has_value(), "hard.threshold", to);
  note(c.hard.slop != plain.slop, "hard.slop", to);
  note(c.hard.travel != plain.travel, "hard.travel", to);
  const auto bounces = [](const MaterialKeys& m) { return m.tangential_restitution != 0; };
  note(std::ranges::any_of(c.materials, bounces), "materials.tangential_restitution", to);
}

}  // namespace

std::vector<std::string> idle_keys(const Case& c) {
  std::vector<std::string> out;
  is_hard(c) ? note_soft(c, out) : note_hard(c, out);
  return out;
}

std::vector<IdleTable> idle_tables(const Case& c) {
  std::vector<IdleTable> out;
  if (!couples(c) && c.coupling != CouplingKeys{}) out.push_back({"coupling", "[fluid] and particles"});
  if (warms(c) && !exchanges_heat(c) && c.heat.exchange != HeatKeys{}.exchange && c.heat.exchange != "none")
    out.push_back({"heat.exchange", "a fluid with [fluid.heat]"});
  const auto has_temperature = [](const WallKeys& wall) { return wall.temperature.has_value(); };
  if (warms(c) && !c.heat.conduction && std::ranges::any_of(c.walls, has_temperature))
    out.push_back({"walls.temperature", "heat.conduction"});
  return out;
}

}  // namespace scree
