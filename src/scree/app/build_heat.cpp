#include "scree/app/build_heat.h"

#include "scree/physics/heat/nusselt.h"

namespace scree {

std::optional<HeatProperties> build_heat(const Case& c) {
  if (!warms(c)) return {};
  HeatProperties out;
  for (const MaterialKeys& m : c.materials) {
    out.capacity.push_back(m.heat_capacity.value_or(0));
    out.conductivity.push_back(m.conductivity.value_or(0));
  }
  for (const ParticleKeys& group : c.particles) out.given.push_back(group.temperature.value_or(0));
  for (const WallKeys& wall : c.walls) out.wall_temperature.push_back(wall.temperature);
  out.conduction = c.heat.conduction;
  out.contact_radius = c.heat.contact_radius;
  out.every = static_cast<int>(c.heat.every);
  return out;
}

int nusselt_law(const Case& c) {
  if (!exchanges_heat(c)) return SC_NUSSELT_NONE;
  return c.heat.exchange == "gunn" ? SC_NUSSELT_GUNN : SC_NUSSELT_RANZ_MARSHALL;
}

std::vector<std::string> heat_columns(const Case& c) {
  if (!warms(c)) return {};
  return {"particle_heat",
          "particle_heat_from_fluid",
          "particle_heat_from_walls",
          "particle_heat_error",
          "particle_temperature_lowest",
          "particle_temperature_mean",
          "particle_temperature_highest"};
}

std::vector<double> heat_row(const HeatFacts& f, const HeatBooks& b) {
  return {f.content, b.from_fluid, b.from_walls, f.content - b.expected(), f.lowest, f.mean, f.highest};
}

}  // namespace scree
