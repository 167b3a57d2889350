// What volume of particles passes the faces of cells as they move: shared out so that every cell gains exactly what its
// share of them grows by (Esirkepov 2001, Comput. Phys. Commun. 135, 144, for charges in a plasma).
#pragma once

#include "scree/coupling/spread.h"

namespace scree {

/// Shares out what has passed the lower faces of the cells along x, y, z since the fluid's last step, of `volume`. In
/// the direction of the axes it counts positive. Returns for each particle whether that is known: not of one that the
/// fluid has not met before, that has leapt over more cells than it touches, or that is beside cells without fluid.
/// They have passed nothing: their volume goes and comes.
std::vector<std::uint8_t> spread_passage(const Spreading& spreading, const Particles& particles, const Quantity& volume,
                                         const CellBox& box, Deposits& out);

/// Notes where the fluid has met the particles.
void note_meeting(Particles& particles);

}  // namespace scree
