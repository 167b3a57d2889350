// Saving a fluid and continuing it, and the hash that tells whether two are the same to the last bit.
#pragma once

#include <string>

#include "scree/fluid/averages.h"
#include "scree/fluid/solver.h"
#include "scree/output/archive.h"

namespace scree {

/// Everything that continuing to the last bit needs, at the root; to be called by all ranks.
Archive save_fluid(const FluidSolver& s);

/// Continues from what save_fluid() gave, on any number of ranks.
void restore_fluid(FluidSolver& s, const Archive& archive);

/// The same for averages over time.
void save_averages(const FluidSolver& s, const FluidAverages& averages, Archive& archive);
void restore_averages(const FluidSolver& s, const Archive& archive, FluidAverages& averages);

/// SHA-256 over time, velocities, fluxes and pressure, at the root; to be called by all ranks.
std::string fluid_hash(const FluidSolver& s);

}  // namespace scree
