// Eight numbers side by side.
#include "scree/particles/lanes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

TEST(Lanes, ABitForEveryNumberThatIsNotNegative) {
  for (unsigned bits = 0; bits < 256; ++bits) {
    alignas(64) double p[8];
    const double size[8] = {1, 1e-300, 5e-324, 1e300, INFINITY, 0.5, 2, 1e-16};
    for (int l = 0; l < 8; ++l) p[l] = bits >> l & 1 ? size[l] : -size[l];
    EXPECT_EQ(not_negative(p), bits);
  }
  alignas(64) const double nought[8] = {};
  EXPECT_EQ(not_negative(nought), 0xffu);
}

}  // namespace
}  // namespace scree
