// Averages on a grid over space and time: how much there is, how fast it moves, and what stresses it carries.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scree/analysis/coarse_grain.h"
#include "scree/particles/sample.h"

namespace scree {

/// What is added up in every cell, sample after sample; densities times the volume of a cell.
namespace sum_of {
enum : int {
  number = 0,
  solid = 1,       // [m3]
  mass = 2,        // [kg]
  momentum = 3,    // x y z [kg m/s]
  flow = 6,        // momentum times velocity xx xy xz yy yz zz [J]
  contact = 12,    // xx xy xz yx yy yz zx zy zz, first the force, then the branch vector; positive when pressed [J]
  wall_force = 21  // of walls and bodies of infinite mass on the particles x y z [N]
};
inline constexpr int count = 24;
}  // namespace sum_of

/// Sums over samples.
struct Averages {
  CellGrid3 grid;
  std::int64_t samples = 0;
  std::vector<double> sums;  // [cells][sum_of::count]
};

Averages start_averages(const CellGrid3& grid);

/// Adds a sample that has the forces of its contacts. Stresses are those of exact coarse graining: Goldhirsch 2010
/// (Granular Matter 12:239), with walls and bodies of infinite mass as the boundary of Weinhart et al. 2012 (Granular
/// Matter 14:289): a contact with one is spread from the centre to the contact point, and its force is kept as a force
/// density there. Bodies of infinite mass do not count as material.
///
/// Every cell is the work of one thread and takes its contributions in the order of ids: the bits do not depend on
/// threads.
void add_sample(Averages& averages, const Sample& sample);

/// One field of the averages.
struct AverageField {
  std::string name, unit, meaning;
  int components = 1;
  std::vector<double> values;  // [cells][components]
};

/// The fields of averages of one sample or more; velocity and temperature are NaN where there is nothing.
std::vector<AverageField> fields_of(const Averages& averages);

}  // namespace scree
