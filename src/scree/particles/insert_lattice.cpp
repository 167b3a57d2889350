#include "scree/particles/insert_lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"
#include "scree/particles/deviates.h"
#include "scree/particles/insert_random.h"
#include "scree/particles/insert_region.h"
#include "scree/physics/math.h"

namespace scree {
namespace {

/// Sites per axis for an even filling: cells of the wanted number density with the proportions of `widths`, then more
/// along the axis with the widest step until there are enough.
std::array<std::uint64_t, 3> even_numbers(const ParticleGroup& group, const std::array<double, 3>& widths) {
  std::array<double, 3> extent;
  double volume = 1;
  int axes = 0;
  for (int k = 0; k < 3; ++k) {
    extent[k] = region_extent(group, k) / widths[k];
    if (extent[k] > 0) {
      volume *= extent[k];
      ++axes;
    }
  }
  std::array<std::uint64_t, 3> number{1, 1, 1};
  if (axes == 0) return number;
  const double step = sc_pow(volume / static_cast<double>(group.count), 1.0 / axes);
  for (int k = 0; k < 3; ++k)
    number[k] = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(extent[k] / step * (1 + 1e-12)));
  while (number[0] * number[1] * number[2] < group.count) {
    int widest = 0;
    for (int k = 1; k < 3; ++k)
      if (extent[k] / static_cast<double>(number[k]) > extent[widest] / static_cast<double>(number[widest])) widest = k;
    ++number[widest];
  }
  return number;
}

using Widths = std::array<double, 3>;  // along each axis [m]

/// The greatest widths of the bodies as they are turned.
Widths widest_of(const ParticleGroup& group, std::uint32_t index, const std::vector<double>& diameters,
                 const InsertionSetting& setting) {
  Widths widest{};
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    const Newcomer newcomer{i, diameters[i], {}};
    const Widths half = half_widths(radius_around(group.shape, diameters[i]), body_of(group, index, newcomer, setting));
    for (std::size_t k = 0; k < 3; ++k) widest[k] = std::max(widest[k], 2 * half[k]);
  }
  return widest;
}

/// An axis along which neighbours would touch, or -1. Single layers must fit too: the body has to lie inside the
/// region, one step wide.
int tight_axis(const ParticleGroup& group, const LatticeSites& sites, const Widths& widest) {
  for (int k = 0; k < 3; ++k)
    if (region_extent(group, k) > 0 && sites.step[k] < widest[k] * (1 - 1e-12)) return k;
  return -1;
}

void refuse_tight_lattice(const ParticleGroup& group, const LatticeSites& sites, const Widths& widest) {
  const int k = tight_axis(group, sites, widest);
  if (k < 0) return;
  throw InputError(fmt::format(
      "particle group '{}': neighbours on the lattice are {:g} m apart along {}, but particles are up to {:g} m {}\n"
      "  = help: place fewer particles, enlarge the region, or widen the spacing",
      group.name, sites.step[k], "xyz"[k], widest[k],
      group.shape.shape.is_sphere ? "in diameter" : "wide along it as they are turned"));
}

}  // namespace

LatticeSites lattice_sites(const ParticleGroup& group, const std::array<double, 3>& widths) {
  LatticeSites sites;
  if (group.spacing == 0) sites.number = even_numbers(group, widths);
  for (int k = 0; k < 3; ++k) {
    const double extent = region_extent(group, k);
    if (group.spacing > 0) {
      sites.number[k] = extent > 0 ? static_cast<std::uint64_t>(extent / group.spacing * (1 + 1e-12)) : 1;
      sites.step[k] = group.spacing;
    } else {
      sites.step[k] = extent / static_cast<double>(sites.number[k]);
    }
    sites.first[k] = group.region_min[k] + (extent > 0 ? 0.5 * sites.step[k] : 0.0);
  }
  return sites;
}

std::vector<std::array<double, 3>> lattice_positions(const ParticleGroup& group, std::uint32_t index,
                                                     const std::vector<double>& diameters,
                                                     const InsertionSetting& setting) {
  const std::uint64_t n = diameters.size();
  if (n == 0) return {};
  const Widths widest = widest_of(group, index, diameters, setting);
  LatticeSites sites = lattice_sites(group);
  // Long bodies turned alike stand closer to each other in cells of their proportions.
  if (tight_axis(group, sites, widest) >= 0 && group.spacing == 0) sites = lattice_sites(group, widest);
  if (n > sites.count())
    throw InputError(fmt::format(
        "particle group '{}': {} of {} particles fit on a lattice with a spacing of {:g} m in the region\n"
        "  = help: place fewer particles, enlarge the region, or reduce the spacing (particles are up to {:g} m wide)",
        group.name, sites.count(), n, group.spacing, *std::max_element(widest.begin(), widest.end())));
  refuse_tight_lattice(group, sites, widest);
  std::vector<std::array<double, 3>> positions(n);
  for (std::uint64_t i = 0; i < n; ++i) {
    std::uint64_t site = i;
    if (group.spacing == 0) site = static_cast<std::uint64_t>(static_cast<unsigned __int128>(i) * sites.count() / n);
    const std::array<std::uint64_t, 3> ijk{site % sites.number[0], site / sites.number[0] % sites.number[1],
                                           site / sites.number[0] / sites.number[1]};
    const std::uint32_t stream = random_stream(Purpose::jitter, index);
    const auto xy = uniform_pair({setting.seed, stream, i, 0}), z = uniform_pair({setting.seed, stream, i, 1});
    const std::array<double, 3> u{xy[0], xy[1], z[0]};
    for (int k = 0; k < 3; ++k) {
      const double room = region_extent(group, k) > 0 ? std::max(0.0, sites.step[k] - widest[k]) : 0.0;
      const double x = sites.first[k] + static_cast<double>(ijk[k]) * sites.step[k];
      positions[i][k] = wrapped(x + 0.5 * group.jitter * room * (2 * u[k] - 1), setting.domain, k);
    }
  }
  return positions;
}

}  // namespace scree
