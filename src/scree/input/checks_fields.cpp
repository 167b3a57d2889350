// Flows and body forces on periodic axes: what leaves through one face comes in through the other, so that a field
// which differs between the two would jump there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scree/input/checks.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;
constexpr const char* axis_names[] = {"x", "y", "z"};

/// How far the number of waves in a period may be from a whole one: wavenumbers are written with a few digits.
constexpr double wave_tolerance = 1e-4;

double period(const Check& check, std::size_t axis) { return check.c.domain.max[axis] - check.c.domain.min[axis]; }

void fail(const Check& check, const std::string& path, const std::string& what, std::size_t axis,
          const std::string& help) {
  check.fail("E171", path, fmt::format("{} does not repeat itself along {}", what, axis_names[axis]),
             fmt::format("the domain is periodic along {}", axis_names[axis]), help);
}

std::string open_axis(std::size_t axis) {
  return fmt::format("set domain.periodic to false along {}, and close it with walls if particles get there",
                     axis_names[axis]);
}

bool fits(double wavenumber, double length) {
  const double waves = wavenumber * length / (2 * pi);
  return std::round(waves) >= 1 && std::abs(waves - std::round(waves)) <= wave_tolerance;
}

/// The nearest wavenumbers that fit every periodic axis, below and above the given one.
std::string fitting_wavenumbers(const Check& check, double wavenumber) {
  std::vector<double> lengths;
  for (std::size_t k = 0; k < 3; ++k)
    if (check.c.domain.periodic[k]) lengths.push_back(period(check, k));
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  const auto fits_all = [&](double a) {
    return std::all_of(lengths.begin(), lengths.end(), [&](double length) { return fits(a, length); });
  };
  // Sides in the ratio of small whole numbers have a common wave within a few waves of the shortest.
  constexpr double search = 100;
  const double waves = std::floor(wavenumber * shortest / (2 * pi));
  std::optional<double> below, above;
  for (double n = waves; n >= 1 && n > waves - search && !below; --n)
    if (fits_all(2 * pi * n / shortest)) below = 2 * pi * n / shortest;
  for (double n = waves + 1; n < waves + search && !above; ++n)
    if (fits_all(2 * pi * n / shortest)) above = 2 * pi * n / shortest;
  if (below && above) return fmt::format("the nearest that fit are {} and {} 1/m", *below, *above);
  if (above) return fmt::format("the smallest that fits is {} 1/m", *above);
  return "no wavenumber near it fits all periodic axes: make their lengths multiples of one length";
}

void check_waves(const Check& check) {
  const FlowKeys& f = check.c.flow;
  if (f.amplitude == 0 || !check.sound({"flow.wavenumber", "flow.amplitude"})) return;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!check.c.domain.periodic[k] || fits(f.wavenumber, period(check, k))) continue;
    check.fail(
        "E171", "flow.wavenumber", fmt::format("the Taylor-Green flow does not repeat itself along {}", axis_names[k]),
        fmt::format("{:.7g} waves in the period of {} m", f.wavenumber * period(check, k) / (2 * pi), period(check, k)),
        fitting_wavenumbers(check, f.wavenumber));
    return;
  }
}

/// The inertial forces of a rotating frame are the same all along its axis, and nowhere else.
void check_frame(const Check& check) {
  const GravityKeys& g = check.c.gravity;
  if (!check.sound({"gravity.angular_velocity", "gravity.angular_acceleration"})) return;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!check.c.domain.periodic[k]) continue;
    for (const auto& [path, turn] : {std::pair{"gravity.angular_velocity", g.angular_velocity},
                                     std::pair{"gravity.angular_acceleration", g.angular_acceleration}}) {
      if (turn[(k + 1) % 3] == 0 && turn[(k + 2) % 3] == 0) continue;
      fail(check, path, "the force of a rotating frame", k,
           "only the axis of rotation can be periodic; " + open_axis(k));
      return;
    }
  }
}

}  // namespace

void check_fields(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"domain"})) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(c.domain.max[k] > c.domain.min[k])) return;
  if (check.sound({"flow.type"})) {
    if (c.flow.type == "taylor_green") check_waves(check);
    if (c.flow.type == "shear" && c.flow.shear_rate != 0 && c.domain.periodic[1])
      fail(check, "flow.type", "the shear flow", 1, open_axis(1));
  }
  if (check.sound({"gravity.type"})) {
    if (c.gravity.type == "rotating") check_frame(check);
    for (std::size_t k = 0; k < 3; ++k)
      if (c.gravity.type == "central" && c.gravity.strength != 0 && c.domain.periodic[k]) {
        fail(check, "gravity.type", "the attraction by a point", k, open_axis(k));
        break;
      }
  }
}

}  // namespace scree
