#include "scree/app/bench_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>

#include "scree/base/atomic_file.h"
#include "scree/input/mesh_weld.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr int segments = 64;  // of the drum, a multiple of 4

/// Appends the image of the unit square in columns x rows cells, two triangles each; neighbours share no vertices yet.
/// Cells are cut along the diagonal towards the middle of the square, so that none has its corners on a disc's rim
/// only.
void add_sheet(TriangleMesh& mesh, int columns, int rows, const std::function<sc_vec(double, double)>& place) {
  const auto add = [&](std::array<sc_vec, 3> corners) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  const auto at = [&](int i, int j) { return place(double(i) / columns, double(j) / rows); };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const bool rising = (2 * i + 1 < columns) == (2 * j + 1 < rows);
      add({at(i, j), at(i + 1, j), rising ? at(i + 1, j + 1) : at(i, j + 1)});
      add({rising ? at(i, j) : at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
}

sc_vec on_circle(double x, double radius, double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return sc_make_vec(x, radius * std::cos(angle), radius * std::sin(angle));
}

/// The square [-1, 1]^2 on the disc so that squares about the middle become circles, with equal steps around
/// (P. Shirley, K. Chiu (1997), A low distortion map between disk and square, J. Graphics Tools 2(3), 45).
sc_vec on_disc(double x, double radius, double a, double b) {
  if (a == 0 && b == 0) return sc_make_vec(x, 0, 0);
  const double edge = std::abs(a) > std::abs(b) ? a : b;
  const double turn = std::abs(a) > std::abs(b) ? b / a / 8 : 0.25 - a / b / 8;
  return on_circle(x, radius * edge, turn);
}

}  // namespace

TriangleMesh drum_mesh(double radius, double length) {
  TriangleMesh loose;
  const int along = std::max(1, static_cast<int>(std::round(length * segments / (2 * std::numbers::pi * radius))));
  add_sheet(loose, segments, along, [&](double s, double t) { return on_circle(t * length, radius, s); });
  for (const double x : {0.0, length})
    add_sheet(loose, segments / 4, segments / 4,
              [&](double s, double t) { return on_disc(x, radius, 2 * s - 1, 2 * t - 1); });
  return weld(loose);
}

TriangleMesh silo_mesh(double bin, double bin_height, double outlet, double hopper_height) {
  constexpr int across = 10;
  TriangleMesh loose;
  const auto rows = [&](double height) {
    return std::max(1, static_cast<int>(std::round(height * across / (2 * bin))));
  };
  const double top = hopper_height + bin_height;
  for (int side = 0; side < 4; ++side) {
    // Side 0 is at y = -half; the others follow by quarter turns.
    const auto turned = [side](double x, double y, double z) {
      for (int k = 0; k < side; ++k) x = -std::exchange(y, x);
      return sc_make_vec(x, y, z);
    };
    add_sheet(loose, across, rows(hopper_height), [&](double s, double t) {
      const double half = outlet + t * (bin - outlet);
      return turned((2 * s - 1) * half, -half, t * hopper_height);
    });
    add_sheet(loose, across, rows(bin_height), [&](double s, double t) {
      return turned((2 * s - 1) * bin, -bin, hopper_height + t * (top - hopper_height));
    });
  }
  return weld(loose);
}

std::string stl_text(const std::string& name, const TriangleMesh& mesh) {
  std::string text = fmt::format("solid {}\n", name);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<sc_vec, 3> corners{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    const sc_vec area = sc_cross(sc_sub(corners[1], corners[0]), sc_sub(corners[2], corners[0]));
    const sc_vec normal = sc_scale(1 / sc_norm(area), area);
    fmt::format_to(std::back_inserter(text), "facet normal {} {} {}\n outer loop\n", normal.x, normal.y, normal.z);
    for (const sc_vec& x : corners) fmt::format_to(std::back_inserter(text), "  vertex {} {} {}\n", x.x, x.y, x.z);
    text += " endloop\nendfacet\n";
  }
  return text + fmt::format("endsolid {}\n", name);
}

std::vector<std::string> make_mesh(const std::string& scene, const std::string& directory) {
  if (scene != "drum" && scene != "silo") return {};
  const fs::path file = fs::path(directory) / (scene + ".stl");
  if (!fs::exists(file)) {
    fs::create_directories(directory);
    write_text_file(file,
                    stl_text(scene, scene == "drum" ? drum_mesh(0.060, 0.180) : silo_mesh(0.030, 0.300, 0.012, 0.030)));
  }
  return {fmt::format("walls.0.file=\"{}\"", file.string())};
}

}  // namespace scree
