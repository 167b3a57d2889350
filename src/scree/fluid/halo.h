// Ghost cells: copies of the cells of neighbouring ranks, and of the other end of periodic axes.
#pragma once

#include <initializer_list>
#include <span>

#include "scree/fluid/mesh.h"

namespace scree {

/// Renews `layers` (1 or 2) layers of ghosts of the fields, edges and corners included. Beyond the ends of an axis that
/// is not periodic nothing is written.
void renew_ghosts(const Mesh& mesh, const Ranks& ranks, int layers, std::span<Field* const> fields);

inline void renew_ghosts(const Mesh& mesh, const Ranks& ranks, int layers, std::initializer_list<Field*> fields) {
  renew_ghosts(mesh, ranks, layers, std::span(fields.begin(), fields.size()));
}

}  // namespace scree
