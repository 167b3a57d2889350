// Insertion against brute force: nothing overlaps, nothing leaves, the same case gives the same particles.
#include "scree/particles/insert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scree/base/error.h"
#include "scree/particles/insert_table.h"

namespace scree {
namespace {

using Placement = ParticleGroup::Placement;
using Start = ParticleGroup::Start;
constexpr double pi = 3.141592653589793;

InsertionSetting box(double side, bool periodic) {
  InsertionSetting s;
  s.domain = {{0, 0, 0}, {side, side, side}, {periodic, periodic, periodic}};
  s.seed = 42;
  return s;
}

ParticleGroup group_in(const InsertionSetting& s, Placement placement, double diameter, std::uint64_t count) {
  ParticleGroup g;
  g.name = "grains";
  g.density = 1000;
  g.sizes.value = diameter;
  g.placement = placement;
  g.region_min = s.domain.min;
  g.region_max = s.domain.max;
  g.count = count;
  return g;
}

/// The smallest distance of surfaces over all pairs, written anew: all images one by one.
double smallest_gap(const Particles& p, const Domain& domain) {
  double smallest = 1e300;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int image = 0; image < 27; ++image) {
        const int shift[3] = {image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1};
        double d2 = 0;
        bool possible = true;
        for (int k = 0; k < 3; ++k) {
          if (shift[k] && !domain.periodic[k]) possible = false;
          const double d = p.motion.row(j)[k] - p.motion.row(i)[k] + shift[k] * (domain.max[k] - domain.min[k]);
          d2 += d * d;
        }
        if (possible)
          smallest = std::min(smallest, std::sqrt(d2) - p.motion.row(i)[lane::radius] - p.motion.row(j)[lane::radius]);
      }
  return smallest;
}

std::string message_of(const std::vector<ParticleGroup>& groups, const InsertionSetting& setting) {
  try {
    insert_particles(groups, setting);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

void expect_has(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\n not in\n" << text;
}

TEST(Insert, RowsHoldWhatTheFieldsSay) {
  const InsertionSetting s = box(1, false);
  ParticleGroup a = group_in(s, Placement::given, 0.1, 0), b = group_in(s, Placement::given, 0.2, 0);
  a.given = {{{0.1, 0.2, 0.3}, {}, {}, {}}, {{0.5, 0.5, 0.5}, {{7, 8, 9}}, {{1, 2, 3}}, 0.3}};
  a.velocity = {1, 2, 3};
  a.angular_velocity = {4, 5, 6};
  a.effect_gap = 0.02;
  b.given = {{{0.8, 0.8, 0.8}, {}, {}, {}}};
  b.material = 2;
  b.free = false;
  b.density = 2000;
  const Particles p = insert_particles({a, b}, s);
  ASSERT_EQ(p.size(), 3u);
  const double m0 = 1000 * pi / 6 * 1e-3;
  const double want[8] = {0.1, 0.2, 0.3, 0.05, 1, 2, 3, 1 / m0};
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(p.motion.row(0)[k], want[k], 1e-12 * std::abs(want[k])) << k;
  const double spin[4] = {0.2, 0.25, 0.3, 20};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(p.spin.row(0)[k], spin[k], 1e-14);
  EXPECT_NEAR(p.mass[0], m0, 1e-15);
  EXPECT_EQ(p.effect_excess[0], 0.01);
  EXPECT_EQ(p.motion.row(1)[lane::vy], 8);
  EXPECT_EQ(p.motion.row(1)[lane::radius], 0.15);
  EXPECT_NEAR(p.spin.row(1)[2], 0.45, 1e-15);
  EXPECT_EQ(p.motion.row(2)[lane::inverse_mass], 0);
  EXPECT_NEAR(p.mass[2], 2000 * pi / 6 * 8e-3, 1e-13);
  EXPECT_EQ(p.material[2], 2);
  EXPECT_EQ(p.effect_excess[2], 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(p.id[i], i);
    EXPECT_EQ(p.group[i], i / 2);
    EXPECT_EQ(p.image.row(i)[0], 0);
  }
}

TEST(Insert, LatticeWithSpacingFillsRowsFromTheCorner) {
  const InsertionSetting s = box(1, false);
  ParticleGroup g = group_in(s, Placement::lattice, 0.2, 0);
  g.spacing = 0.25;
  Particles p = insert_particles({g}, s);
  ASSERT_EQ(p.size(), 64u);
  EXPECT_EQ(p.motion.row(0)[0], 0.125);
  EXPECT_EQ(p.motion.row(1)[0], 0.375);
  EXPECT_EQ(p.motion.row(4)[1], 0.375);
  EXPECT_EQ(p.motion.row(63)[2], 0.875);
  g.count = 17;  // one full layer and one more
  p = insert_particles({g}, s);
  ASSERT_EQ(p.size(), 17u);
  EXPECT_EQ(p.motion.row(15)[2], 0.125);
  EXPECT_EQ(p.motion.row(16)[2], 0.375);
  g.count = 65;
  expect_has(message_of({g}, s), {"'grains'", "64 of 65", "help"});
  g.count = 8;
  g.spacing = 0.19;
  expect_has(message_of({g}, s), {"0.19 m apart along x", "up to 0.2 m", "help"});
}

TEST(Insert, LatticeFillsARegionEvenly) {
  InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::lattice, 0.02, 1000);
  g.region_min = {0.2, 0.2, 0.2};
  g.region_max = {0.6, 0.6, 0.4};
  Particles p = insert_particles({g}, s);
  ASSERT_EQ(p.size(), 1000u);
  double mean[3] = {};
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p.motion.row(i)[k], g.region_min[k] + 0.01);
      EXPECT_LE(p.motion.row(i)[k], g.region_max[k] - 0.01);
      mean[k] += p.motion.row(i)[k] / 1000;
    }
  EXPECT_NEAR(mean[0], 0.4, 0.005);
  EXPECT_NEAR(mean[1], 0.4, 0.005);
  EXPECT_NEAR(mean[2], 0.3, 0.005);
  g.region_max = {0.6, 0.6, 0.2};  // a flat region holds one layer
  g.count = 100;
  p = insert_particles({g}, s);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p.motion.row(i)[2], 0.2);
  EXPECT_GT(smallest_gap(p, s.domain), 0.019);
}

// The jitter is a bound that is nearly reached and never passed.
TEST(Insert, FullJitterNeverOverlaps) {
  const InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::lattice, 0.08, 1000);
  g.jitter = 1;
  const Particles p = insert_particles({g}, s);
  const double gap = smallest_gap(p, s.domain);
  EXPECT_GE(gap, -1e-15);
  EXPECT_LT(gap, 0.005);
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double cells = p.motion.row(i)[k] / 0.1;
      farthest = std::max(farthest, 0.1 * std::abs(cells - std::floor(cells) - 0.5));
      EXPECT_GE(p.motion.row(i)[k], 0.0);
      EXPECT_LT(p.motion.row(i)[k], 1.0);
    }
  EXPECT_LE(farthest, 0.01 + 1e-15);
  EXPECT_GT(farthest, 0.0099);
}

TEST(Insert, RandomPlacesDoNotOverlap) {
  for (const bool periodic : {true, false}) {
    const InsertionSetting s = box(1, periodic);
    ParticleGroup coarse = group_in(s, Placement::random, 0.12, 60);
    ParticleGroup fine = group_in(s, Placement::random, 0.0, 900);
    fine.sizes.kind = SizeDistribution::Kind::uniform;
    fine.sizes.min = 0.02;
    fine.sizes.max = 0.08;
    const Particles p = insert_particles({coarse, fine}, s);
    ASSERT_EQ(p.size(), 960u);
    EXPECT_GE(smallest_gap(p, s.domain), 0.0);
    bool crosses = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_EQ(p.id[i], static_cast<std::int64_t>(i));
      const double* m = p.motion.row(i);
      for (int k = 0; k < 3; ++k) {
        crosses = crosses || m[k] < m[3] || m[k] > 1 - m[3];
        EXPECT_TRUE(m[k] >= 0 && m[k] < 1);
      }
    }
    EXPECT_EQ(crosses, periodic);
  }
}

// Sizes go with the number of the particle, not with the order in which places are found.
TEST(Insert, DiametersFollowTheNumbers) {
  const InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::random, 0.0, 200);
  g.sizes.kind = SizeDistribution::Kind::uniform;
  g.sizes.min = 0.02;
  g.sizes.max = 0.08;
  const Particles p = insert_particles({g}, s), q = insert_particles({g}, s);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_EQ(2 * p.motion.row(i)[lane::radius], draw_diameter(g.sizes, s.seed, 0, i));
    for (int k = 0; k < 8; ++k) EXPECT_EQ(p.motion.row(i)[k], q.motion.row(i)[k]);
  }
}

TEST(Insert, SolidFractionSetsTheCount) {
  const InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::random, 0.0, 0);
  g.solid_fraction = 0.25;
  g.sizes.kind = SizeDistribution::Kind::uniform;
  g.sizes.min = 0.06;
  g.sizes.max = 0.1;
  const Particles p = insert_particles({g}, s);
  double volume = 0;
  for (std::size_t i = 0; i < p.size(); ++i) volume += p.mass[i] / 1000;
  EXPECT_NEAR(volume, 0.25, 0.5 * pi / 6 * 1e-3);
  EXPECT_GE(smallest_gap(p, s.domain), 0.0);
}

TEST(Insert, ACrowdIsRefusedWithNumbers) {
  const InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::random, 0.2, 100);  // a solid fraction of 0.42
  g.attempts = 50;
  expect_has(message_of({g}, s), {"'grains'", "of 100 particles", "of the 0.419 wanted", "attempts", "help"});
  g.sizes.value = 1.2;
  const InsertionSetting walled = box(1, false);
  expect_has(message_of({g}, walled), {"do not fit into the region", "1 m wide along x"});
}

TEST(Insert, RandomPlacesKeepClearOfWalls) {
  InsertionSetting s = box(1, true);
  Walls walls;
  walls.names = {"floor", "block"};
  walls.faces = {sc_wall_plane({0, 0, 0.3}, {0, 0, 1}),
                 sc_wall_block(SC_WALL_SOLID_BOX, {0.4, 0.4, 0.3}, {0.7, 0.7, 0.8})};
  walls.faces[1].body = 1;
  walls.poses.resize(2, sc_wall_at_home());
  plant_trees(walls);
  s.walls = &walls;
  const ParticleGroup g = group_in(s, Placement::random, 0.05, 500);
  const Particles p = insert_particles({g}, s);
  double lowest = 1, closest = 1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double* m = p.motion.row(i);
    lowest = std::min(lowest, m[2]);
    double d2 = 0;
    const double low[3] = {0.4, 0.4, 0.3}, high[3] = {0.7, 0.7, 0.8};
    for (int k = 0; k < 3; ++k) {
      const double d = std::max({low[k] - m[k], m[k] - high[k], 0.0});
      d2 += d * d;
    }
    closest = std::min(closest, std::sqrt(d2));
  }
  EXPECT_GE(lowest, 0.325);
  EXPECT_GE(closest, 0.025);
  EXPECT_LT(lowest, 0.34);
  EXPECT_LT(closest, 0.04);
}

TEST(Insert, RoomsHoldTheirParticles) {
  InsertionSetting s = box(1, false);
  Walls walls;
  walls.names = {"tank"};
  walls.rooms = {{{0.2, 0.2, 0.2}, {0.5, 0.5, 0.5}, 0}};
  s.walls = &walls;
  ParticleGroup g = group_in(s, Placement::random, 0.05, 20);
  const Particles p = insert_particles({g}, s);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p.motion.row(i)[k], 0.225);
      EXPECT_LE(p.motion.row(i)[k], 0.475);
    }
  g.placement = Placement::given;
  g.given = {{{0.3, 0.3, 0.3}, {}, {}, {}}, {{0.3, 0.3, 0.6}, {}, {}, {}}};
  expect_has(message_of({g}, s), {"particle 1 ", "(0.3, 0.3, 0.6)", "outside the box 'tank'"});
}

TEST(Insert, BadPlacesAreRefusedByName) {
  InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::given, 0.1, 0);
  g.given = {{{0.5, 0.5, 0.5}, {}, {}, {}}, {{0.5, 1.5, 0.5}, {}, {}, {}}};
  expect_has(message_of({g}, s), {"particle 1 (group 'grains')", "(0.5, 1.5, 0.5) m", "outside the domain", "along y"});
  g.given = {{{0.02, 0.5, 0.5}, {}, {}, {}}, {{0.95, 0.5, 0.5}, {}, {}, {}}};  // 0.07 apart across the boundary
  expect_has(message_of({g}, s), {"particle 0", "particle 1", "overlap by 60 %"});
  g.given[1].position[0] = 0.9225;  // 0.0975 apart: 5 % of the radius
  EXPECT_EQ(message_of({g}, s), "");
  Walls walls;
  walls.names = {"floor"};
  walls.faces = {sc_wall_plane({0, 0, 0.48}, {0, 0, 1})};
  walls.poses = {sc_wall_at_home()};
  plant_trees(walls);
  s.walls = &walls;
  expect_has(message_of({g}, s), {"particle 0", "in the wall 'floor'", "60 % of its radius"});
  g.free = false;  // fixed particles may be anywhere
  EXPECT_EQ(message_of({g}, s), "");
}

TEST(Insert, APlaceOnTheUpperEndOfAPeriodIsTheLowerEnd) {
  const InsertionSetting s = box(1, true);
  ParticleGroup g = group_in(s, Placement::given, 0.1, 0);
  g.given = {{{1.0, 0.5, 0.5}, {}, {}, {}}};
  EXPECT_EQ(insert_particles({g}, s).motion.row(0)[0], 0.0);
}

TEST(Insert, StartVelocities) {
  InsertionSetting s = box(1, true);
  s.fluid = [](const std::array<double, 3>& x) { return std::array<double, 3>{x[1], -x[0], 2 * x[2]}; };
  ParticleGroup g = group_in(s, Placement::lattice, 0.005, 20000);
  g.start = Start::fluid;
  Particles p = insert_particles({g}, s);
  for (std::size_t i = 0; i < p.size(); i += 997) {
    const double* m = p.motion.row(i);
    EXPECT_EQ(m[lane::vx], m[1]);
    EXPECT_EQ(m[lane::vy], -m[0]);
    EXPECT_EQ(m[lane::vz], 2 * m[2]);
  }
  g.start = Start::random;
  g.velocity = {1, -2, 3};
  g.velocity_deviation = 0.5;
  p = insert_particles({g}, s);
  for (int k = 0; k < 3; ++k) {
    double mean = 0, square = 0, mixed = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double* v = p.motion.row(i) + lane::vx;
      mean += v[k] / 20000;
      square += (v[k] - g.velocity[k]) * (v[k] - g.velocity[k]) / 20000;
      mixed += (v[k] - g.velocity[k]) * (v[(k + 1) % 3] - g.velocity[(k + 1) % 3]) / 20000;
    }
    // Standard errors: 0.5/sqrt(n) = 0.0035; 0.25 sqrt(2/n) = 0.0025; 0.25/sqrt(n) = 0.0018.
    EXPECT_NEAR(mean, g.velocity[k], 0.015);
    EXPECT_NEAR(square, 0.25, 0.01);
    EXPECT_NEAR(mixed, 0.0, 0.007);
  }
}

class TableFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "scree_table_XXXXXX").string();
    directory_ = mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string write(const std::string& text) {
    const std::string path = directory_ + "/grains.csv";
    std::ofstream(path) << text;
    return path;
  }

  std::string message(const std::string& text) {
    const std::string path = write(text);
    try {
      read_particle_table(path);
    } catch (const InputError& e) {
      return std::string(e.what()).substr(directory_.size() + 1);
    }
    return "";
  }

  std::string directory_;
};

TEST_F(TableFile, ColumnsInAnyOrder) {
  const auto rows =
      read_particle_table(write("# made by hand\r\n diameter, z ,y,x, vz,vy,vx\r\n\r\n0.001,3,2,1,0.3,+0.2,-1e-1\r\n# "
                                "end\r\n2e-3,6,5,4,0,0,0\r\n"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].position, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(*rows[0].velocity, (std::array<double, 3>{-0.1, 0.2, 0.3}));
  EXPECT_FALSE(rows[0].angular_velocity);
  EXPECT_EQ(*rows[0].diameter, 0.001);
  EXPECT_EQ(rows[1].position, (std::array<double, 3>{4, 5, 6}));
  const auto plain = read_particle_table(write("x,y,z,wx,wy,wz\n1,2,3,4,5,6"));
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_EQ(*plain[0].angular_velocity, (std::array<double, 3>{4, 5, 6}));
  EXPECT_FALSE(plain[0].velocity || plain[0].diameter);
}

TEST_F(TableFile, ErrorsNameFileAndLine) {
  expect_has(message(""), {"grains.csv:0: error: the file is empty", "x,y,z"});
  expect_has(message("x;y;z\n0,5;1;2\n"),
             {"grains.csv:1: error: the columns are separated by semicolons", "by commas"});
  expect_has(message("# made by hand\nx\ty\tz\n"), {"grains.csv:2: error: the columns are separated by tabs"});
  expect_has(message("x,y,q\n"), {"grains.csv:1: error: unknown column 'q'", "columns are x, y, z, vx"});
  expect_has(message("x,y,z,x\n"), {"grains.csv:1: error: column 'x' occurs twice"});
  expect_has(message("x,z\n"), {"grains.csv:1: error: columns x, y, z must all be there"});
  expect_has(message("x,y,z,vx\n"), {"grains.csv:1: error: columns vx, vy, vz must all be there, or none"});
  expect_has(message("x,y,z\n1,2,3\n\n1,2\n"), {"grains.csv:4: error: 2 values", "3 columns"});
  expect_has(message("x,y,z\n1,2,3mm\n"), {"grains.csv:2: error: '3mm' in column z is not a number"});
  expect_has(message("x,y,z\n1,,3\n"), {"grains.csv:2: error: '' in column y is not a number"});
  expect_has(message("x,y,z\n1,nan,3\n"), {"grains.csv:2: error: 'nan' in column y is not a number"});
  expect_has(message("x,y,z,diameter\n1,2,3,0\n"), {"grains.csv:2: error: diameter 0 is not positive"});
  EXPECT_THROW(read_particle_table(directory_ + "/absent.csv"), InputError);
}

}  // namespace
}  // namespace scree
