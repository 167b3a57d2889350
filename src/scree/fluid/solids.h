// What moves in the flow and takes part of its volume. Its volume flux through the faces (state.solids_flux, G) is
// known from how it has moved, and is exactly as much as the void fraction changes by:
//   d(1 - e)/dt + div G = 0
// Cells know only their own flux per area (load.solids). What interpolation between them misses of G at a face,
// state.solids_beyond, the flux of the fluid misses in the other direction. So a uniform velocity of the fluid and of
// what moves with it needs no pressure to keep the volume, and stays uniform whatever the void fraction is.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Renews what ranks know of each other's cells of `load.solids`.
void renew_solids(FluidSolver& s);

/// At the start nothing has passed yet: the flux is that of the cells.
void begin_solids(FluidSolver& s);

/// Takes over what has passed since the last step, and estimates the flux of the fluid for the next one as what the
/// flux of all, which needs no source, leaves for it.
void take_solids(FluidSolver& s, const Bdf& bdf);

/// The push of a cell as its half of a face is given it, over the void fraction felt [N/m3]: like that of the cell, but
/// drag counts what the flux of the face is slower than what moves there. `lower` is the weight of the cell below.
double half_push(const FluidSolver& s, int axis, std::int64_t face, std::int64_t cell, double lower);

/// How much more a face between two cells is given than the mean of their own pushes [N/m3].
double push_drift(const FluidSolver& s, int axis, std::int64_t face);

/// What each cell's own push is beyond the mean of its halves, into work.push_shift.
void find_push_shift(FluidSolver& s);

}  // namespace scree
