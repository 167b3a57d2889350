// What cells are beyond the means that their particles meet (docs/decisions/0022-coupling.md, what weights do not see).
//
// A cell gives to its particles by its own velocity or temperature, and they take by weighted means over several cells.
// So each cell is pulled to a mean of means: where the particles follow the fluid, a friction or a conduction that the
// fluid has not. What of the difference they can see through their weights is to be given back.
#pragma once

#include "scree/coupling/coupling.h"

namespace scree {

/// Shares out the rates at which particles take, and the rates times what each meets (`stream`, one number or three;
/// the scales of both are set here), into `density` of the rates in the cells. Returns for each particle three numbers:
/// the weighted mean of what its cells, by `field`, are beyond the mean by rates of what their particles meet. The sum
/// of these over all particles by their rates is nothing but for rounding. To be called by all ranks.
std::vector<double> beyond_mean(FluidCoupling& coupling, const Particles& particles, const CellBox& box,
                                std::int64_t particles_of_all, Quantity& rate, Quantity& stream,
                                const VectorField& field, Field& density);

}  // namespace scree
