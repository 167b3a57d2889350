// Particles from the columns of a CSV file.
#pragma once

#include <string>
#include <vector>

#include "scree/particles/insert.h"

namespace scree {

/// Reads a comma-separated file whose first line names the columns, in any order: x, y, z [m] are required; vx, vy, vz
/// [m/s], wx, wy, wz [rad/s] (all three or none) and diameter [m] are optional. Blank lines and lines that begin with #
/// are skipped. Throws InputError naming file and line.
std::vector<GivenParticle> read_particle_table(const std::string& path);

}  // namespace scree
