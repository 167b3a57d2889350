// What a flow wants to know of a shape: elliptic integrals, resistances, added masses, shadows and their means.
#include "scree/data/flow_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scree/data/form_surface.h"
#include "scree/data/forms.h"
#include "scree/physics/drag/body/ellipsoid_in_flow.h"

namespace scree {
namespace {

TEST(Carlson, PublishedValues) {
  // Carlson 1995, section 3.
  EXPECT_NEAR(sc_carlson_rf(1, 2, 0), 1.3110287771461, 1e-13);
  EXPECT_NEAR(sc_carlson_rf(2, 3, 4), 0.58408284167715, 1e-14);
  EXPECT_NEAR(sc_carlson_rd(0, 2, 1), 1.7972103521034, 1e-13);
  EXPECT_NEAR(sc_carlson_rd(2, 3, 4), 0.16510527294261, 1e-14);
}

TEST(FlowShape, CreepingResistanceOfEllipsoids) {
  // Over 6 pi mu r_V, to ten digits by an independent quadrature.
  struct Row {
    Axes axes, resistance;
  };
  for (const Row& r : {Row{{2, 1, 1}, {.9555685968, 1.0944329068, 1.0944329068}},
                       Row{{4, 1, 1}, {1.0066409332, 1.2955128262, 1.2955128262}},
                       Row{{1, 1, .25}, {1.0831464559, 1.0831464559, 1.3768275373}},
                       Row{{3, 2, 1}, {.9874389579, 1.0684593852, 1.2133595869}}}) {
    const sc_flow_shape s = make_flow_shape(r.axes, 1, 1).shape;
    EXPECT_NEAR(s.resistance.x, r.resistance[0], 2e-10);
    EXPECT_NEAR(s.resistance.y, r.resistance[1], 2e-10);
    EXPECT_NEAR(s.resistance.z, r.resistance[2], 2e-10);
  }
  // A disc: 16 mu a U broadside, 32/3 mu a U edgewise (Lamb 1932, art. 339).
  const sc_vec disc = sc_make_vec(1, 1, 1e-9);
  const sc_vec k = sc_oberbeck_resistance(disc, sc_integrals_of_ellipsoid(disc));
  EXPECT_NEAR(6 * M_PI * k.z, 16, 1e-7);
  EXPECT_NEAR(6 * M_PI * k.x, 32.0 / 3, 1e-7);
}

TEST(FlowShape, CreepingTorqueAndAddedMass) {
  const sc_flow_shape sphere = make_flow_shape({2, 2, 2}, 1, 1).shape;
  for (const sc_vec& v : {sphere.resistance, sphere.turning, sphere.shadow}) {
    EXPECT_NEAR(v.x, 1, 1e-13);
    EXPECT_NEAR(v.z, 1, 1e-13);
  }
  EXPECT_NEAR(sphere.added_mass.y, 0.5, 1e-13);
  EXPECT_NEAR(sphere.straining.x, 0, 1e-13);
  // A disc turns with 32/3 mu a^3 w about any axis; its added mass broadside is 8/3 rho a^3 (Lamb 1932).
  const sc_vec disc = sc_make_vec(1, 1, 1e-7);
  const sc_ellipsoid_integrals i = sc_integrals_of_ellipsoid(disc);
  const sc_jeffery j = sc_jeffery_factors(disc, i);
  EXPECT_NEAR(8 * M_PI * j.turning.z, 32.0 / 3, 1e-5);
  EXPECT_NEAR(8 * M_PI * j.turning.x, 32.0 / 3, 1e-5);
  EXPECT_NEAR(sc_added_mass_of_ellipsoid(disc, i).z * 4 * M_PI / 3 * 1e-7, 8.0 / 3, 1e-5);
  // Prolate spheroids of eccentricity e in closed form (Lamb 1932, art. 114).
  for (const double ratio : {1.5, 2., 6.}) {
    const sc_flow_shape s = make_flow_shape({ratio, 1, 1}, 1, 1).shape;
    const double e2 = 1 - 1 / (ratio * ratio), e = std::sqrt(e2), log = std::log((1 + e) / (1 - e));
    const double along = 2 * (1 - e2) / (e2 * e) * (.5 * log - e), across = 1 / e2 - (1 - e2) / (2 * e2 * e) * log;
    EXPECT_NEAR(s.added_mass.x, along / (2 - along), 1e-12) << ratio;
    EXPECT_NEAR(s.added_mass.y, across / (2 - across), 1e-12) << ratio;
  }
}

double equal_circle(const Axes& h, double e1, double e2) {
  const double r = std::cbrt(superellipsoid_volume(h, e1, e2) / (4 * M_PI / 3));
  return M_PI * r * r;
}

sc_vec any_direction(std::mt19937_64& random) {
  std::normal_distribution<double> draw;
  const double x = draw(random), y = draw(random), z = draw(random);
  const sc_vec v = sc_make_vec(x, y, z);
  return sc_scale(1 / sc_norm(v), v);
}

TEST(FlowShape, ShadowsOfEveryOrientation) {
  struct Row {
    double e1, e2, error;
  };
  std::mt19937_64 random(3);
  for (const Row& r : {Row{1, 1, 1e-12}, Row{.2, .2, 1e-3}, Row{.2, 1, 1e-3}, Row{.8, .6, 1e-3}, Row{1, .25, 3e-3},
                       Row{1.5, 1.5, 5e-3}}) {
    const Axes h{1, .6, 2.5};
    const FlowShape f = make_flow_shape(h, r.e1, r.e2);
    for (int i = 0; i < 40; ++i) {
      const sc_vec n = any_direction(random);
      const double truth = shadow_area(h, r.e1, r.e2, {n.x, n.y, n.z}, 2) / equal_circle(h, r.e1, r.e2);
      EXPECT_NEAR(sc_shadow_ratio(f.shape, f.shadow.data(), n) / truth, 1, r.error) << r.e1 << ' ' << r.e2;
    }
    // Along the axes to the last digits; all around, a quarter of the surface, which is 1/sphericity.
    EXPECT_NEAR(sc_shadow_ratio(f.shape, f.shadow.data(), sc_make_vec(0, 0, 1)) * equal_circle(h, r.e1, r.e2),
                shadow_area(h, r.e1, r.e2, {0, 0, 1}), 1e-8);
    double mean = 0;
    constexpr int bands = 60;
    for (int i = 0; i < bands; ++i)
      for (int j = 0; j < bands; ++j) {
        const double z = (i + .5) / bands, s = std::sqrt(1 - z * z), phi = .5 * M_PI * (j + .5) / bands;
        mean += sc_shadow_ratio(f.shape, f.shadow.data(), sc_make_vec(s * std::cos(phi), s * std::sin(phi), z));
      }
    EXPECT_NEAR(mean / (bands * bands) * f.shape.sphericity, 1, 2e-3) << r.e1 << ' ' << r.e2;
  }
}

TEST(FlowShape, MeanShadowAcross) {
  std::mt19937_64 random(5);
  for (const auto& [e1, e2] : {std::pair(1., 1.), {.2, 1.}, {.7, .5}}) {
    const Axes h{1, .6, 2.5};
    const FlowShape f = make_flow_shape(h, e1, e2);
    for (int i = 0; i < 4; ++i) {
      const sc_vec n = i ? any_direction(random) : sc_make_vec(0, 0, 1), u = sc_perpendicular(n), v = sc_cross(n, u);
      double mean = 0;
      constexpr int parts = 48;
      for (int k = 0; k < parts; ++k) {
        const double psi = M_PI * (k + .5) / parts;
        const sc_vec m = sc_add_scaled(sc_scale(std::cos(psi), u), std::sin(psi), v);
        mean += shadow_area(h, e1, e2, {m.x, m.y, m.z}, 1) / equal_circle(h, e1, e2) / parts;
      }
      EXPECT_NEAR(sc_mean_shadow_across(f.shape, f.mean.data(), n) / mean, 1, e1 == 1 ? 1e-10 : 2e-3)
          << e1 << ' ' << e2;
    }
  }
}

/// How much of a square of half side `side` around the centre is covered along n: lines along n through the middles of
/// small squares, and the least gauge along each by golden section.
double covered(const sc_form& form, const sc_vec& n, double side) {
  const sc_vec u = sc_perpendicular(n), v = sc_cross(n, u);
  constexpr int parts = 120;
  const double golden = (std::sqrt(5.) - 1) / 2;
  int hits = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const double x = side * (2 * (i + .5) / parts - 1), y = side * (2 * (j + .5) / parts - 1);
      const sc_vec from = sc_add_scaled(sc_scale(x, u), y, v);
      const auto gauge = [&](double t) { return sc_gauge(form, 1, sc_add_scaled(from, t, n)).value; };
      double low = -1, high = 1;
      for (int k = 0; k < 30; ++k) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (gauge(a) < gauge(b) ? high : low) = gauge(a) < gauge(b) ? b : a;
      }
      hits += gauge(0.5 * (low + high)) < 1;
    }
  return 4 * side * side * hits / (parts * parts);
}

TEST(FlowShape, ShadowsOfCapsulesByBruteForce) {
  std::mt19937_64 random(7);
  for (const double half : {1.0, 1.5, 4.0}) {
    const Form form = make_form("capsule", {1, 1, half}, 1, 1);
    const FlowShape f = make_flow_shapes({sphere_form(), form})[1];
    EXPECT_TRUE(f.shadow.empty());
    const double r = form.shape.axes.x, circle = M_PI * std::pow(form.equivalent_radius, 2);
    const double surface = 4 * M_PI * r;  // a cylinder of length 2 (1 - r), and a sphere
    EXPECT_NEAR(f.shape.sphericity, 4 * circle / surface, 1e-14);
    EXPECT_NEAR(f.shape.shadow.z * circle, M_PI * r * r, 1e-14);
    EXPECT_NEAR(f.shape.shadow.x * circle, M_PI * r * r + 4 * r * (1 - r), 1e-14);
    for (int i = 0; i < 4; ++i) {
      const sc_vec n = i ? any_direction(random) : sc_make_vec(0, 0, 1);
      EXPECT_NEAR(sc_shadow_ratio(f.shape, nullptr, n) * circle, covered(form.shape, n, 1), 4e-3) << half;
      // Directions across n, seen from the middles of small angles.
      const sc_vec u = sc_perpendicular(n), v = sc_cross(n, u);
      double mean = 0;
      constexpr int parts = 2000;
      for (int k = 0; k < parts; ++k) {
        const double psi = M_PI * (k + .5) / parts;
        const sc_vec m = sc_add_scaled(sc_scale(std::cos(psi), u), std::sin(psi), v);
        mean += (M_PI * r * r + 4 * r * (1 - r) * std::hypot(m.x, m.y)) / (circle * parts);
      }
      EXPECT_NEAR(sc_mean_shadow_across(f.shape, nullptr, n) / mean, 1, 1e-6) << half;
    }
    // All around, a quarter of the surface (Cauchy 1832): of a body of revolution over bands of equal area.
    double around = 0;
    constexpr int bands = 20000;
    for (int i = 0; i < bands; ++i) {
      const double z = (i + .5) / bands;
      around += sc_shadow_ratio(f.shape, nullptr, sc_make_vec(std::sqrt(1 - z * z), 0, z)) * circle / bands;
    }
    EXPECT_NEAR(around / (.25 * surface), 1, 1e-6) << half;
  }
}

// Across a direction in the plane of the flat side the ellipse is a line, there and back: 4 half axes over 2 pi.
TEST(FlowShape, MeanAcrossOfAFlatEllipse) {
  const sc_vec flat = sc_make_vec(1, 1, 0);
  EXPECT_NEAR(sc_mean_across(flat, sc_make_vec(0, 0, 1)), 1, 1e-15);
  EXPECT_NEAR(sc_mean_across(flat, sc_make_vec(1, 0, 0)), 2 / M_PI, 1e-14);
  EXPECT_NEAR(sc_mean_across(flat, sc_make_vec(.6, .8, 0)), 2 / M_PI, 1e-14);
}

TEST(FlowShape, FormsWithEqualExponentsShareTheWork) {
  const Forms forms{sphere_form(), make_form({1, 1, 2}, .5, .7), make_form({3, 1, 2}, .5, .7),
                    make_form({1, 2, 3}, 1, 1)};
  const std::vector<FlowShape> shapes = make_flow_shapes(forms);
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_EQ(shapes[1].shadow, shapes[2].shadow);
  EXPECT_NE(shapes[1].mean, shapes[2].mean);
  EXPECT_TRUE(shapes[0].shadow.empty());
  const FlowShape alone = make_flow_shape({3, 1, 2}, .5, .7);
  EXPECT_NEAR(shapes[2].shape.shadow.x, alone.shape.shadow.x, 1e-12);
  EXPECT_NEAR(shapes[2].shape.sphericity, alone.shape.sphericity, 1e-12);
}

}  // namespace
}  // namespace scree
