// Walls as triangles: their areas and places against closed forms, and the files of the frames.
#include "scree/app/wall_surface.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine_cases.h"
#include "scree/base/atomic_file.h"
#include "scree/output/hdf5_file.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

WallSurface surface_of(const std::string& wall, double time = 0) {
  Simulation s(case_of("[simulation]\nend = 10\ntime_step = 1e-3\n[domain]\nmin = [-1, -2, -3]\nmax = [1, 2, 3]\n"
                       "[[materials]]\nname = \"steel\"\ndensity = 2000\nstiffness = 1\n"
                       "[[particles]]\nmaterial = \"steel\"\ndiameter = 0.2\ninsert = \"positions\"\n"
                       "positions = [[-0.5, -0.5, 2]]\n[[walls]]\nmaterial = \"steel\"\n" +
                       wall),
               {1, 1});
  advance(s, static_cast<int>(std::lround(time / 1e-3)));
  s.sample();
  return wall_surface(s.system().walls, s.system().domain);
}

sc_vec point(const WallSurface& surface, std::int32_t number) {
  const double* x = &surface.points[3 * static_cast<std::size_t>(number)];
  return sc_make_vec(x[0], x[1], x[2]);
}

double area(const WallSurface& surface) {
  double sum = 0;
  for (std::size_t k = 0; k < surface.triangles.size(); k += 3) {
    const sc_vec a = point(surface, surface.triangles[k]);
    sum += 0.5 * sc_norm(sc_cross(sc_sub(point(surface, surface.triangles[k + 1]), a),
                                  sc_sub(point(surface, surface.triangles[k + 2]), a)));
  }
  return sum;
}

TEST(WallSurface, AreasAreThoseOfTheShapes) {
  EXPECT_NEAR(area(surface_of("type = \"plane\"\npoint = [0, 0, -3]\nnormal = [0, 0, 1]\n")), 8, 1e-6);
  EXPECT_NEAR(area(surface_of("type = \"plane\"\npoint = [0, 0, 0]\nnormal = [1, 0, 1]\n")), 8 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(area(surface_of("type = \"box\"\nmin = [-1, -2, -3]\nmax = [1, 2, 3]\n")), 88, 1e-12);
  EXPECT_NEAR(area(surface_of("type = \"box\"\nside = \"outside\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n")), 6, 1e-12);
  EXPECT_NEAR(area(surface_of("type = \"rectangle\"\nmin = [0, 0, 1]\nmax = [1, 0.5, 1]\n")), 0.5, 1e-12);
  EXPECT_NEAR(area(surface_of("type = \"plate\"\ncorner = [0, 0, 0]\nedge_a = [0.3, 0.4, 0]\nedge_b = [0, 0, 2]\n")), 1,
              1e-12);
  // 64 chords of a circle are shorter than it by 4e-4.
  EXPECT_NEAR(area(surface_of("type = \"cylinder\"\nstart = [0, 0, 0]\nend = [0, 0, 2]\nradius = 0.5\n")),
              2 * std::numbers::pi, 1e-2);
  EXPECT_NEAR(area(surface_of("type = \"cone\"\nstart = [0, 0, 0]\nend = [0, 0, 0]\nstart_radius = 0\n"
                              "end_radius = 1\naxis = [0, 1, 0]\n")),
              std::numbers::pi, 1e-2);
}

TEST(WallSurface, GoesWithTheWallAndAppearsWithIt) {
  const std::string plate = "type = \"plate\"\ncorner = [0, 0, 0]\nedge_a = [1, 0, 0]\nedge_b = [0, 1, 0]\n";
  const WallSurface turned = surface_of(
      plate + "motion = { type = \"rotation\", axis = [0, 0, 1], point = [0, 0, 0], angular_velocity = 0.5 }\n", 0.4);
  const sc_vec corner = point(turned, 1);
  EXPECT_NEAR(corner.x, std::cos(0.2), 1e-12);
  EXPECT_NEAR(corner.y, std::sin(0.2), 1e-12);
  EXPECT_TRUE(surface_of(plate + "from = 0.1\n", 0.05).wall.empty());
  EXPECT_EQ(surface_of(plate + "from = 0.1\n", 0.15).wall.size(), 2u);
}

TEST(WallSurface, TrianglesOfAMeshShareTheirCorners) {
  // A square of two triangles, and another wall of one triangle with the same first corner.
  const WallSurface surface = surface_of(
      "name = \"square\"\ntype = \"triangles\"\n"
      "vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0], [1, 1, 0], [0, 1, 0]]\n[[walls]]\nname = \"flag\"\n"
      "type = \"triangles\"\nmaterial = \"steel\"\nvertices = [[0, 0, 0], [0, 0, 1], [0, 1, 1]]\n");
  EXPECT_EQ(surface.points.size(), 3u * (4 + 3));
  EXPECT_EQ(surface.wall, (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_NEAR(area(surface), 1.5, 1e-12);
}

TEST(SurfaceWriter, WritesWhatHasMovedAndGoesOn) {
  const fs::path directory = fs::path(::testing::TempDir()) / "scree_wall_surface";
  fs::remove_all(directory);
  fs::create_directories(directory / "frames");
  const WallSurface here{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}, {0}};
  WallSurface there = here;
  there.points[2] = 0.5;
  const auto file = [&](int number) { return fs::exists(directory / fmt::format("walls/walls_{:06}.h5", number)); };
  SurfaceWriter writer = SurfaceWriter::create(directory);
  writer.write(0, 0, here);
  writer.write(0.1, 1, here);
  writer.write(0.2, 2, there);
  const std::string three = read_text_file(directory / "walls.xdmf");
  writer.write(0.3, 3, here);
  const std::string all = read_text_file(directory / "walls.xdmf");
  EXPECT_TRUE(file(0) && !file(1) && file(2) && file(3));
  // Triangles are written once, and again where they have changed.
  const auto holds = [&](int number, const char* dataset) {
    const auto names = Hdf5File::open(directory / fmt::format("walls/walls_{:06}.h5", number)).names("/");
    return std::find(names.begin(), names.end(), dataset) != names.end();
  };
  EXPECT_TRUE(holds(0, "triangles") && holds(0, "wall") && !holds(2, "triangles") && !holds(3, "wall"));
  SurfaceWriter again = SurfaceWriter::resume(directory, 0.25);
  EXPECT_EQ(read_text_file(directory / "walls.xdmf"), three);
  EXPECT_TRUE(file(0) && !file(1) && file(2) && !file(3));
  again.write(0.3, 3, here);
  EXPECT_EQ(read_text_file(directory / "walls.xdmf"), all);
  again.write(0.4, 4, WallSurface{here.points, {0, 2, 1}, {0}});
  EXPECT_TRUE(!holds(3, "triangles") && holds(4, "triangles"));
  fs::remove_all(directory);
}

}  // namespace
}  // namespace scree
