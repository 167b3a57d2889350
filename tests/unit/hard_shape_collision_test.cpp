// Hard collisions of single bodies of any shape against the impulse of rigid bodies in closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine_cases.h"
#include "shape_pairs.h"

namespace scree {
namespace {

using namespace test;
using pairs::body;
using pairs::Body;
using pairs::cross;
using pairs::dot;
using pairs::Real;
using pairs::Vec;

std::string head(const std::string& material) {
  return "[simulation]\nend = 10\ntime_step = 1e-13\n[domain]\nmin = [-9, -9, -9]\nmax = [9, 9, 9]\n"
         "[contact]\ncollision = \"hard\"\n[[materials]]\nname = \"glass\"\ndensity = 2000\n" +
         material;
}

std::string list(Vec v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", double(v.x), double(v.y), double(v.z)); }

std::string body_text(const Body& b, Vec place, const std::array<double, 4>& q, Vec velocity, Vec spin) {
  return fmt::format(
      "[[particles]]\nmaterial = \"glass\"\nshape = \"superellipsoid\"\nhalf_axes = {}\nexponents = [{:.17g}, "
      "{:.17g}]\n"
      "insert = \"positions\"\npositions = [{}]\nvelocity = {}\nangular_velocity = {}\n"
      "orientation = {{ quaternion = [{:.17g}, {:.17g}, {:.17g}, {:.17g}] }}\n",
      list(b.axes()), b.form.exponents[0], b.form.exponents[1], list(place), list(velocity), list(spin), q[0], q[1],
      q[2], q[3]);
}

/// A moving body in the world.
struct State {
  Vec velocity{}, spin{};
  Real mass = 0;
  sc_mat axes{};
  Vec moments{};  // principal
};

State state_of(const Body& b, const std::array<double, 4>& q, Vec velocity, Vec spin) {
  const Real r = b.radius;
  State s{velocity, spin, 2000 * r * r * r * b.form.volume, pairs::turn_of(q[0], q[1], q[2], q[3]), {}};
  const Real scale = s.mass * r * r;
  s.moments = {scale * b.form.inertia[0], scale * b.form.inertia[1], scale * b.form.inertia[2]};
  return s;
}

/// The spin that an angular impulse gives.
Vec spun(const State& s, Vec turn) {
  const Vec l = pairs::turn_back(s.axes, turn);
  return pairs::turn(s.axes, {l.x / s.moments.x, l.y / s.moments.y, l.z / s.moments.z});
}

Vec at(const State& s, Vec arm) { return s.velocity + cross(s.spin, arm); }

/// How the velocity of B at the contact, seen from A, answers an impulse on B.
Vec answer(const State& a, const State* b, Vec arm_a, Vec arm_b, Vec p) {
  Vec u = (1 / a.mass) * p + cross(spun(a, cross(arm_a, p)), arm_a);
  if (b) u = u + (1 / b->mass) * p + cross(spun(*b, cross(arm_b, p)), arm_b);
  return u;
}

/// The impulse p with answer(p) = u, by Cramer's rule.
Vec solve(const State& a, const State* b, Vec arm_a, Vec arm_b, Vec u) {
  const Vec x = answer(a, b, arm_a, arm_b, {1, 0, 0}), y = answer(a, b, arm_a, arm_b, {0, 1, 0}),
            z = answer(a, b, arm_a, arm_b, {0, 0, 1});
  const Real det = dot(x, cross(y, z));
  return {dot(u, cross(y, z)) / det, dot(u, cross(z, x)) / det, dot(u, cross(x, y)) / det};
}

struct Law {
  Real e = 1, mu = 0, e_t = 0;
  std::string text() const {
    return fmt::format("restitution = {}\nfriction = {}\ntangential_restitution = {}\n", double(e), double(mu),
                       double(e_t));
  }
};

/// physics.md 3.6: the impulse on A (Chatterjee and Ruina 1998), normal n from A to B or the wall.
Vec impulse(const Law& law, const State& a, const State* b, Vec arm_a, Vec arm_b, Vec n) {
  const Vec u = b ? at(*b, arm_b) - at(a, arm_a) : Vec{0, 0, 0} - at(a, arm_a);
  const Real approach = -dot(u, n);
  const Vec first = (approach / dot(n, answer(a, b, arm_a, arm_b, n))) * n;
  const Vec second = solve(a, b, arm_a, arm_b, -1 * u), way = second - first;
  Vec p = (1 + law.e) * first + (1 + law.e_t) * way;
  const Vec across = p - dot(p, n) * n, way_across = way - dot(way, n) * n;
  if (std::sqrt(dot(across, across)) > law.mu * dot(p, n)) {
    const Real kappa =
        law.mu * (1 + law.e) * dot(n, first) / (std::sqrt(dot(way_across, way_across)) - law.mu * dot(n, way));
    p = (1 + law.e) * first + kappa * way;
    if (law.mu == 0) p = (1 + law.e) * first;
  }
  return -1 * p;
}

void hit(State& s, Vec arm, Vec p) {
  s.velocity = s.velocity + (1 / s.mass) * p;
  s.spin = s.spin + spun(s, cross(arm, p));
}

/// The state of particle `id` agrees, relative to the speed of 1 m/s at the surface of a body of 1 cm.
void expect_state(const Simulation& s, std::int64_t id, const State& truth, double tolerance) {
  const Particles& p = s.system().particles;
  const std::size_t i = rows_by_id(p)[static_cast<std::size_t>(id)];
  const double *m = p.motion.row(i), *spin = p.spin.row(i);
  EXPECT_NEAR(m[lane::vx], double(truth.velocity.x), tolerance);
  EXPECT_NEAR(m[lane::vy], double(truth.velocity.y), tolerance);
  EXPECT_NEAR(m[lane::vz], double(truth.velocity.z), tolerance);
  EXPECT_NEAR(spin[3] * spin[0], double(truth.spin.x), 100 * tolerance);
  EXPECT_NEAR(spin[3] * spin[1], double(truth.spin.y), 100 * tolerance);
  EXPECT_NEAR(spin[3] * spin[2], double(truth.spin.z), 100 * tolerance);
}

const Law laws[] = {{1, 0, 0}, {0.4, 0, 0}, {0.7, 0.3, 0}, {0.9, 10, 0.5}};

// An ellipsoid, a cylinder and a box fall on a plane at tilts from 5 to 85 degrees.
TEST(HardShapeCollision, WithAPlaneAtAllTiltsIsThatOfRigidBodies) {
  const std::string floor =
      "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  for (const Body& b : {body({2, 1, 1}, 2, 2, .01), body({1, 1, 2}, 8, 2, .01), body({1, .7, .5}, 8, 8, .01)})
    for (const Law& law : laws)
      for (int tilt = 5; tilt <= 85; tilt += 5) {
        const double half = tilt * M_PI / 360;
        const std::array<double, 4> q{std::cos(half), 0.6 * std::sin(half), 0.8 * std::sin(half), 0};
        const sc_mat axes = pairs::turn_of(q[0], q[1], q[2], q[3]);
        const Vec lowest = pairs::turn(axes, b.farthest(pairs::turn_back(axes, {0, 0, -1})));
        State truth = state_of(b, q, {0.3, 0.1, -1}, {0, 0, 0});
        const Vec place{0, 0, -lowest.z - 1e-15L};
        Simulation s(case_of(head(law.text()) + body_text(b, place, q, truth.velocity, truth.spin) + floor), {1});
        s.step();
        hit(truth, lowest, impulse(law, truth, nullptr, lowest, {}, {0, 0, -1}));
        SCOPED_TRACE(fmt::format("tilt {} n {}", tilt, b.form.exponents[0]));
        expect_state(s, 0, truth, 1e-10);
        if (HasFailure()) return;
      }
}

// One that falls flat does not begin to turn: the impulse acts in the middle of its feet.
TEST(HardShapeCollision, OfABoxThatFallsFlatGoesThroughItsMiddle) {
  const std::string floor =
      "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  const Body b = body({1, .7, .5}, 20, 20, .01);
  for (const double tilt : {0.0, 1e-7, 1e-4}) {
    const std::array<double, 4> q{std::cos(0.5 * tilt), std::sin(0.5 * tilt), 0, 0};
    const Vec place{0, 0, b.axes().z + 1e-12L};
    Simulation s(case_of(head("restitution = 0.5\n") + body_text(b, place, q, {0, 0, -1}, {0, 0, 0}) + floor,
                         {"simulation.time_step=1e-7"}),
                 {1});
    advance(s, 3);
    const std::size_t i = 0;
    EXPECT_NEAR(s.system().particles.motion.row(i)[lane::vz], 0.5, 1e-3) << tilt;
    EXPECT_LT(std::abs(s.system().particles.spin.row(i)[0]), 0.02) << tilt;  // the surface, [m/s]
  }
}

// Two bodies of different sizes that just touch, with any normal and any motion; each of them has the lower id once.
TEST(HardShapeCollision, OfTwoBodiesIsThatOfRigidBodies) {
  std::mt19937_64 random(36);
  const auto any = [&](Real size) { return size * pairs::any_direction(random); };
  int collisions = 0;
  for (const auto& kind : {std::pair{body({2, 1, 1}, 2, 2, .01), body({1, .7, .5}, 2, 2, .007)},
                           std::pair{body({1, 1, 2}, 8, 2, .01), body({1, .8, .6}, 5.3, 3.7, .01)},
                           std::pair{body({1, 1, 1}, 2, 2, .01), body({1, 1, 1}, 8, 8, .004)}})
    for (int k = 0; k < 24; ++k) {
      const Law& law = laws[k % 4];
      const std::array<double, 4> one{1, 0, 0, 0};
      std::array<double, 4> q;
      Real square = 0;
      for (double& x : q) {
        x = pairs::normal_draw(random);
        square += x * x;
      }
      for (double& x : q) x /= double(std::sqrt(square));
      const sc_mat axes = pairs::turn_of(q[0], q[1], q[2], q[3]);
      const Vec n = kind.first.normal_along(pairs::any_direction(random));
      const pairs::Touching pair = pairs::touching(kind.first, kind.second, axes, n);
      const Vec arm_a = kind.first.farthest(n), arm_b = arm_a - pair.branch;
      State a = state_of(kind.first, one, any(1), any(30)), b = state_of(kind.second, q, any(1), any(50));
      if (dot(at(b, arm_b) - at(a, arm_a), n) > -0.1) b.velocity = b.velocity - 2 * n;
      const Vec place = (1 - 1e-12L) * pair.branch;
      const std::string first = body_text(kind.first, {0, 0, 0}, one, a.velocity, a.spin),
                        second = body_text(kind.second, place, q, b.velocity, b.spin);
      Simulation s(case_of(head(law.text()) + first + second), {1});
      Simulation t(case_of(head(law.text()) + second + first), {1});
      s.step();
      t.step();
      const Vec p = impulse(law, a, &b, arm_a, arm_b, n);
      hit(a, arm_a, p);
      hit(b, arm_b, -1 * p);
      SCOPED_TRACE(fmt::format("pair {} n {}", k, kind.second.form.exponents[0]));
      for (const auto& [run, swapped] : {std::pair{&s, 0}, std::pair{&t, 1}}) {
        expect_state(*run, swapped, a, 1e-9);
        expect_state(*run, 1 - swapped, b, 1e-9);
      }
      if (HasFailure()) return;
      ++collisions;
    }
  EXPECT_EQ(collisions, 72);
}

}  // namespace
}  // namespace scree
