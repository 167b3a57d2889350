// The materials of a run and the contact constants of every pair of them.
#pragma once

#include <string>
#include <vector>

#include "scree/physics/contact/contact.h"
#include "scree/physics/impulse/impact.h"
#include "scree/physics/impulse/roll.h"

namespace scree {

/// Materials by index, and the constants of each pair as a full symmetric table.
struct Materials {
  std::vector<std::string> names;
  std::vector<double> density;        // [kg/m3]
  std::vector<sc_pair_law> law;       // [materials][materials]
  std::vector<double> restitution;    // [materials][materials]: what the damping ratio was derived from
  std::vector<sc_impact_law> impact;  // [materials][materials]: for hard collisions
  std::vector<sc_turn_law> turning;   // the same; 0 without such laws

  int count() const { return static_cast<int>(names.size()); }
  std::size_t index(int a, int b) const {
    return static_cast<std::size_t>(a) * names.size() + static_cast<std::size_t>(b);
  }
  const sc_pair_law& pair(int a, int b) const { return law[index(a, b)]; }
};

}  // namespace scree
