#include "scree/particles/insert_lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"
#include "scree/particles/deviates.h"
#include "scree/particles/insert_region.h"
#include "scree/physics/math.h"

namespace scree {
namespace {

/// Sites per axis for an even filling: cubic cells of the wanted number density, then more along the axis with the
/// widest step until there are enough.
std::array<std::uint64_t, 3> even_numbers(const ParticleGroup& group) {
  double volume = 1;
  int axes = 0;
  for (int k = 0; k < 3; ++k)
    if (region_extent(group, k) > 0) {
      volume *= region_extent(group, k);
      ++axes;
    }
  std::array<std::uint64_t, 3> number{1, 1, 1};
  if (axes == 0) return number;
  const double step = sc_pow(volume / static_cast<double>(group.count), 1.0 / axes);
  for (int k = 0; k < 3; ++k)
    number[k] = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(region_extent(group, k) / step * (1 + 1e-12)));
  while (number[0] * number[1] * number[2] < group.count) {
    int widest = 0;
    for (int k = 1; k < 3; ++k)
      if (region_extent(group, k) / static_cast<double>(number[k]) >
          region_extent(group, widest) / static_cast<double>(number[widest]))
        widest = k;
    ++number[widest];
  }
  return number;
}

void refuse_tight_lattice(const ParticleGroup& group, const LatticeSites& sites, double diameter) {
  for (int k = 0; k < 3; ++k) {
    if (region_extent(group, k) == 0) continue;
    // Single layers must fit too: the body has to lie inside the region, one step wide.
    if (sites.step[k] < diameter * (1 - 1e-12))
      throw InputError(fmt::format(
          "particle group '{}': neighbours on the lattice are {:g} m apart along {}, but particles are up to {:g} m in "
          "diameter\n  = help: place fewer particles, enlarge the region, or widen the spacing",
          group.name, sites.step[k], "xyz"[k], diameter));
  }
}

}  // namespace

LatticeSites lattice_sites(const ParticleGroup& group) {
  LatticeSites sites;
  if (group.spacing == 0) sites.number = even_numbers(group);
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
  const LatticeSites sites = lattice_sites(group);
  const double largest = 2 * radius_around(group.shape, *std::max_element(diameters.begin(), diameters.end()));
  if (n > sites.count())
    throw InputError(fmt::format(
        "particle group '{}': {} of {} particles fit on a lattice with a spacing of {:g} m in the region\n"
        "  = help: place fewer particles, enlarge the region, or reduce the spacing (diameters go up to {:g} m)",
        group.name, sites.count(), n, group.spacing, largest));
  refuse_tight_lattice(group, sites, largest);
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
      const double room = region_extent(group, k) > 0 ? std::max(0.0, sites.step[k] - largest) : 0.0;
      const double x = sites.first[k] + static_cast<double>(ijk[k]) * sites.step[k];
      positions[i][k] = wrapped(x + 0.5 * group.jitter * room * (2 * u[k] - 1), setting.domain, k);
    }
  }
  return positions;
}

}  // namespace scree
