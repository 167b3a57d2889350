// Cases of bodies of any shape for the tests of devices.
#pragma once

#include "support/device_cases.h"
#include "support/hopper.h"

namespace scree::test {

/// A group of `count` particles at random between the corners of a region.
inline std::string group(const std::string& name, int count, const std::string& shape,
                         const std::string& material = "glass",
                         const std::string& region =
                             "region_min = [0.002, 0.002, 0.006]\n"
                             "region_max = [0.028, 0.028, 0.028]\n") {
  return "[[particles]]\nname = \"" + name + "\"\nmaterial = \"" + material +
         "\"\ninsert = \"random\"\ncount = " + std::to_string(count) + "\n" + region + shape +
         "effect_gap = 2e-4\nangular_velocity = [30, -60, 20]\nvelocity = { type = \"random\", deviation = 0.4 }\n";
}

inline const std::string ellipsoid =
    "orientation = \"random\"\nshape = \"ellipsoid\"\nhalf_axes = [3e-3, 2e-3, 1.5e-3]\n";
inline const std::string rod = "orientation = \"random\"\nshape = \"capsule\"\nhalf_axes = [1.2e-3, 1.2e-3, 2.8e-3]\n";
inline const std::string disc =
    "orientation = \"random\"\nshape = \"cylinder\"\nhalf_axes = [2.2e-3, 2.2e-3, 1.2e-3]\n";
inline const std::string brick = "orientation = \"random\"\nshape = \"box\"\nhalf_axes = [2.4e-3, 1.8e-3, 1.4e-3]\n";
inline const std::string pointed =
    "orientation = \"random\"\nshape = \"superellipsoid\"\nhalf_axes = [2.5e-3, 2e-3, 2e-3]\nexponents = [1.5, 1.5]\n";
inline const std::string odd =
    "orientation = \"random\"\nshape = \"superellipsoid\"\nhalf_axes = [2e-3, 1.7e-3, 2.2e-3]\nexponents = [0.7, "
    "1.2]\n";
inline const std::string ball = "diameter = { distribution = \"uniform\", min = 3e-3, max = 5e-3 }\n";

/// Bodies of every kind, some of each.
inline std::string mixture(int each, const std::string& region =
                                         "region_min = [0.002, 0.002, 0.006]\n"
                                         "region_max = [0.028, 0.028, 0.028]\n") {
  return group("ellipsoids", each, ellipsoid, "glass", region) + group("rods", each, rod, "rubber", region) +
         group("discs", each, disc, "glass", region) + group("bricks", each, brick, "rubber", region) +
         group("pointed", each, pointed, "glass", region) + group("odd", each, odd, "glass", region) +
         group("balls", each, ball, "rubber", region);
}

inline const LawChoice rough{"rough", rough_laws, rough_material};

inline std::string head(const LawChoice& laws, const std::string& domain) {
  return "[simulation]\nend = 10\ntime_step = 2e-5\nmax_overlap = 2\n[domain]\n" + domain + "[contact]\n" +
         laws.contact + material_text(laws, "glass", 2000, 0.8) + material_text(laws, "rubber", 1000, 0.5);
}

/// A mixture between two planes, periodic sideways, with an ellipsoid in it that does not move.
inline std::string periodic(const LawChoice& laws, const std::string& more = gravity) {
  return head(laws, "min = [0, 0, -0.001]\nmax = [0.024, 0.024, 0.031]\nperiodic = [true, true, false]\n") +
         "[[particles]]\nname = \"anchor\"\nmaterial = \"rubber\"\ninsert = \"positions\"\n" + ellipsoid +
         "positions = [[0.012, 0.012, 0.0265]]\nmotion = \"fixed\"\n" +
         mixture(10, "region_min = [0, 0, 0]\nregion_max = [0.024, 0.024, 0.03]\n") +
         wall("plane", "point = [0, 0, 0]\nnormal = [0, 0, 1]") +
         wall("plane", "point = [0, 0, 0.03]\nnormal = [0, 0, -1]", "glass") + more;
}

/// A mixture among walls, which must close the region of vessel().
inline std::string vessel_of_shapes(const std::string& walls, int each = 6) {
  return head(rough, "min = [-0.02, -0.02, -0.02]\nmax = [0.05, 0.05, 0.05]\n") + mixture(each) + gravity + walls;
}

/// The hopper with ellipsoids and rods that come into a bed of spheres, and go.
inline std::string hopper_of_shapes() {
  std::string text = hopper;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("diameter = { distribution = \"uniform\", min = 1.5e-3, max = 3e-3 }",
          "shape = \"ellipsoid\"\nhalf_axes = [1.5e-3, 1e-3, 0.8e-3]\norientation = \"random\"");
  replace("diameter = 3e-3", "shape = \"capsule\"\nhalf_axes = [0.7e-3, 0.7e-3, 1.6e-3]\norientation = \"random\"");
  replace("count = 120", "count = 60");
  return text;
}

}  // namespace scree::test
