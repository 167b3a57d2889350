// Superellipsoids: volume, inertia and bounding radius by closed form, gauge, support function and curvatures.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/data/forms.h"

namespace scree {
namespace {

struct Known {
  Axes axes;
  double e1, e2, volume, xx, yy, zz;
};

// To 1e-30 by integration in long arithmetic, density 1.
const Known known[] = {
    {{3, 2, 1}, 1, 1, 25.1327412287183459077, 25.1327412287183459077, 50.2654824574366918154, 65.34512719466769936002},
    {{1, 1, 1},
     .5,
     .5,
     6.481987351786382022152,
     3.554306350526692997613,
     3.554306350526692997613,
     3.554306350526692997613},
    {{1, 1, 2},
     .2,
     1,
     12.23074086098619813268,
     18.57149966958474570004,
     18.57149966958474570004,
     5.98450691378365625348},
    {{1, 2, 3},
     .25,
     .25,
     45.10020217302919138541,
     182.8946994643695654098,
     140.6882303572073580075,
     70.34411517860367900377},
    {{1.3, .9, .7},
     .6,
     .8,
     4.617466101891502625075,
     1.484566271089660087998,
     2.4621583064357369429,
     2.777250100414991065062},
    {{1, 1, 1}, 2, 2, 4.0 / 3, 4.0 / 15, 4.0 / 15, 4.0 / 15},
    {{1, 1.5, .8},
     1.5,
     .3,
     4.462929143011647802286,
     2.619744751023949636173,
     1.389828280374637117344,
     3.197782823688212548955},
    {{1, 1, 1},
     .1,
     .1,
     7.910480555517491653285,
     5.203002778453476468568,
     5.203002778453476468568,
     5.203002778453476468568},
};

TEST(Form, VolumeAndInertia) {
  for (const Known& k : known) {
    const double volume = superellipsoid_volume(k.axes, k.e1, k.e2);
    EXPECT_NEAR(volume, k.volume, 2e-14 * k.volume) << k.e1 << ' ' << k.e2;
    const Axes inertia = superellipsoid_inertia(k.axes, k.e1, k.e2);
    EXPECT_NEAR(inertia[0] * volume, k.xx, 2e-14 * k.xx);
    EXPECT_NEAR(inertia[1] * volume, k.yy, 2e-14 * k.yy);
    EXPECT_NEAR(inertia[2] * volume, k.zz, 2e-14 * k.zz);
  }
  EXPECT_NEAR(superellipsoid_volume({2, 1, 1}, 1, 1), 8.3775804095728, 1e-13);
}

TEST(Form, BoundingRadius) {
  EXPECT_NEAR(bounding_radius({1.3, .9, .7}, .6, .8), 1.3147004406740, 1e-13);
  EXPECT_NEAR(bounding_radius({1, 2, 3}, .25, .25), 3.396683854951, 1e-12);
  EXPECT_NEAR(bounding_radius({1, 1, 2}, .2, 1), 2.134556325943, 1e-12);
  EXPECT_NEAR(bounding_radius({1, 1.5, .8}, 1.5, .3), 1.650424498810, 1e-12);
  EXPECT_EQ(bounding_radius({3, 2, 1}, 1, 1), 3);
}

TEST(Form, ScalesWithTheBoundingRadius) {
  const Form form = make_form({1.3e-3, .9e-3, .7e-3}, .6, .8);
  const double radius = 1.3147004406740e-3;
  EXPECT_NEAR(form.volume * std::pow(radius, 3), 4.617466101891502625075e-9, 1e-21);
  EXPECT_NEAR(form.half_axes()[1] * radius, .9e-3, 1e-15);
  EXPECT_NEAR(form.inertia[2] * radius * radius, 2.777250100414991065062 / 4.617466101891502625075 * 1e-6, 1e-18);
  EXPECT_NEAR(4.0 / 3 * M_PI * std::pow(form.equivalent_radius, 3), form.volume, 1e-14);
  const Form sphere = sphere_form();
  EXPECT_TRUE(sphere.shape.is_sphere);
  EXPECT_EQ(sphere.equivalent_radius, 1);
  EXPECT_EQ(sphere.inertia[0], 0.4);
  EXPECT_FALSE(make_form({1, 1, 2}, 1, 1).shape.is_sphere);
  EXPECT_FALSE(make_form({1, 1, 1}, .9, 1).shape.is_sphere);
}

/// The form G of the reference: half axes (1.3, 0.9, 0.7) m, exponents (0.6, 0.8).
const Form form_g = make_form({1.3, .9, .7}, .6, .8);
const double radius_g = bounding_radius({1.3, .9, .7}, .6, .8);
const sc_vec along_g = sc_scale(1 / std::sqrt(14.0), sc_make_vec(1, 2, 3));

using Matrix = std::array<std::array<double, 3>, 3>;

/// The Hessian that a norm's two dyads make.
Matrix hessian_of(const sc_norm_value& n) {
  const double i[3] = {n.inner.x, n.inner.y, n.inner.z}, o[3] = {n.outer.x, n.outer.y, n.outer.z};
  Matrix h{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) h[r][c] = n.inner_bend * i[r] * i[c] + n.outer_bend * o[r] * o[c];
  return h;
}

TEST(Superellipsoid, SupportFunction) {
  const sc_norm_value h = sc_support(form_g.shape, radius_g, along_g);
  EXPECT_NEAR(h.value, .97105433680475237886, 1e-15);
  EXPECT_NEAR(h.gradient.x, .72537288776319897051, 2e-15);
  EXPECT_NEAR(h.gradient.y, .62384961480811668546, 2e-15);
  EXPECT_NEAR(h.gradient.z, .55342683829498005857, 2e-15);
}

TEST(Superellipsoid, GaugeAndCurvatures) {
  const sc_vec x = sc_support(form_g.shape, radius_g, along_g).gradient;
  const sc_norm_value g = sc_gauge(form_g.shape, radius_g, x);
  EXPECT_NEAR(g.value, 1, 1e-15);
  // The reference has derivatives of F = gauge^n1, whose value is 1 here too.
  const double n1 = 2 / .6;
  EXPECT_NEAR(n1 * sc_norm(g.gradient), 3.43269496566139003, 1e-14);
  const Matrix h = hessian_of(g);
  const double v[3] = {g.gradient.x, g.gradient.y, g.gradient.z};
  const auto entry = [&](int r, int c) { return n1 * (n1 - 1) * v[r] * v[c] + n1 * h[r][c]; };
  EXPECT_NEAR(entry(0, 0), 2.284625610702653, 1e-14);
  EXPECT_NEAR(entry(1, 1), 5.961678491348345, 2e-14);
  EXPECT_NEAR(entry(2, 2), 11.60403470346585, 3e-14);
  EXPECT_NEAR(entry(0, 1), .7749558936950944, 1e-14);
  EXPECT_NEAR(entry(0, 2), 0, 1e-14);
  const sc_curvature k = sc_curvature_of(g);
  EXPECT_NEAR(k.gaussian, 1.554423405197552, 1e-14);
  EXPECT_NEAR(k.mean, 1.500666690228913, 1e-14);
  // The normal there is the direction.
  EXPECT_NEAR(sc_dot(g.gradient, along_g), sc_norm(g.gradient), 1e-15);
}

TEST(Superellipsoid, CurvaturesOfAnEllipsoid) {
  const Form form = make_form({3, 2, 1}, 1, 1);
  const double third = 1 / std::sqrt(3.0);
  const sc_curvature k = sc_curvature_of(sc_gauge(form.shape, 3, sc_make_vec(3 * third, 2 * third, third)));
  EXPECT_NEAR(k.gaussian, .134943773427738442, 1e-15);
  EXPECT_NEAR(k.mean, .424175707976051582, 1e-15);
}

/// Product of the principal radii, from the support function's Hessian: its trace and that of its square.
double product_of_radii(const sc_norm_value& support) {
  const Matrix h = hessian_of(support);
  double trace = 0, square = 0;
  for (int r = 0; r < 3; ++r) {
    trace += h[r][r];
    for (int c = 0; c < 3; ++c) square += h[r][c] * h[c][r];
  }
  return 0.5 * (trace * trace - square);
}

/// Gradient and Hessian of a norm agree with differences of its value and gradient, and with Euler's identities.
void check_derivatives(sc_vec scale, const sc_exponents& e, const sc_vec& x) {
  const sc_norm_value at = sc_nested_norm(scale, e, x);
  EXPECT_NEAR(sc_dot(at.gradient, x), at.value, 1e-14 * at.value);
  const Matrix h = hessian_of(at);
  const double step = 1e-6;
  for (int c = 0; c < 3; ++c) {
    const sc_vec d = sc_make_vec(c == 0 ? step : 0, c == 1 ? step : 0, c == 2 ? step : 0);
    const sc_norm_value up = sc_nested_norm(scale, e, sc_add(x, d)), down = sc_nested_norm(scale, e, sc_sub(x, d));
    const double g[3] = {at.gradient.x, at.gradient.y, at.gradient.z};
    EXPECT_NEAR((up.value - down.value) / (2 * step), g[c], 1e-8);
    const sc_vec row = sc_scale(0.5 / step, sc_sub(up.gradient, down.gradient));
    const double got[3] = {row.x, row.y, row.z};
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(got[r], h[r][c], 1e-7 * (1 + std::abs(h[r][c]))) << r << c;
  }
}

TEST(Superellipsoid, DerivativesOfEveryClassOfExponents) {
  const sc_vec axes = sc_make_vec(0.9, 0.7, 0.6);
  for (const double e1 : {.1, .125, .25, .5, .77, 1.0, 1.5, 1.9})
    for (const double e2 : {.125, .25, .5, 1.0, 1.3, 1.9}) {
      const sc_form form = sc_make_form(axes, e1, e2);
      for (const sc_vec& x : {sc_make_vec(.3, .5, .4), sc_make_vec(-.6, .2, -.3), sc_make_vec(.2, -.25, .7)}) {
        check_derivatives(form.inverse_axes, form.gauge, x);
        check_derivatives(form.axes, form.support, x);
      }
    }
}

TEST(Superellipsoid, GaugeAndSupportAreDual) {
  for (const double e1 : {.1, .25, .5, 1.0, 1.9})
    for (const double e2 : {.1, .25, .77, 1.0, 1.9}) {
      const Form form = make_form({1, .7, .4}, e1, e2);
      for (const sc_vec& n : {sc_make_vec(.3, .5, .4), sc_make_vec(-.6, .02, -.3), sc_make_vec(.2, -.25, .001)}) {
        const sc_norm_value far = sc_support(form.shape, 1, n);
        const sc_norm_value there = sc_gauge(form.shape, 1, far.gradient);
        EXPECT_NEAR(there.value, 1, 1e-13) << e1 << ' ' << e2;
        // The support value of a gauge's gradient is 1: what the certificate of a contact rests on.
        const sc_norm_value g = sc_gauge(form.shape, 1, n);
        EXPECT_NEAR(sc_support(form.shape, 1, g.gradient).value, 1, 1e-13) << e1 << ' ' << e2;
        if (e1 > .4 && e2 > .4 && e1 < 1.5 && e2 < 1.5 && n.x > .25) {
          EXPECT_NEAR(product_of_radii(far) * sc_dot(n, n) * sc_curvature_of(there).gaussian, 1, 1e-8);
        }
      }
    }
}

TEST(Superellipsoid, StaysFiniteWhereItIsSingular) {
  for (const double e : {.1, 1.0, 1.9}) {
    const sc_form form = sc_make_form(sc_make_vec(1, .5, .5), e, e);
    for (const sc_vec& x : {sc_make_vec(0, 0, 0), sc_make_vec(0, 0, 1), sc_make_vec(1, 0, 0), sc_make_vec(0, 1, 1)}) {
      for (const sc_norm_value& v : {sc_gauge(form, 1, x), sc_support(form, 1, x)}) {
        EXPECT_TRUE(std::isfinite(v.value + sc_dot(v.gradient, v.gradient)));
        EXPECT_TRUE(std::isfinite(v.value * v.inner_bend * sc_dot(v.inner, v.inner)));
        EXPECT_TRUE(std::isfinite(v.value * v.outer_bend * sc_dot(v.outer, v.outer)));
      }
    }
    EXPECT_NEAR(sc_gauge(form, 1, sc_make_vec(0, 0, 1)).value, 2, 1e-12);
  }
}

}  // namespace
}  // namespace scree
