#include "scree/data/fluid_region.h"

#include <algorithm>

namespace scree {

bool FluidRegion::is_fluid(int i, int j, int k) const {
  std::array<int, 3> c{i, j, k};
  for (int a = 0; a < 3; ++a) {
    const int n = grid.cells(a);
    if (c[a] >= 0 && c[a] < n) continue;
    if (!grid.periodic[a]) return false;
    c[a] = (c[a] % n + n) % n;
  }
  const auto holds = [&](const CellBox& box) { return box.contains(c[0], c[1], c[2]); };
  return std::ranges::any_of(blocks, holds) && std::ranges::none_of(obstacles, holds);
}

int FluidRegion::patch_of(int i, int j, int k, int axis, bool upper) const {
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const PatchPlace& place = patches[p];
    if (place.axis == axis && place.upper == upper && place.cells.contains(i, j, k)) return static_cast<int>(p);
  }
  return -1;
}

}  // namespace scree
