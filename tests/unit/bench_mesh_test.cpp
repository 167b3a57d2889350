// The meshes of the benchmark scenes: watertight where they should be, and the same for every program that reads them.
#include "scree/app/bench_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <utility>

#include "scree/base/atomic_file.h"
#include "scree/input/mesh_file.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// How many edges belong to one triangle alone; an edge of more than two fails.
int open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  int open = 0;
  for (const auto& [edge, count] : uses) {
    EXPECT_LE(count, 2);
    open += count == 1;
  }
  return open;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum +=
        0.5 * sc_norm(sc_cross(sc_sub(mesh.vertices[b], mesh.vertices[a]), sc_sub(mesh.vertices[c], mesh.vertices[a])));
  return sum;
}

TEST(BenchMesh, TheDrumIsAClosedPrism) {
  const double radius = 0.06, length = 0.18, segments = 64;
  const TriangleMesh drum = drum_mesh(radius, length);
  EXPECT_EQ(open_edges(drum), 0);
  const double sector = 2 * std::numbers::pi / segments;
  const double cap = 0.5 * segments * radius * radius * std::sin(sector);
  const double side = segments * 2 * radius * std::sin(sector / 2) * length;
  EXPECT_NEAR(area(drum), 2 * cap + side, 1e-12 * side);
}

TEST(BenchMesh, TheSiloIsOpenAboveAndBelow) {
  const double bin = 0.03, height = 0.3, outlet = 0.012, drop = 0.03;
  const TriangleMesh silo = silo_mesh(bin, height, outlet, drop);
  EXPECT_EQ(open_edges(silo), 2 * 4 * 10);
  const double slope = std::hypot(drop, bin - outlet);
  EXPECT_NEAR(area(silo), 8 * bin * height + 4 * (bin + outlet) * slope, 1e-15);
}

TEST(BenchMesh, TheFileGivesTheSameNumbersBack) {
  const fs::path file = fs::temp_directory_path() / "scree_bench_mesh_test.stl";
  const TriangleMesh drum = drum_mesh(0.06, 0.18);
  write_text_file(file, stl_text("drum", drum));
  const TriangleMesh read = read_mesh(file.string());
  fs::remove(file);
  ASSERT_EQ(read.triangles, drum.triangles);
  ASSERT_EQ(read.vertices.size(), drum.vertices.size());
  for (std::size_t i = 0; i < drum.vertices.size(); ++i) {
    EXPECT_EQ(read.vertices[i].x, drum.vertices[i].x);
    EXPECT_EQ(read.vertices[i].y, drum.vertices[i].y);
    EXPECT_EQ(read.vertices[i].z, drum.vertices[i].z);
  }
}

}  // namespace
}  // namespace scree
