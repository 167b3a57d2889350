// Particles that are no spheres in the engine: made, moved, sampled, saved.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine_cases.h"
#include "scree/analysis/measure.h"
#include "scree/app/take_over.h"
#include "scree/particles/orientations.h"
#include "scree/particles/sizes.h"

namespace scree {
namespace {

using test::case_of;

const std::string open_box = R"(
[simulation]
end = 10
time_step = 1e-3
[domain]
min = [0, 0, 0]
max = [10, 10, 10]
periodic = [true, true, true]
[[materials]]
name = "glass"
density = 2000
stiffness = 1e5
)";

const std::string one_body = open_box + R"(
[[particles]]
name = "top"
material = "glass"
shape = "superellipsoid"
half_axes = [0.3, 0.2, 0.1]
exponents = [0.6, 0.8]
insert = "positions"
positions = [[5, 5, 5]]
velocity = [0.3, 0.2, 0.1]
angular_velocity = [1, 2, -1]
orientation = { type = "given", axis = [1, 1, 0], angle = "40 deg" }
)";

Team one_thread() { return Team{1}; }

sc_quat orientation_of(const Particles& p, std::size_t i) {
  const double* q = p.orientation.row(i);
  return {q[0], q[1], q[2], q[3]};
}

TEST(ShapeMotion, ParticleHasVolumeAndInertiaOfItsShape) {
  Simulation s(case_of(one_body), one_thread());
  const Particles& p = s.system().particles;
  ASSERT_TRUE(p.shaped());
  const Axes axes{0.3, 0.2, 0.1};
  const double mass = 2000 * superellipsoid_volume(axes, 0.6, 0.8);
  const Axes inertia = superellipsoid_inertia(axes, 0.6, 0.8);
  EXPECT_NEAR(p.mass[0] / mass, 1, 1e-13);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(p.inertia.row(0)[k] * mass * inertia[k], 1, 1e-13);
  EXPECT_NEAR(p.motion.row(0)[lane::radius], bounding_radius(axes, 0.6, 0.8), 1e-15);
  EXPECT_NEAR(sphere_volume(2 * p.radius_by_volume(0)) / superellipsoid_volume(axes, 0.6, 0.8), 1, 1e-13);
  const sc_vec turn = sc_turn(sc_quat_mat(orientation_of(p, 0)), {0, 0, 1});
  EXPECT_NEAR(turn.z, std::cos(40 * std::numbers::pi / 180), 1e-15);
}

TEST(ShapeMotion, SpheresHaveNoFieldsOfShapes) {
  std::string text = one_body;
  text.replace(text.find("shape ="), text.find("insert =") - text.find("shape ="), "diameter = 0.2\n");
  text.erase(text.find("orientation ="));
  Simulation s(case_of(text), one_thread());
  EXPECT_FALSE(s.system().particles.shaped());
  EXPECT_TRUE(s.system().particles.orientation.values.empty());
  EXPECT_TRUE(s.system().forms.empty());
}

TEST(ShapeMotion, FreeBodyKeepsMomentumAndItsEnergyStaysBounded) {
  Simulation s(case_of(one_body), one_thread());
  const Fields none;
  const Measured start = measure(s.sample(), none, 0, {});
  double largest = 0;
  for (int k = 0; k < 2000; ++k) {
    s.step();
    if (k % 10) continue;
    const Measured now = measure(s.sample(), none, 0, {});
    largest = std::max(largest, std::abs(now.rotational / start.rotational - 1));
    EXPECT_EQ(now.kinetic, start.kinetic);
  }
  EXPECT_GT(largest, 1e-12);  // it tumbles
  EXPECT_LT(largest, 2e-6);
  const double* l = s.system().particles.angular_momentum.row(0);
  Simulation fresh(case_of(one_body), one_thread());
  for (int k = 0; k < 3; ++k) EXPECT_EQ(l[k], fresh.system().particles.angular_momentum.row(0)[k]);
}

TEST(ShapeMotion, OrientationOfTheEngineIsThatOfFreeRotation) {
  Simulation s(case_of(one_body), one_thread());
  const Particles& p = s.system().particles;
  sc_quat q = orientation_of(p, 0);
  const double *l = p.angular_momentum.row(0), *inertia = p.inertia.row(0);
  const sc_vec momentum{l[0], l[1], l[2]}, inverse{inertia[0], inertia[1], inertia[2]};
  for (int k = 0; k < 500; ++k) {
    q = sc_rotate_freely(q, momentum, inverse, 1e-3);
    s.step();
  }
  const sc_quat found = orientation_of(s.system().particles, 0);
  EXPECT_EQ(found.w, q.w);
  EXPECT_EQ(found.x, q.x);
  EXPECT_EQ(found.y, q.y);
  EXPECT_EQ(found.z, q.z);
}

TEST(ShapeMotion, WayOfTheSurfaceIsAnUpperBoundAndClose) {
  Simulation s(case_of(one_body), one_thread());
  const sc_quat before = orientation_of(s.system().particles, 0);
  const double radius = s.system().particles.motion.row(0)[lane::radius];
  s.step();
  const Particles& p = s.system().particles;
  const sc_mat a = sc_quat_mat(before), b = sc_quat_mat(orientation_of(p, 0));
  double frobenius2 = 0;
  for (const sc_vec& d : {sc_sub(a.x, b.x), sc_sub(a.y, b.y), sc_sub(a.z, b.z)}) frobenius2 += sc_dot(d, d);
  const double centre = 1e-3 * std::sqrt(0.09 + 0.04 + 0.01);
  const double exact = centre + radius * std::sqrt(frobenius2 / 2);
  EXPECT_GE(p.angular_momentum.row(0)[lane::path], exact);
  EXPECT_LT(p.angular_momentum.row(0)[lane::path], 1.00001 * exact);
}

TEST(ShapeMotion, FixedBodyTurnsAsPrescribed) {
  std::string text = one_body + "motion = \"prescribed\"\nmotion_velocity = [\"0.5\", \"0\", \"0\"]\n";
  text.replace(text.find("velocity = [0.3, 0.2, 0.1]\n"), 27, "");
  text.replace(text.find("[1, 2, -1]"), 10, "[0, 0, 2]");
  text.erase(text.find("orientation ="), text.find("motion =") - text.find("orientation ="));
  Simulation s(case_of(text), one_thread());
  test::advance(s, 500);
  const sc_quat q = orientation_of(s.system().particles, 0);
  EXPECT_NEAR(2 * std::atan2(q.z, q.w), 2 * 0.5, 1e-12);
  EXPECT_NEAR(s.system().particles.motion.row(0)[0], 5.25, 1e-12);
  const double* spin = s.system().particles.spin.row(0);
  EXPECT_NEAR(spin[2] * spin[3], 2, 1e-15);
}

TEST(ShapeMotion, SphereAmongShapesMovesAsAmongSpheres) {
  const std::string sphere = R"(
[[particles]]
name = "ball"
material = "glass"
diameter = 0.2
insert = "positions"
positions = [[1, 1, 1], [1.19, 1.02, 1]]
angular_velocity = [1, 2, -1]
)";
  Simulation alone(case_of(open_box + sphere), one_thread());
  Simulation among(case_of(one_body + sphere), one_thread());
  test::advance(alone, 200);
  test::advance(among, 200);
  const auto rows_alone = test::rows_by_id(alone.system().particles), rows = test::rows_by_id(among.system().particles);
  for (std::size_t id = 0; id < 2; ++id) {
    const Particles &p = alone.system().particles, &q = among.system().particles;
    for (int k = 0; k < 7; ++k) EXPECT_NEAR(p.motion.row(rows_alone[id])[k], q.motion.row(rows[id + 1])[k], 1e-12) << k;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(p.spin.row(rows_alone[id])[k], q.spin.row(rows[id + 1])[k], 1e-12) << k;
  }
  EXPECT_GT(std::abs(alone.system().particles.motion.row(rows_alone[0])[lane::vx]), 1e-3);  // they collided
}

const std::string bouncing = R"(
[simulation]
end = 10
time_step = 2e-5
max_overlap = 0.5
[domain]
min = [-1, -1, -0.5]
max = [1, 1, 2]
[[materials]]
name = "glass"
density = 2000
stiffness = 2e6
restitution = 1
[[walls]]
name = "floor"
type = "plane"
material = "glass"
point = [0, 0, 0]
normal = [0, 0, 1]
[[particles]]
name = "body"
material = "glass"
shape = "ellipsoid"
half_axes = [0.1, 0.05, 0.05]
insert = "positions"
positions = [[0, 0, 0.2]]
velocity = [0, 0, -1]
orientation = { axis = [0, 1, 0], angle = "30 deg" }
)";

/// Frictionless impact of an ellipsoid on a plane, in closed form: impulse j along the normal n at the arm r gives
/// v' = v + j n/m, w' = I^-1 (r x n) j, j = -2 v_n / (1/m + (r x n).I^-1 (r x n)).
TEST(ShapeMotion, EllipsoidBouncesOffAPlaneAsInClosedForm) {
  Simulation s(case_of(bouncing), one_thread());
  const Particles& p = s.system().particles;
  const double mass = p.mass[0], a = 0.1, b = 0.05, tilt = std::numbers::pi / 6;
  test::advance(s, 6950);  // down, and up again; a little later the other end will touch
  const double inertia = mass * (a * a + b * b) / 5;
  // Lowest point: support point of the tilted ellipse in the direction -z, in the plane of x and z.
  const double nx = std::sin(tilt), nz = -std::cos(tilt), h = std::hypot(a * nx, b * nz);
  const double px = a * a * nx / h, pz = b * b * nz / h;  // in the body
  const double rx = std::cos(tilt) * px + std::sin(tilt) * pz;
  const double across2 = rx * rx;  // (r x z)^2, along y
  const double j = 2 * 1 / (1 / mass + across2 / inertia);
  const double* m = s.system().particles.motion.row(0);
  const double* spin = s.system().particles.spin.row(0);
  EXPECT_NEAR(m[lane::vz], -1 + j / mass, 0.01 * j / mass);
  EXPECT_NEAR(std::abs(spin[1] * spin[3]), std::abs(rx) * j / inertia, 0.01 * std::abs(rx) * j / inertia);
  // r x F = (rx, ., .) x (0, 0, j): y component -rx j.
  EXPECT_GT(-rx * spin[1], 0);
}

TEST(ShapeMotion, BounceKeepsItsEnergyBooks) {
  Simulation s(case_of(bouncing + "[ledger]\n"), one_thread());
  const Fields none;
  const Measured start = measure(s.sample(), none, 0, {});
  test::advance(s, 6950);
  const Measured now = measure(s.sample(), none, 0, {});
  const double before = start.kinetic + start.rotational, after = now.kinetic + now.rotational;
  EXPECT_NEAR(after / before, 1, 1e-4);
  // Momentum: what the particle has more is what the floor gave it.
  EXPECT_NEAR(now.momentum[2] - start.momentum[2], now.impulse[2] - start.impulse[2],
              1e-12 * std::abs(start.momentum[2]));
  EXPECT_NEAR(now.angular_momentum[1] - start.angular_momentum[1], now.angular_impulse[1] - start.angular_impulse[1],
              1e-10);
  EXPECT_GT(std::abs(now.angular_momentum[1]), 1e-2);
}

TEST(ShapeMotion, RestartKeepsTheBits) {
  const std::string text = one_body + R"(
[[particles]]
name = "cylinders"
material = "glass"
shape = "cylinder"
half_axes = [0.1, 0.1, 0.2]
insert = "lattice"
count = 27
orientation = "random"
velocity = { type = "random", deviation = 0.01 }
angular_velocity = [0.5, 0, 1]
diameter = { distribution = "uniform", min = 0.2, max = 0.3 }
)";
  const Case c = case_of(text, {"particles.0.positions=[[3.3, 3.3, 3.3]]"});
  Simulation whole(c, one_thread()), first(c, Team{2});
  test::advance(whole, 60);
  test::advance(first, 25);
  const Archive saved = first.save();
  Simulation second(c, Team{3}, &saved);
  second.restore(saved);
  test::advance(second, 35);
  EXPECT_EQ(whole.state_hash(), second.state_hash());
  Simulation other(c, one_thread());
  EXPECT_NE(whole.state_hash(), other.state_hash());
}

TEST(ShapeMotion, HashSeesTheOrientation) {
  Simulation a(case_of(one_body), one_thread());
  Simulation b(case_of(one_body, {"particles.0.orientation.angle=\"41 deg\"", "particles.0.angular_velocity=[0,0,0]"}),
               one_thread());
  Simulation c(case_of(one_body, {"particles.0.orientation.angle=\"40 deg\"", "particles.0.angular_velocity=[0,0,0]"}),
               one_thread());
  EXPECT_NE(b.state_hash(), c.state_hash());
}

TEST(Orientations, RandomOnesAreUniformOverAllRotations) {
  // Each element of the matrix has mean 0 and mean square 1/3; the angle has the density (1 - cos)/pi.
  Orientations random;
  random.kind = Orientations::Kind::random;
  constexpr int count = 20000;
  double mean[9] = {}, square[9] = {}, cosine = 0;
  for (int i = 0; i < count; ++i) {
    const sc_quat q = draw_orientation(random, 7, 0, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(sc_quat_square(q), 1, 1e-14);
    const sc_mat m = sc_quat_mat(q);
    const double elements[9] = {m.x.x, m.x.y, m.x.z, m.y.x, m.y.y, m.y.z, m.z.x, m.z.y, m.z.z};
    for (int k = 0; k < 9; ++k) {
      mean[k] += elements[k] / count;
      square[k] += elements[k] * elements[k] / count;
    }
    cosine += (m.x.x + m.y.y + m.z.z - 1) / 2 / count;
  }
  for (int k = 0; k < 9; ++k) {
    EXPECT_NEAR(mean[k], 0, 4 * std::sqrt(1.0 / 3 / count));
    EXPECT_NEAR(square[k], 1.0 / 3, 4 * 0.3 / std::sqrt(count));
  }
  EXPECT_NEAR(cosine, -0.5, 4 * 0.5 / std::sqrt(count));
}

TEST(Orientations, AlignedOnesSpreadAsAsked) {
  Orientations aligned;
  aligned.kind = Orientations::Kind::aligned;
  aligned.base = sc_quat_of_turn({0, 1.2, 0});
  aligned.spread = 0.05;
  double square = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const sc_quat q = draw_orientation(aligned, 7, 3, static_cast<std::uint64_t>(i));
    const sc_quat turn = sc_quat_product(q, {aligned.base.w, -aligned.base.x, -aligned.base.y, -aligned.base.z});
    square += 4 * turn.x * turn.x / count;
  }
  EXPECT_NEAR(std::sqrt(square), 0.05, 0.001);
}

}  // namespace
}  // namespace scree
