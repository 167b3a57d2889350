// How bodies are turned: closed forms of directions that are alike, spread over a plane, a cone, a sphere.
#include "scree/analysis/axis_order.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_by_hand.h"
#include "scree/physics/rotation.h"

namespace scree {
namespace {

using namespace test;

constexpr double pi = 3.141592653589793;
const Region everywhere = {{-1, -1, -1}, {1, 1, 1}};
const Axes rod = {1, 1, 4};

/// The turn from z to a direction of length one.
sc_quat turn_from_z(const sc_vec& u) {
  const double across = std::hypot(u.x, u.y), angle = std::atan2(across, u.z);
  if (across == 0) return angle > 0 ? sc_make_quat(0, 1, 0, 0) : sc_unit_quat();
  return sc_quat_of_turn(sc_make_vec(-angle * u.y / across, angle * u.x / across, 0));
}

/// Bodies of one form at the origin whose z lie along the given directions.
struct Bodies {
  Forms forms{sphere_form()};
  Particles particles{true};

  Bodies(const Axes& half_axes, const std::vector<sc_vec>& directions) {
    forms.push_back(make_form(half_axes, 1, 1));
    set_grains(particles, std::vector<Grain>(directions.size()));
    for (std::size_t i = 0; i < directions.size(); ++i) {
      particles.form[i] = 1;
      const sc_quat q = turn_from_z(directions[i]);
      const double row[4] = {q.w, q.x, q.y, q.z};
      std::copy_n(row, 4, particles.orientation.row(i));
    }
  }

  AxisOrder order(const Region& region = everywhere) const { return axis_order(region, particles, forms); }
};

/// Evenly over the part of the sphere above a height: equal steps of height, golden steps of angle.
std::vector<sc_vec> above(double height, int count) {
  std::vector<sc_vec> out;
  for (int k = 0; k < count; ++k) {
    const double z = height + (1 - height) * (k + 0.5) / count, across = std::sqrt(1 - z * z);
    const double angle = pi * (3 - std::sqrt(5.0)) * k;
    out.push_back(sc_make_vec(across * std::cos(angle), across * std::sin(angle), z));
  }
  return out;
}

TEST(AxisOrder, OfParallelBodiesIsOne) {
  const sc_vec u = sc_make_vec(0.48, 0.6, 0.64);
  // An axis has no head: half of them are turned over.
  const AxisOrder order = Bodies(rod, {u, sc_scale(-1, u), u, sc_scale(-1, u)}).order();
  EXPECT_NEAR(order.nematic, 1, 1e-14);
  EXPECT_NEAR(order.cos2[0], 0.48 * 0.48, 1e-15);
  EXPECT_NEAR(order.cos2[1], 0.36, 1e-15);
  EXPECT_NEAR(order.cos2[2], 0.64 * 0.64, 1e-15);
}

TEST(AxisOrder, AlongThreeAxesAlikeIsNone) {
  const AxisOrder order = Bodies(rod, {sc_make_vec(1, 0, 0), sc_make_vec(0, 1, 0), sc_make_vec(0, 0, 1)}).order();
  EXPECT_NEAR(order.nematic, 0, 1e-14);
  for (const double c : order.cos2) EXPECT_NEAR(c, 1.0 / 3, 1e-15);
}

/// In a plane, whose normal is (1, 1, 1)/sqrt(3), all directions alike: eigenvalues 1/4, 1/4, -1/2.
TEST(AxisOrder, OfATiltedPlaneIsAQuarter) {
  std::vector<sc_vec> directions;
  for (int k = 0; k < 7; ++k) {
    const double c = std::cos(pi * k / 7) / std::sqrt(2.0), s = std::sin(pi * k / 7) / std::sqrt(6.0);
    directions.push_back(sc_make_vec(c + s, s - c, -2 * s));
  }
  const AxisOrder order = Bodies(rod, directions).order();
  EXPECT_NEAR(order.nematic, 0.25, 1e-14);
  for (const double c : order.cos2) EXPECT_NEAR(c, 1.0 / 3, 1e-14);
}

/// All directions of a cone whose half angle has the cosine h: mean cos^2 (1 + h + h^2)/3, order h (1 + h)/2.
TEST(AxisOrder, OfAConeIsWhatItsAngleSays) {
  for (const double h : {0.0, 0.5, 0.9}) {
    const AxisOrder order = Bodies(rod, above(h, 4000)).order();
    EXPECT_NEAR(order.nematic, h * (1 + h) / 2, 2e-3) << h;
    EXPECT_NEAR(order.cos2[2], (1 + h + h * h) / 3, 1e-6) << h;
  }
}

TEST(AxisOrder, IsThatOfTheAxisWhichDiffers) {
  EXPECT_EQ(distinct_axis(make_form({1, 1, 4}, 0.5, 1)), 2);
  EXPECT_EQ(distinct_axis(make_form({3, 1, 1}, 1, 1)), 0);
  EXPECT_EQ(distinct_axis(make_form({2, 0.5, 2}, 1, 1)), 1);  // a disc
  EXPECT_EQ(distinct_axis(make_form({1, 1.2, 2}, 1, 1)), 2);
  EXPECT_EQ(distinct_axis(make_form({1, 1.8, 2}, 1, 1)), 0);
  EXPECT_EQ(distinct_axis(make_form({1.25, 1, 0.8}, 1, 1)), 0);  // between rod and disc
  EXPECT_EQ(distinct_axis(make_form({0.8, 1, 1.25}, 1, 1)), 2);
  EXPECT_EQ(distinct_axis(make_form({1, 1, 1}, 0.2, 0.2)), -1);
  EXPECT_EQ(distinct_axis(sphere_form()), -1);
}

TEST(AxisOrder, CountsBodiesThatCanMoveWithTheirCentreInTheBox) {
  Bodies bodies(rod, {sc_make_vec(0, 0, 1), sc_make_vec(1, 0, 0), sc_make_vec(1, 0, 0), sc_make_vec(1, 0, 0)});
  bodies.particles.motion.row(1)[0] = 1;                   // on the upper face
  bodies.particles.motion.row(2)[lane::inverse_mass] = 0;  // held
  bodies.particles.form[3] = 0;                            // a sphere
  EXPECT_EQ(bodies.order().cos2[2], 1);
  EXPECT_NEAR(bodies.order().nematic, 1, 1e-15);
  const AxisOrder none = bodies.order({{-1, -1, 0.5}, {1, 1, 1}});
  EXPECT_TRUE(std::isnan(none.nematic) && std::isnan(none.cos2[0]));
}

}  // namespace
}  // namespace scree
