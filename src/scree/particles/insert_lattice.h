// Places on a cubic lattice.
#pragma once

#include <array>
#include <vector>

#include "scree/particles/insert.h"

namespace scree {

/// A block of lattice sites: site (i, j, k) is at first + (i, j, k) * step.
struct LatticeSites {
  std::array<double, 3> first{}, step{};  // [m]
  std::array<std::uint64_t, 3> number{};

  std::uint64_t count() const { return number[0] * number[1] * number[2]; }
};

/// The sites of a group. With a spacing: as many as fit, from the lower corner. Without: the fewest that hold
/// `group.count` particles, spread evenly over the region, their cells as near to the proportions of `widths` as the
/// region allows.
LatticeSites lattice_sites(const ParticleGroup& group, const std::array<double, 3>& widths = {1, 1, 1});

/// The centres of the group's particles. With a spacing they fill the sites row by row, x fastest, z slowest; without,
/// sites that are left over are spread evenly. Each centre is then shifted along each axis by at most `group.jitter`
/// times half the gap between neighbours of the largest width, so bodies never overlap for a jitter up to 1.
/// Throws InputError when the group does not fit.
std::vector<std::array<double, 3>> lattice_positions(const ParticleGroup& group, std::uint32_t index,
                                                     const std::vector<double>& diameters,
                                                     const InsertionSetting& setting);

}  // namespace scree
