// Where solids move, fluid makes way, and the pressure that drives it acts on them in the step that follows. Answered a
// step late, a packed bed that swings on its contacts in a liquid about as heavy as it is, or one that drag holds back
// within that step, is driven on until it bursts. There the fluid makes way in every step for a part only of what it
// owes: it follows the particles with a lag of a few of its steps, which dampens what swings faster and leaves alone
// what moves more slowly (docs/decisions/0022-coupling.md).
#pragma once

#include "scree/fluid/flow.h"
#include "scree/fluid/mesh.h"

namespace scree {

struct MakingWay {
  double part = 1;   // of what is owed, that is made way for in the step
  Field solids;      // of each cell's volume, where the particles are; 1 - FluidLoad::fraction lags behind
  VectorField owed;  // volume that has passed the faces and that the fluid has not made way for yet [m3]
};

/// Inertia of the fluid that makes way for solids, over theirs, where `solids` of a cell's volume is solid and the
/// fluid has `heaviness` times their density.
double inertia_of_way(double solids, double heaviness);

/// The part of what is owed that the fluid makes way for in a step, where at most `solids` of a cell's volume is solid.
/// `heaviness`: the density of the fluid over that of the lightest particles; `relaxation`: the step over the shortest
/// time in which drag stops one. 1 where both are small, as in most gases; never less than a seventh.
double part_made_way_for(double solids, double heaviness, double relaxation);

/// Void fraction, flux and passage for the fluid's next step: where the particles are now, as `way.solids`, their
/// volume flux in cells, `flux`, and what has passed, `load.passed`, say, they follow by `way.part`.
void make_way(MakingWay& way, const Mesh& mesh, const VectorField& flux, FluidLoad& load);

/// The impulse that cells have given by pressure to solids that are not there, or not given to those that are, since
/// the fluid lags behind [N s]: added to `returned`, of a step as long as `dt`.
void settle_pressure(const MakingWay& way, const Mesh& mesh, const FluidLoad& load, double dt, VectorField& returned);

}  // namespace scree
