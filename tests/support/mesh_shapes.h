// Surfaces of triangles for tests, and the files that hold them.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "scree/physics/vec.h"

namespace scree::test {

using Corners = std::array<sc_vec, 3>;
using Triangles = std::vector<Corners>;

inline void add_quadrangle(Triangles& triangles, sc_vec a, sc_vec b, sc_vec c, sc_vec d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

/// The 12 triangles of a box, wound so that their normals point outwards.
inline Triangles box_triangles(sc_vec low, sc_vec high) {
  const auto corner = [&](int x, int y, int z) {
    return sc_make_vec(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
  };
  Triangles triangles;
  add_quadrangle(triangles, corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  add_quadrangle(triangles, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  add_quadrangle(triangles, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  add_quadrangle(triangles, corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
  add_quadrangle(triangles, corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  add_quadrangle(triangles, corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  return triangles;
}

/// The jacket of a cylinder along z from 0 to `height`, as a prism of `sides` sides whose corners lie on it.
inline Triangles cylinder_triangles(double radius, double height, int sides) {
  const auto rim = [&](int i, double z) {
    const double angle = 2 * std::numbers::pi * (i % sides) / sides;
    return sc_make_vec(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  Triangles triangles;
  for (int i = 0; i < sides; ++i)
    add_quadrangle(triangles, rim(i, 0), rim(i + 1, 0), rim(i + 1, height), rim(i, height));
  return triangles;
}

/// The square from 0 to `size` at z = 0 in n x n quadrangles with inner corners moved about, each cut at random.
inline Triangles plane_triangles(double size, int n, unsigned seed) {
  std::mt19937 random(seed);
  const auto shift = [&] { return static_cast<double>(random()) / 4294967296.0 * 0.6 - 0.3; };
  std::vector<sc_vec> corners;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = i + (i % n ? shift() : 0), y = j + (j % n ? shift() : 0);
      corners.push_back(sc_make_vec(size * x / n, size * y / n, 0));
    }
  Triangles triangles;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int at = j * (n + 1) + i;
      const sc_vec a = corners[at], b = corners[at + 1], c = corners[at + n + 2], d = corners[at + n + 1];
      random() % 2 ? add_quadrangle(triangles, a, b, c, d) : add_quadrangle(triangles, b, c, d, a);
    }
  return triangles;
}

inline std::string stl_text(const Triangles& triangles) {
  std::string text = "solid shape\n";
  for (const Corners& corners : triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const sc_vec& x : corners) text += fmt::format("      vertex {} {} {}\n", x.x, x.y, x.z);
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid shape\n";
}

inline std::string stl_binary(const Triangles& triangles, std::string header = "solid but binary") {
  header.resize(80, ' ');
  std::string bytes = header;
  const auto add = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(static_cast<std::uint32_t>(triangles.size()));
  for (const Corners& corners : triangles) {
    for (int k = 0; k < 3; ++k) add(0.0f);
    for (const sc_vec& x : corners)
      for (double along : {x.x, x.y, x.z}) add(static_cast<float>(along));
    add(std::uint16_t{0});
  }
  return bytes;
}

}  // namespace scree::test
