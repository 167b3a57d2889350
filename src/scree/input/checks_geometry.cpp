// The domain, and where particles are put.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scree/data/forms.h"
#include "scree/input/checks.h"

namespace scree {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

bool inside(const Vec3& point, const DomainKeys& domain) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(point[i] >= domain.min[i] && point[i] <= domain.max[i])) return false;
  return true;
}

void check_domain(const Check& check) {
  const DomainKeys& d = check.c.domain;
  for (std::size_t i = 0; i < 3; ++i) {
    if (d.max[i] > d.min[i] && std::isfinite(d.max[i] - d.min[i])) continue;
    check.fail("E165", "domain.max", fmt::format("the domain is empty along {}: max is not above min", axis_names[i]),
               fmt::format("min is {}", in_words(d.min)), "'min' is the lower corner, 'max' the upper one");
    return;
  }
}

/// Diameter of the sphere around a body over that of the sphere of its volume.
double around_body(const ParticleKeys& p) {
  const Vec3& a = p.half_axes;
  if (p.shape == "sphere" || p.exponents.size() != 2 || !(a[0] > 0 && a[1] > 0 && a[2] > 0)) return 1;
  return 1 / make_form(p.shape, a, p.exponents[0], p.exponents[1]).equivalent_radius;
}

double largest_diameter(const SizeKeys& size) {
  if (size.distribution == "classes")
    return size.diameters.empty() ? 0 : *std::max_element(size.diameters.begin(), size.diameters.end());
  return size.distribution == "single" ? size.value : size.max;
}

/// Two particles must not meet over both sides of the box: a pair has one nearest image.
void check_periods(const Check& check) {
  const Case& c = check.c;
  double range = 0;
  for (const ParticleKeys& p : c.particles)
    range = std::max(range, largest_diameter(p.diameter) * around_body(p) + p.effect_gap);
  range += c.simulation.skin;
  for (std::size_t i = 0; i < 3; ++i) {
    const double period = c.domain.max[i] - c.domain.min[i];
    if (!c.domain.periodic[i] || period > 2 * range || period <= 0) continue;
    check.fail("E166", "domain.periodic", fmt::format("the domain is too small to be periodic along {}", axis_names[i]),
               fmt::format("{} m long, must be above {} m", period, 2 * range),
               "a periodic box must be longer than two interaction ranges (largest diameter, effect gap and skin)");
  }
}

void check_region(const Check& check, std::size_t index) {
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index);
  const bool feed = p.insert == "rate", filled = p.insert == "lattice" || p.insert == "random" || feed;
  const bool given = check.origins.given(path + ".region_min") || check.origins.given(path + ".region_max");
  if (!filled || !given || !check.sound({path + ".region_min", path + ".region_max", path + ".insert", "domain"}))
    return;
  for (std::size_t i = 0; i < 3; ++i) {
    if (p.region_max[i] > p.region_min[i] || (feed && p.region_max[i] == p.region_min[i])) continue;
    check.fail("E165", path + ".region_max", fmt::format("the region of '{}' is empty along {}", p.name, axis_names[i]),
               fmt::format("region_min is {}", in_words(p.region_min)), "'region_max' is the upper corner");
    return;
  }
  for (const auto& [name, corner] : {std::pair{".region_min", p.region_min}, std::pair{".region_max", p.region_max}})
    if (!inside(corner, check.c.domain))
      check.fail("E165", path + name, fmt::format("the region of '{}' reaches out of the domain", p.name),
                 fmt::format("the domain is {} to {}", in_words(check.c.domain.min), in_words(check.c.domain.max)),
                 "shrink the region, or enlarge [domain]");
}

void check_positions(const Check& check, std::size_t index) {
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index) + ".positions";
  if (p.insert != "positions" || !check.sound({path, "domain"})) return;
  for (std::size_t k = 0; k < p.positions.size(); ++k) {
    if (inside(p.positions[k], check.c.domain)) continue;
    check.fail("E165", path, fmt::format("position {} of '{}' is outside the domain", k, p.name),
               fmt::format("{} is not in {} to {}", in_words(p.positions[k]), in_words(check.c.domain.min),
                           in_words(check.c.domain.max)),
               "positions are counted from 0");
    return;
  }
}

}  // namespace

void check_geometry(const Check& check) {
  const bool domain = check.sound({"domain"});
  if (domain) check_domain(check);
  if (domain && check.sound({"particles", "simulation.skin"})) check_periods(check);
  for (std::size_t i = 0; i < check.c.particles.size(); ++i) {
    check_region(check, i);
    check_positions(check, i);
  }
}

}  // namespace scree
