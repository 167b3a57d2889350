// Where particles leave the simulation: open faces of the domain, and regions that take what comes into them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scree/base/exact_sum.h"
#include "scree/data/domain.h"
#include "scree/data/particles.h"

namespace scree {

struct Outlet {
  std::string name;
  bool is_face = true;
  int axis = 0;                        // of the face
  bool upper = false;                  // its side
  std::array<double, 3> min{}, max{};  // region: corners [m]

  /// True if a centre at `position` is beyond the face, or in the region.
  bool takes(const double* position, const Domain& domain) const;
};

/// What an outlet has taken since the start.
struct OutletCount {
  std::int64_t count = 0;
  ExactSum mass;  // [kg]
};

/// For every particle held, copies included, 0, or 1 more than the index of the first outlet that takes it; bodies of
/// infinite mass stay. Empty if nobody leaves.
std::vector<std::uint8_t> find_leavers(const Particles& particles, const Domain& domain,
                                       const std::vector<Outlet>& outlets);

}  // namespace scree
