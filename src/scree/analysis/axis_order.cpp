#include "scree/analysis/axis_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/base/exact_sum.h"
#include "scree/mpi/together.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

/// Sums over bodies of the products of the components of their axes: of the squares, and of y z, z x, x y.
struct AxisSums {
  std::array<ExactSum, 3> squares, products;
};

sc_vec unit_vector(int axis) { return sc_make_vec(axis == 0, axis == 1, axis == 2); }

/// The largest eigenvalue of the symmetric matrix with this diagonal, whose trace is zero, and these elements yz, zx,
/// xy beside it (Smith 1961, Comm. ACM 4:168).
double largest_eigenvalue(const std::array<double, 3>& d, const std::array<double, 3>& o) {
  double squares = 0;
  for (int k = 0; k < 3; ++k) squares += d[k] * d[k] + 2 * o[k] * o[k];
  const double scale = std::sqrt(squares / 6);
  if (scale == 0) return 0;
  const double determinant =
      d[0] * (d[1] * d[2] - o[0] * o[0]) - d[1] * o[1] * o[1] - d[2] * o[2] * o[2] + 2 * o[0] * o[1] * o[2];
  const double cosine = std::clamp(determinant / (2 * scale * scale * scale), -1.0, 1.0);
  return 2 * scale * std::cos(std::acos(cosine) / 3);
}

}  // namespace

int distinct_axis(const Form& form) {
  const Axes half_axes = form.half_axes();
  std::array<int, 3> by_length = {0, 1, 2};
  std::stable_sort(by_length.begin(), by_length.end(), [&](int i, int j) { return half_axes[i] < half_axes[j]; });
  const double a = half_axes[by_length[0]], b = half_axes[by_length[1]], c = half_axes[by_length[2]];
  if (a == c) return -1;
  // Of 1.25 : 1 : 0.8, which is between the two, rounding shall not decide.
  constexpr double rounding = 1e-12;
  return by_length[c * a >= b * b * (1 - rounding) ? 2 : 0];
}

AxisOrder axis_order(const Region& region, const Particles& particles, const Forms& forms, const Ranks& ranks) {
  std::vector<int> axis_of;
  for (const Form& form : forms) axis_of.push_back(distinct_axis(form));
  AxisSums sums;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (is_sphere(particles, i) || !has_centre_in(region, particles.motion.row(i))) continue;
    const int axis = axis_of[static_cast<std::size_t>(particles.form[i])];
    if (axis < 0) continue;
    const sc_vec u = sc_turn(sc_quat_mat(orientation_of(particles, i)), unit_vector(axis));
    const double square[3] = {u.x * u.x, u.y * u.y, u.z * u.z}, product[3] = {u.y * u.z, u.z * u.x, u.x * u.y};
    for (int k = 0; k < 3; ++k) {
      sums.squares[k].add(square[k]);
      sums.products[k].add(product[k]);
    }
    ++count;
  }
  count = ranks.total(count);
  add_up_sums(sums, ranks);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (count == 0) return {{none, none, none}, none};
  AxisOrder out;
  std::array<double, 3> diagonal{}, beside{};
  for (int k = 0; k < 3; ++k) {
    out.cos2[k] = sums.squares[k].value() / static_cast<double>(count);
    diagonal[k] = 1.5 * out.cos2[k] - 0.5;
    beside[k] = 1.5 * sums.products[k].value() / static_cast<double>(count);
  }
  out.nematic = largest_eigenvalue(diagonal, beside);
  return out;
}

}  // namespace scree
