// Where solids move, fluid makes way, and the pressure that drives it acts on them in the step that follows. A bed
// swings on its contacts; answered a step late by fluid that is about as heavy as it is, it is driven on until it
// bursts. So in liquids the fluid makes way in every step for a part only of what it owes: seen from the particles, it
// follows them with a lag of a few of its steps, which dampens what swings faster and leaves alone what moves more
// slowly (docs/decisions/0022-coupling.md).
#pragma once

#include "scree/fluid/flow.h"
#include "scree/fluid/mesh.h"

namespace scree {

struct MakingWay {
  Field solids;      // of each cell's volume, where the particles are; 1 - FluidLoad::fraction lags behind
  VectorField owed;  // volume that has passed the faces and that the fluid has not made way for yet [m3]
};

/// The part of what is owed that the fluid makes way for in a step: 1 / (1 + 2 inertia), where `inertia` is that of the
/// fluid that makes way for a packed bed over the bed's; from 3 on (particles half as heavy as the fluid) a seventh.
/// By analysis of the loop, twice what beds need whose steps of the fluid are a twelfth of their contacts.
double part_made_way_for(double inertia);

/// Void fraction, flux and passage of the fluid's next step: `part` of what `way` owes after what has moved now, the
/// volume flux `flux` in cells, `way.solids`, and `load.passed`, is added to what has been made way for.
void make_way(MakingWay& way, const Mesh& mesh, double part, const VectorField& flux, FluidLoad& load);

/// The impulse that cells have given by pressure to solids that are not there, or not given to those that are, since
/// the fluid lags behind [N s]: added to `returned`, of a step as long as `dt`.
void settle_pressure(const MakingWay& way, const Mesh& mesh, const FluidLoad& load, double dt, VectorField& returned);

}  // namespace scree
