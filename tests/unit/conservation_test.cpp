// Momentum, angular momentum and the symmetries of space and time, in crowds of colliding spheres.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_books.h"

namespace scree {
namespace {

using namespace test;

/// A cloud of a thousand rough spheres of many sizes that falls in on itself.
std::string cloud_text(int count = 1000) {
  return R"(
[simulation]
end = 1
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [-0.1, -0.1, -0.1]
max = [0.1, 0.1, 0.1]
[contact]
rolling = "spring"
twisting = "spring"
[[materials]]
name = "grain"
density = 2500
stiffness = 50
restitution = 0.7
friction = 0.4
rolling_friction = 0.1
twisting_friction = 0.1
[[particles]]
name = "cloud"
material = "grain"
diameter = { distribution = "uniform", min = 1e-3, max = 2e-3 }
insert = "random"
count = )" +
         std::to_string(count) +
         R"(
region_min = [-0.009, -0.009, -0.009]
region_max = [0.009, 0.009, 0.009]
velocity = { type = "random", value = [0.1, -0.2, 0.3], deviation = 0.2 }
angular_velocity = [20, 30, -10]
)";
}

/// Books that close, and that fail to close when one of their channels is left out.
void expect_closed(const std::string& what, const Case& c, int steps, const std::vector<std::string>& channels) {
  SCOPED_TRACE(what);
  const Closure found = follow(c, {2, 1}, steps);
  EXPECT_LT(found.momentum, 1e-12);
  if (!c.domain.periodic[0]) {
    EXPECT_LT(found.angular, 1e-11);
  }
  for (const std::string& channel : channels) {
    const Closure wrong = follow(c, {2, 1}, steps / 4, {channel});
    EXPECT_GT(std::max(wrong.momentum, wrong.angular), 1e-6) << channel << " left out and not missed";
  }
}

TEST(Momentum, OfAThousandSpheresInFreeSpaceIsKept) {
  const Closure found = follow(case_of(cloud_text()), {2, 1}, 5000);
  EXPECT_GT(found.tally.impacts, 500);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.last.momentum[k], found.first.momentum[k], 1e-12 * norm(found.first.momentum));
    EXPECT_NEAR(found.last.angular_momentum[k], found.first.angular_momentum[k],
                1e-12 * norm(found.first.angular_momentum));
  }
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.angular, 1e-12);
}

const char* const room =
    "[[walls]]\nname = \"room\"\ntype = \"box\"\nmaterial = \"grain\"\nmin = [-0.01, -0.01, -0.01]\n"
    "max = [0.01, 0.01, 0.01]\n";

TEST(Momentum, IsBookedFromWallsFieldsAndBodies) {
  const std::vector<std::string> both = {"momentum_impulse", "angular_impulse"};
  expect_closed("walls", case_of(cloud_text() + room), 5000, both);
  const Overrides gravity = {"gravity.type=uniform", "gravity.acceleration=[1, -2, -9.81]"};
  expect_closed("gravity and walls", case_of(cloud_text(200) + room, gravity), 1000, both);
  expect_closed("gravity and buoyancy",
                case_of(cloud_text(200), {"gravity.type=uniform", "gravity.acceleration=[1, -2, -9.81]",
                                          "flow.type=still", "flow.density=1000", "flow.buoyancy=true"}),
                1000, both);
  expect_closed("gravity alone", case_of(cloud_text(200), gravity), 1000, both);
  expect_closed("drag",
                case_of(cloud_text(200), {"flow.type=shear", "flow.shear_rate=30", "flow.drag=schiller_naumann",
                                          "flow.density=1.2", "flow.viscosity=1e-3"}),
                1000, both);
  expect_closed(
      "central force",
      case_of(cloud_text(200), {"gravity.type=central", "gravity.center=[0, 0, 0.03]", "gravity.strength=1e-3"}), 1000,
      both);
  expect_closed("formula",
                case_of(cloud_text(200),
                        {"gravity.type=expression", "gravity.expression=[\"-100*x\", \"sin(100*t)\", \"50*y\"]"}),
                1000, both);
  expect_closed("rotating frame",
                case_of(cloud_text(200), {"gravity.type=rotating", "gravity.angular_velocity=[3, 5, -20]",
                                          "gravity.angular_acceleration=[0, 10, 40]"}),
                1000, both);
  expect_closed("periodic, with gravity",
                case_of(cloud_text(600), {"gravity.type=uniform", "gravity.acceleration=[1, 2, -3]",
                                          "domain.min=[-0.0095, -0.0095, -0.0095]",
                                          "domain.max=[0.0095, 0.0095, 0.0095]", "domain.periodic=[true, true, true]"}),
                1000, {"momentum_impulse"});
}

TEST(Momentum, IsBookedFromFixedAndPrescribedBodies) {
  const std::string bodies =
      "[[particles]]\nname = \"posts\"\nmaterial = \"grain\"\ndiameter = 4e-3\nmotion = \"fixed\"\ninsert = "
      "\"positions\"\n"
      "positions = [[0, 0, -0.0115], [0.002, 0, 0.0115]]\n"
      "[[particles]]\nname = \"piston\"\nmaterial = \"grain\"\ndiameter = 6e-3\nmotion = \"prescribed\"\n"
      "angular_velocity = [0, 50, 0]\ninsert = \"positions\"\npositions = [[0.014, 0, 0]]\nmotion_velocity = "
      "[\"-0.5*cos(100*t)\", \"0\", \"0.1\"]\n";
  expect_closed("bodies", case_of(cloud_text(300) + bodies), 1500, {"momentum_impulse", "angular_impulse"});
}

/// Positions and velocities by id.
std::vector<std::array<double, 6>> motions(const Simulation& s) {
  std::vector<std::array<double, 6>> out;
  const Particles& p = s.system().particles;
  for (const std::size_t i : test::rows_by_id(p)) {
    const double* m = p.motion.row(i);
    out.push_back({m[0], m[1], m[2], m[4], m[5], m[6]});
  }
  return out;
}

/// A few spheres given one by one, under a map of space: position, velocity and spin go the same way, but a mirror
/// turns spins once more.
std::string mapped_text(int permutation, bool mirror) {
  const auto row = [&](double x, double y, double z, bool axial) {
    const double v[3] = {mirror && !axial ? -x : x, mirror && axial ? -y : y, mirror && axial ? -z : z};
    std::array<std::string, 3> text;
    for (int k = 0; k < 3; ++k) text[static_cast<std::size_t>((k + permutation) % 3)] = std::to_string(v[k]);
    return "[" + text[0] + ", " + text[1] + ", " + text[2] + "]";
  };
  std::string text =
      "[simulation]\nend = 1\ntime_step = 1e-5\nmax_overlap = 0.9\n[domain]\nmin = [-0.05, -0.05, -0.05]\nmax = [0.05, "
      "0.05, 0.05]\n"
      "[contact]\nrolling = \"spring\"\ntwisting = \"spring\"\n"
      "[gravity]\ntype = \"uniform\"\nacceleration = " +
      row(1, -2, -9.81, false) +
      "\n[[materials]]\nname = \"grain\"\ndensity = 2500\nstiffness = 500\nrestitution = 0.7\nfriction = 0.4\n"
      "rolling_friction = 0.1\ntwisting_friction = 0.1\n"
      "[[walls]]\nname = \"box\"\ntype = \"box\"\nmaterial = \"grain\"\nmin = [-0.012, -0.012, -0.012]\nmax = [0.012, "
      "0.012, 0.012]\n";
  for (int i = 0; i < 27; ++i) {
    const double x = 0.007 * (i % 3 - 1), y = 0.007 * (i / 3 % 3 - 1), z = 0.007 * (i / 9 - 1);
    text += "[[particles]]\nmaterial = \"grain\"\ndiameter = " + std::to_string(0.004 + 0.0001 * (i % 7)) +
            "\ninsert = \"positions\"\npositions = [" + row(x, y, z, false) +
            "]\nvelocity = " + row(0.3 * std::sin(3 * i), 0.3 * std::sin(5 * i + 1), 0.3 * std::sin(7 * i + 2), false) +
            "\nangular_velocity = " + row(20 * std::sin(2 * i), 30 * std::cos(i), 10, true) + "\n";
  }
  return text;
}

/// Largest difference of all positions and velocities from those mapped.
double difference_under_map(int permutation, bool mirror) {
  Simulation one(case_of(mapped_text(0, false)), 1), other(case_of(mapped_text(permutation, mirror)), 1);
  advance(one, 3000);
  advance(other, 3000);
  EXPECT_GT(one.tally().impacts, 20);
  const auto a = motions(one), b = motions(other);
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t part = 0; part < 6; part += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const double expected = mirror && k == 0 ? -a[i][part + k] : a[i][part + k];
        const double found = b[i][part + (k + static_cast<std::size_t>(permutation)) % 3];
        worst = std::max(worst, std::abs(found - expected) / (part ? 0.3 : 0.01));
      }
  return worst;
}

TEST(Symmetry, OfMirrorAndAxes) {
  EXPECT_LT(difference_under_map(0, true), 1e-9);
  EXPECT_LT(difference_under_map(1, false), 1e-9);
  EXPECT_LT(difference_under_map(2, true), 1e-9);
}

TEST(Symmetry, OfFramesThatMoveSteadily) {
  Simulation rest(case_of(cloud_text(300)), 1);
  Simulation moving(case_of(cloud_text(300), {"particles.cloud.velocity.value=[0.6, 0.3, -0.7]"}), 1);
  advance(rest, 2000);
  advance(moving, 2000);
  EXPECT_GT(rest.tally().impacts, 100);
  EXPECT_EQ(rest.tally().impacts, moving.tally().impacts);
  const auto a = motions(rest), b = motions(moving);
  const double boost[3] = {0.5, 0.5, -1.0};
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(b[i][k] - boost[k] * rest.clock().now(), a[i][k], 1e-9);
      EXPECT_NEAR(b[i][3 + k] - boost[k], a[i][3 + k], 1e-7);
    }
}

}  // namespace
}  // namespace scree
