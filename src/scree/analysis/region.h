// What is in a box: how densely its particles are packed, and how many others each of them touches.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/forms.h"
#include "scree/data/particles.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// A box; along a periodic axis within the domain.
struct Region {
  std::array<double, 3> min{}, max{};  // [m]
};

/// A form cut into narrow cones from its centre to its surface. Of each cone the part in a box is known exactly, so
/// that the number of cones decides only how well the rim of a cut is followed: within 0.3 % of the body for spheres
/// and ellipsoids, 2 % for boxes with sharp edges. Over many bodies that are cut at random it averages out.
struct FormCones {
  std::vector<sc_vec> tips;    // middle of each cone's end on the surface, at bounding radius 1
  std::vector<double> shares;  // of the volume; their sum is 1
};

FormCones cut_into_cones(const sc_form& form);

/// Volume of the particles in a box over that of the box, of those across its faces what is inside, bodies of infinite
/// mass among them; where bodies overlap both count. An exact sum over the particles: the same bits in any order. Of
/// several ranks all call it with their own particles, and the root gets the result.
double solid_fraction(const Region& region, const Particles& particles, const Forms& forms, const Domain& domain,
                      const Ranks& ranks = {});

/// Whether a particle with this row of motion has finite mass and its centre in the box.
bool has_centre_in(const Region& region, const double* motion);

/// Mean number of contacts, `contacts` by the place of a particle, of those of finite mass whose centre is in the box;
/// NaN if there is none. Likewise with several ranks.
double coordination_number(const Region& region, const Particles& particles, std::span<const std::int32_t> contacts,
                           const Ranks& ranks = {});

}  // namespace scree
