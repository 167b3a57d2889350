// The domain, the walls in it, and where particles are put.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scree/input/checks.h"

namespace scree {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

std::string words(const Vec3& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

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
               fmt::format("min is {}", words(d.min)), "'min' is the lower corner, 'max' the upper one");
    return;
  }
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
  for (const ParticleKeys& p : c.particles) range = std::max(range, largest_diameter(p.diameter) + p.effect_gap);
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
  const bool filled = p.insert == "lattice" || p.insert == "random";
  const bool given = check.origins.given(path + ".region_min") || check.origins.given(path + ".region_max");
  if (!filled || !given || !check.sound({path + ".region_min", path + ".region_max", path + ".insert", "domain"}))
    return;
  for (std::size_t i = 0; i < 3; ++i) {
    if (p.region_max[i] > p.region_min[i]) continue;
    check.fail("E165", path + ".region_max", fmt::format("the region of '{}' is empty along {}", p.name, axis_names[i]),
               fmt::format("region_min is {}", words(p.region_min)), "'region_max' is the upper corner");
    return;
  }
  for (const auto& [name, corner] : {std::pair{".region_min", p.region_min}, std::pair{".region_max", p.region_max}})
    if (!inside(corner, check.c.domain))
      check.fail("E165", path + name, fmt::format("the region of '{}' reaches out of the domain", p.name),
                 fmt::format("the domain is {} to {}", words(check.c.domain.min), words(check.c.domain.max)),
                 "shrink the region, or enlarge [domain]");
}

void check_positions(const Check& check, std::size_t index) {
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index) + ".positions";
  if (p.insert != "positions" || !check.sound({path, "domain"})) return;
  for (std::size_t k = 0; k < p.positions.size(); ++k) {
    if (inside(p.positions[k], check.c.domain)) continue;
    check.fail("E165", path, fmt::format("position {} of '{}' is outside the domain", k, p.name),
               fmt::format("{} is not in {} to {}", words(p.positions[k]), words(check.c.domain.min),
                           words(check.c.domain.max)),
               "positions are counted from 0");
    return;
  }
}

void check_wall(const Check& check, std::size_t index) {
  const WallKeys& w = check.c.walls[index];
  const std::string path = item_path("walls", index);
  if (!check.sound({path + ".type", path + ".normal", path + ".point", path + ".min", path + ".max"})) return;
  if (w.type == "plane") {
    const double length = std::hypot(w.normal[0], w.normal[1], w.normal[2]);
    if (!(length > 1e-100 && length < 1e100))
      check.fail("E165", path + ".normal", fmt::format("the normal of wall '{}' has no direction", w.name),
                 fmt::format("its length is {}", length), "give the direction from the plane towards the particles");
    return;
  }
  int flat = 0, reversed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    flat += w.max[i] == w.min[i] ? 1 : 0;
    reversed += w.max[i] < w.min[i] ? 1 : 0;
  }
  if (reversed > 0)
    check.fail("E165", path + ".max", fmt::format("max is below min in wall '{}'", w.name),
               fmt::format("min is {}", words(w.min)), "'min' is the lower corner, 'max' the upper one");
  else if (w.type == "rectangle" && flat != 1)
    check.fail("E165", path + ".max",
               fmt::format("the rectangle '{}' is flat along {} axes instead of one", w.name, flat),
               fmt::format("min is {}", words(w.min)), "min and max of a rectangle agree along exactly one axis");
  else if (w.type == "box" && flat > 0)
    check.fail("E165", path + ".max", fmt::format("the box '{}' has no volume", w.name),
               fmt::format("min is {}", words(w.min)), "a wall that is flat is a 'rectangle'");
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
  for (std::size_t i = 0; i < check.c.walls.size(); ++i) check_wall(check, i);
}

}  // namespace scree
