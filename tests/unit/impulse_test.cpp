// Impulses of single hard contacts against closed forms, and that none gains energy.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/base/random.h"
#include "scree/physics/impulse/hold.h"
#include "scree/physics/impulse/impact.h"

namespace scree {
namespace {

struct Body {
  double inverse_mass = 1;
  sc_mat inverse_inertia{};
  sc_vec velocity{}, spin{}, arm{};

  sc_vec at_contact() const { return sc_add(velocity, sc_cross(spin, arm)); }
  void hit(sc_vec impulse) {
    velocity = sc_add_scaled(velocity, inverse_mass, impulse);
    spin = sc_add(spin, sc_turn(inverse_inertia, sc_cross(arm, impulse)));
  }
  double energy() const {
    if (inverse_mass == 0) return 0;
    return 0.5 * sc_dot(velocity, velocity) / inverse_mass + 0.5 * sc_dot(spin, sc_solve_mat(inverse_inertia, spin));
  }
};

Body ball(double mass, double radius, sc_vec velocity, sc_vec arm) {
  return {1 / mass, sc_diagonal_mat(2.5 / (mass * radius * radius)), velocity, {}, arm};
}

struct Pair {
  Body a, b;
  sc_vec push;  // from b to a

  sc_mat response() const {
    return sc_add_mat(sc_response(a.inverse_mass, a.inverse_inertia, a.arm),
                      sc_response(b.inverse_mass, b.inverse_inertia, b.arm));
  }
  sc_vec velocity() const { return sc_sub(a.at_contact(), b.at_contact()); }
  sc_vec collide(const sc_impact_law& law) {
    const sc_vec p = sc_impact(law, response(), push, velocity());
    a.hit(p);
    b.hit(sc_scale(-1, p));
    return p;
  }
  double energy() const { return a.energy() + b.energy(); }
};

/// Two balls of 1 kg and 1 m, the first moving towards the other and across.
Pair balls(double across) {
  return {ball(1, 0.5, {1, across, 0}, {0.5, 0, 0}), ball(1, 0.5, {0, 0, 0}, {-0.5, 0, 0}), {-1, 0, 0}};
}

void expect_vec(sc_vec v, double x, double y, double z) {
  EXPECT_NEAR(v.x, x, 1e-15);
  EXPECT_NEAR(v.y, y, 1e-15);
  EXPECT_NEAR(v.z, z, 1e-15);
}

// Walton's three-parameter model (Walton 1993) with e = 0.9, mu = 0.5, beta_0 = 0.4: the impulses (1 + e) m* g_n and
// (2/7) (1 + beta_0) m* g_t.
TEST(Impulse, OfSpheresThatStickIsWaltons) {
  Pair p = balls(0.1);
  const sc_vec impulse = p.collide({0.9, 0.4, 0.5, 0.5});
  expect_vec(impulse, -0.95, -0.02, 0);
  expect_vec(p.a.velocity, 0.05, 0.08, 0);
  expect_vec(p.b.velocity, 0.95, 0.02, 0);
  expect_vec(p.a.spin, 0, 0, -0.1);
  expect_vec(p.b.spin, 0, 0, -0.1);
  EXPECT_NEAR(p.energy(), 0.4569, 1e-15);
  EXPECT_NEAR(p.velocity().y, -0.04, 1e-15);
}

// Sliding: J_t = mu J_n = 0.5 * 0.95 where (2/7) 1.4 0.5 g_t = 0.2 g_t would be more.
TEST(Impulse, OfSpheresThatSlideIsLimitedByFriction) {
  Pair p = balls(4);
  const sc_vec impulse = p.collide({0.9, 0.4, 0.5, 0.5});
  expect_vec(impulse, -0.95, -0.475, 0);
  EXPECT_LT(p.energy(), 0.5 * (1 + 16));
  // Exactly where sticking begins both branches agree.
  Pair edge = balls(0.475 / 0.2), below = balls(0.475 / 0.2 - 1e-9);
  EXPECT_NEAR(edge.collide({0.9, 0.4, 0.5, 0.5}).y, below.collide({0.9, 0.4, 0.5, 0.5}).y, 1e-9);
}

// A body that hits a plane off centre without friction: J = (1 + e) v / (1/m + x^2/I).
TEST(Impulse, OfAnEccentricHitIsTheClosedForm) {
  const double m = 2, inertia = 0.3, x = 0.4, v = 3, e = 0.7;
  Pair p{{1 / m, sc_diagonal_mat(1 / inertia), {0, 0, -v}, {}, {x, 0, -0.2}}, {0, {}, {}, {}, {}}, {0, 0, 1}};
  const double j = (1 + e) * v / (1 / m + x * x / inertia);
  expect_vec(p.collide({e, 0, 0, 0}), 0, 0, j);
  EXPECT_NEAR(p.a.velocity.z, j / m - v, 1e-14);
  EXPECT_NEAR(p.a.spin.y, -x * j / inertia, 1e-14);
}

TEST(Impulse, IsNoneWhereBodiesPart) {
  Pair p = balls(0.3);
  p.a.velocity.x = -1;
  expect_vec(p.collide({0.9, 0.4, 0.5, 0.5}), 0, 0, 0);
  p.a.velocity.x = 0;
  expect_vec(p.collide({0.9, 0.4, 0.5, 0.5}), 0, 0, 0);
}

/// Numbers on [-1, 1).
struct Draws {
  std::uint64_t count;
  std::uint32_t draw = 0;

  double operator()() { return 2 * uniform({1, 2, count, draw++}) - 1; }
  sc_vec vec() { return {(*this)(), (*this)(), (*this)()}; }
  sc_vec unit() {
    for (;;) {
      const sc_vec v = vec();
      const double size = sc_norm(v);
      if (size > 0.1 && size < 1) return sc_scale(1 / size, v);
    }
  }
};

/// A box-like body of random axes, turned at random.
Body random_body(Draws& draw, bool fixed) {
  Body b;
  b.velocity = draw.vec();
  b.spin = sc_scale(3, draw.vec());
  b.arm = draw.vec();
  b.inverse_inertia = {};
  b.inverse_mass = 0;
  if (fixed) {
    // One that moves would do work.
    b.velocity = b.spin = {};
    return b;
  }
  const double mass = std::exp(3 * draw());
  b.inverse_mass = 1 / mass;
  const double x = std::exp(draw()), y = std::exp(draw()), z = std::exp(2 * draw());
  const double inertia[3] = {mass * (y * y + z * z) / 5, mass * (z * z + x * x) / 5, mass * (x * x + y * y) / 5};
  const double angle = 3 * draw();
  const sc_mat turn = sc_rotation(draw.unit(), std::cos(angle), std::sin(angle));
  const sc_vec rows[3] = {turn.x, turn.y, turn.z};
  sc_vec* out[3] = {&b.inverse_inertia.x, &b.inverse_inertia.y, &b.inverse_inertia.z};
  for (int i = 0; i < 3; ++i) {
    const sc_vec scaled{rows[i].x / inertia[0], rows[i].y / inertia[1], rows[i].z / inertia[2]};
    *out[i] = sc_turn(turn, scaled);
  }
  return b;
}

sc_vec angular_momentum(const Pair& p, sc_vec place_a, sc_vec place_b) {
  sc_vec out{};
  for (const auto& [body, place] : {std::pair(p.a, place_a), std::pair(p.b, place_b)}) {
    if (body.inverse_mass == 0) continue;
    out = sc_add(out, sc_cross(place, sc_scale(1 / body.inverse_mass, body.velocity)));
    out = sc_add(out, sc_solve_mat(body.inverse_inertia, body.spin));
  }
  return out;
}

/// A bound on the terms that add up to the angular momentum, and on what rounding in the inverse of the inertia does.
double largest_moment(const Pair& p, sc_vec place_a, sc_vec place_b) {
  double out = 0;
  for (const auto& [body, place] : {std::pair(p.a, place_a), std::pair(p.b, place_b)}) {
    const sc_vec diagonal{body.inverse_inertia.x.x, body.inverse_inertia.y.y, body.inverse_inertia.z.z};
    const double stiffest = sc_norm(sc_solve_mat(body.inverse_inertia, {1, 1, 1}));
    out += sc_norm(place) * sc_norm(body.velocity) / body.inverse_mass;
    out += stiffest * sc_norm(body.spin) * (1 + stiffest * sc_norm(diagonal));
  }
  return out;
}

TEST(Impulse, NeverGainsEnergyWhateverTheShapes) {
  int slid = 0, hits = 0;
  for (std::uint64_t k = 0; k < 24000; ++k) {
    Draws draw{k};
    Pair p{random_body(draw, false), random_body(draw, k % 5 == 0), draw.unit()};
    const sc_impact_law law{0.5 + 0.5 * draw(), 0.5 + 0.5 * draw(), 1 + draw(), 0};
    const double before = p.energy(), approach = -sc_dot(p.push, p.velocity());
    const sc_vec here = draw.vec(), place_a = sc_sub(here, p.a.arm), place_b = sc_sub(here, p.b.arm);
    const sc_vec turning = angular_momentum(p, place_a, place_b);
    if (!(approach > 0)) continue;
    ++hits;
    const sc_vec impulse = p.collide(law);
    EXPECT_LE(p.energy(), before * (1 + 1e-13)) << k;
    const double load = sc_dot(p.push, impulse), across = sc_norm(sc_add_scaled(impulse, -load, p.push));
    EXPECT_GE(load, 0) << k;
    EXPECT_LE(across, law.friction * load * (1 + 1e-9)) << k;
    EXPECT_GE(sc_dot(p.push, p.velocity()), -1e-12) << k;
    slid += across > law.friction * load * (1 - 1e-9);
    if (k % 5 != 0) {
      const sc_vec change = sc_sub(angular_momentum(p, place_a, place_b), turning);
      EXPECT_LE(sc_norm(change), 1e-14 * largest_moment(p, place_a, place_b)) << k;
    }
  }
  EXPECT_GT(hits, 10000);
  EXPECT_GT(slid, 1000);
  EXPECT_GT(hits - slid, 1000);
}

TEST(Impulse, OfAnElasticHitWithoutFrictionKeepsTheEnergy) {
  for (std::uint64_t k = 0; k < 500; ++k) {
    Draws draw{k};
    Pair p{random_body(draw, false), random_body(draw, k % 5 == 0), draw.unit()};
    const double before = p.energy();
    p.collide({1, 0, 0, 0});
    EXPECT_NEAR(p.energy(), before, 1e-13 * before) << k;
  }
}

/// Visits a contact until it holds.
sc_vec hold(Pair& p, double friction) {
  const sc_hold h = sc_make_hold(p.push, p.response(), friction);
  sc_vec impulse{};
  for (int sweep = 0; sweep < 400; ++sweep) {
    const sc_vec next = sc_hold_on(h, impulse, p.velocity()), change = sc_sub(next, impulse);
    p.a.hit(change);
    p.b.hit(sc_scale(-1, change));
    impulse = next;
  }
  return impulse;
}

TEST(Impulse, ThatHoldsStopsOrSlidesWithFriction) {
  int stopped = 0, slid = 0, parted = 0;
  for (std::uint64_t k = 0; k < 600; ++k) {
    Draws draw{k};
    Pair p{random_body(draw, false), random_body(draw, k % 3 == 0), draw.unit()};
    const double friction = k % 7 == 0 ? 0 : 0.8 + 0.8 * draw();
    const sc_vec impulse = hold(p, friction), u = p.velocity();
    const double load = sc_dot(p.push, impulse), away = sc_dot(p.push, u), scale = sc_norm(impulse) + sc_norm(u);
    const double across = sc_norm(sc_add_scaled(impulse, -load, p.push));
    EXPECT_GE(load, 0);
    EXPECT_GE(away, -1e-9 * scale) << k;
    EXPECT_LE(load * away, 1e-9 * scale * scale) << k;
    EXPECT_LE(across, friction * load * (1 + 1e-12) + 1e-15 * scale) << k;
    if (load == 0) {
      ++parted;
    } else if (across < friction * load * (1 - 1e-9)) {
      EXPECT_LE(sc_norm(u), 1e-9 * scale) << k;
      ++stopped;
    } else {
      ++slid;
    }
  }
  EXPECT_GT(stopped, 20);
  EXPECT_GT(slid, 50);
  EXPECT_GT(parted, 50);
}

// A ball that slides on a plane under its weight: friction mu m g dt against the motion.
TEST(Impulse, ThatHoldsASlidingBallIsCoulombs) {
  const double m = 0.4, g = 9.81, dt = 1e-3, mu = 0.3;
  Pair p{ball(m, 0.1, {2, 0, -g * dt}, {0, 0, -0.1}), {0, {}, {}, {}, {}}, {0, 0, 1}};
  const sc_vec impulse = hold(p, mu);
  EXPECT_NEAR(impulse.z, m * g * dt, 1e-15);
  EXPECT_NEAR(impulse.x, -mu * m * g * dt, 1e-15);
  EXPECT_EQ(impulse.y, 0);
}

}  // namespace
}  // namespace scree
