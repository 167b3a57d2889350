#include "scree/particles/restitution.h"

#include <fmt/format.h>

#include <cmath>

#include "scree/base/error.h"

namespace scree {
namespace {

constexpr double pi = 3.14159265358979323846;

void require(double e, double least) {
  if (e >= least && e <= 1) return;
  throw InputError(fmt::format("a restitution of {} is not possible: it lies between {} and 1", e, least));
}

}  // namespace

double restitution_without_tension(double zeta) {
  const double x = 1 - zeta * zeta;
  // acos(zeta)/sqrt(1 - zeta^2) near zeta = 1, where both vanish
  if (std::abs(x) < 1e-6) return std::exp(-2 * zeta * (1 + x / 6));
  const double angle = x > 0 ? std::acos(zeta) / std::sqrt(x) : std::acosh(zeta) / std::sqrt(-x);
  return std::exp(-2 * zeta * angle);
}

double damping_for_restitution_plain(double e) {
  require(e, 1e-300);
  return -std::log(e) / std::hypot(pi, std::log(e));
}

double damping_for_restitution_linear(double e) {
  require(e, 1e-4);
  if (e == 1) return 0;
  double low = 0, high = 100;  // restitution 1 and 2.5e-5
  for (int i = 0; i < 200 && high - low > 1e-16 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (restitution_without_tension(middle) > e ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double damping_for_restitution_hertz(double e) { return damping_for_restitution_linear(e); }

}  // namespace scree
