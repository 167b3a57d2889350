// The materials of a run and the contact constants of every pair of them.
#pragma once

#include <string>
#include <vector>

#include "scree/physics/contact/contact.h"

namespace scree {

/// Materials by index, and the constants of each pair as a full symmetric table.
struct Materials {
  std::vector<std::string> names;
  std::vector<double> density;   // [kg/m3]
  std::vector<sc_pair_law> law;  // [materials][materials]

  int count() const { return static_cast<int>(names.size()); }
  const sc_pair_law& pair(int a, int b) const { return law[std::size_t(a) * names.size() + std::size_t(b)]; }
  sc_pair_law& pair(int a, int b) { return law[std::size_t(a) * names.size() + std::size_t(b)]; }
};

}  // namespace scree
