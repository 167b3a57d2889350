// Particles share quantities out to cells and read cell values back, with the same weights in both directions.
#pragma once

#include <array>
#include <vector>

#include "scree/coupling/patch.h"
#include "scree/coupling/weights.h"
#include "scree/data/forms.h"
#include "scree/data/particles.h"

namespace scree {

/// The weights of a grid, and what stands for bodies that are large against its cells.
struct Spreading {
  Spreading(const FluidRegion& region, const Forms& forms);

  std::array<SplineAxis, 3> axis;
  std::vector<std::uint8_t> blocked;  // of all cells of the grid, 1 where there is no fluid; empty where all is
  // Of each form: half of the way to the eight points that stand for the body, along its axes, over the bounding
  // radius. Eighths of the volume there have the moments of the body. Zero for one point.
  std::vector<Axes> points;
};

/// The cells that the particles touch, and those that they touched at the fluid's last step.
CellBox touched_cells(const Spreading& spreading, const Particles& particles);

/// A quantity of each particle, `components` numbers in a row; and the power of two that makes whole numbers of it.
struct Quantity {
  std::vector<double> values;
  int components = 1;
  double scale = 1;
};

/// The scale for a quantity: the largest of all ranks keeps 50 bits, and the sum over all of them fits.
double scale_for(const Quantity& quantity, std::int64_t particles_of_all, const Ranks& ranks);

/// Shares quantities out. The deposits of a particle add up to it exactly (rounded to the scale): the largest weight
/// takes the rest. Integers, so that sums depend on no order.
void spread(const Spreading& spreading, const Particles& particles, const std::vector<const Quantity*>& quantities,
            const CellBox& box, Deposits& out);

/// The weighted means of cell values at the particles, [particles][values.width].
void read_at(const Spreading& spreading, const Particles& particles, const CellValues& values,
             std::vector<double>& out);

}  // namespace scree
