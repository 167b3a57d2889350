// Saving a fluid and continuing it, and the hash that tells whether two are the same to the last bit.
#pragma once

#include <optional>
#include <string>

#include "scree/coupling/coupling.h"
#include "scree/fluid/averages.h"
#include "scree/output/archive.h"

namespace scree {

/// Everything that continuing to the last bit needs, at the root; to be called by all ranks.
Archive save_fluid(const FluidSolver& s);

/// Adds the fluid to an archive that has a step and a time of its own.
void put_fluid(const FluidSolver& s, Archive& archive);

/// The same of a fluid with particles in it, which are saved elsewhere.
void put_coupling(const FluidCoupling& coupling, Archive& archive);
void restore_coupling(FluidCoupling& coupling, const Archive& archive);

/// How many steps of the particles the last step of the fluid took; empty before the first.
std::optional<int> saved_subcycles(const Archive& archive);

/// Continues from what save_fluid() gave, on any number of ranks.
void restore_fluid(FluidSolver& s, const Archive& archive);

/// The same for averages over time.
void save_averages(const FluidSolver& s, const FluidAverages& averages, Archive& archive);
void restore_averages(const FluidSolver& s, const Archive& archive, FluidAverages& averages);

/// SHA-256 over time, velocities, fluxes and pressure, at the root; to be called by all ranks.
std::string fluid_hash(const FluidSolver& s);

}  // namespace scree
