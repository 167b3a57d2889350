#include "scree/data/forms.h"

#include <algorithm>

#include "scree/physics/math.h"

namespace scree {
namespace {

constexpr double ball = 4.1887902047863909846;  // volume of the unit ball, 4 pi/3

/// log of the gamma function for x > 0: Stirling's series above 10, and the recurrence below. With the logarithm of
/// physics/math.h, so that the mass of a body has the same bits with every library.
double log_gamma(double x) {
  double below = 1;
  for (; x < 10; x += 1) below *= x;
  const double i = 1 / x, i2 = i * i;
  const double series =
      i * (1. / 12 +
           i2 * (-1. / 360 +
                 i2 * (1. / 1260 + i2 * (-1. / 1680 + i2 * (1. / 1188 + i2 * (-691. / 360360 + i2 * (1. / 156)))))));
  return (((x - 0.5) * sc_log(x) - x) + (0.91893853320467274178 - sc_log(below))) + series;
}

double beta(double x, double y) { return sc_exp((log_gamma(x) - log_gamma(x + y)) + log_gamma(y)); }

/// The farthest point of a curve |x/a|^(2/e) + |y/b|^(2/e) = 1 from its centre.
double farthest(double a, double b, double e) {
  const double larger = std::max(a, b), smaller = std::min(a, b);
  if (e >= 1) return larger;
  const double ratio = sc_pow(smaller / larger, 2 / (1 - e));
  return larger * sc_pow(1 + ratio, 0.5 * (1 - e));
}

#define SCREE_LINE(constant, name, rule) \
  OtherShape{#name,                      \
             rule,                       \
             SC_SHAPE_##constant,        \
             sc_##name##_fits,           \
             sc_##name##_bounding,       \
             sc_##name##_volume,         \
             sc_##name##_inertia,        \
             sc_##name##_surface},
constexpr OtherShape others[] = {SC_OTHER_SHAPES(SCREE_LINE)};
#undef SCREE_LINE

sc_vec vec_of_axes(const Axes& a) { return sc_make_vec(a[0], a[1], a[2]); }

}  // namespace

std::span<const OtherShape> other_shapes() { return others; }

const OtherShape* other_shape(std::string_view name) {
  const auto found = std::find_if(std::begin(others), std::end(others), [&](const auto& s) { return s.name == name; });
  return found == std::end(others) ? nullptr : found;
}

const OtherShape* Form::other() const {
  return shape.shape == SC_SHAPE_SUPERELLIPSOID ? nullptr : &others[shape.shape - 1];
}

std::string_view Form::shape_name() const { return other() ? other()->name : "superellipsoid"; }

bool has_other_shapes(const Forms& forms) {
  return std::ranges::any_of(forms, [](const Form& form) { return form.other() != nullptr; });
}

double bounding_radius(const Axes& half_axes, double e1, double e2) {
  return farthest(farthest(half_axes[0], half_axes[1], e2), half_axes[2], e1);
}

double superellipsoid_volume(const Axes& half_axes, double e1, double e2) {
  const auto [a, b, c] = half_axes;
  if (e1 == 1 && e2 == 1) return ball * (a * b * c);
  return 2 * (a * b * c) * (e1 * e2) * (beta(0.5 * e1 + 1, e1) * beta(0.5 * e2, 0.5 * e2));
}

Axes superellipsoid_inertia(const Axes& half_axes, double e1, double e2) {
  const auto [a, b, c] = half_axes;
  double plane = 0.2, axis = 0.2;  // mean of (x/a)^2, of (z/c)^2
  if (e1 != 1 || e2 != 1) {
    const double volume = 2 * beta(0.5 * e1 + 1, e1) * beta(0.5 * e2, 0.5 * e2);
    plane = 0.5 * beta(1.5 * e2, 0.5 * e2) * beta(0.5 * e1, 2 * e1 + 1) / volume;
    axis = 2 * beta(0.5 * e2, 0.5 * e2 + 1) * beta(1.5 * e1, e1 + 1) / volume;
  }
  const double x = plane * a * a, y = plane * b * b, z = axis * c * c;
  return {y + z, x + z, x + y};
}

Form make_form(const Axes& half_axes, double e1, double e2) {
  const double radius = bounding_radius(half_axes, e1, e2);
  return make_form_at_radius_one({half_axes[0] / radius, half_axes[1] / radius, half_axes[2] / radius}, e1, e2);
}

Form make_form_at_radius_one(const Axes& axes, double e1, double e2) {
  Form form;
  form.shape = sc_make_form(sc_make_vec(axes[0], axes[1], axes[2]), e1, e2);
  form.exponents = {e1, e2};
  form.volume = superellipsoid_volume(axes, e1, e2);
  form.inertia = superellipsoid_inertia(axes, e1, e2);
  form.equivalent_radius = form.shape.is_sphere ? 1 : sc_cbrt(form.volume / ball);
  return form;
}

Form make_form_at_radius_one(std::string_view shape, const Axes& axes, double e1, double e2) {
  const OtherShape* const other = other_shape(shape);
  if (!other) return make_form_at_radius_one(axes, e1, e2);
  Form form;
  form.shape = sc_make_other_form(other->shape, vec_of_axes(axes));
  form.volume = other->volume(form.shape.axes);
  const sc_vec inertia = other->inertia(form.shape.axes);
  form.inertia = {inertia.x, inertia.y, inertia.z};
  form.equivalent_radius = sc_cbrt(form.volume / ball);
  return form;
}

double bounding_radius(std::string_view shape, const Axes& half_axes, double e1, double e2) {
  const OtherShape* const other = other_shape(shape);
  return other ? other->bounding(vec_of_axes(half_axes)) : bounding_radius(half_axes, e1, e2);
}

Form make_form(std::string_view shape, const Axes& half_axes, double e1, double e2) {
  const double radius = bounding_radius(shape, half_axes, e1, e2);
  return make_form_at_radius_one(shape, {half_axes[0] / radius, half_axes[1] / radius, half_axes[2] / radius}, e1, e2);
}

bool same_shape(const Form& a, const Form& b) {
  return a.shape.shape == b.shape.shape && a.exponents == b.exponents && a.half_axes() == b.half_axes();
}

Form sphere_form() { return make_form({1, 1, 1}, 1, 1); }

}  // namespace scree
