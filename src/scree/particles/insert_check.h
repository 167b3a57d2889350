// Whether bodies are clear of the walls, and whether the particles of a new run are where they may be.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scree/particles/insert.h"
#include "scree/physics/touch/shape_shape.h"

namespace scree {

/// True if a body, or without one the sphere, touches no wall, is on the right side of every plane, outside solid boxes
/// and, where there are rooms, wholly inside one of them. `radius`: around the body.
bool clear_of_walls(const Walls* walls, const std::array<double, 3>& position, double radius,
                    const std::optional<sc_body_shape>& body);

/// Throws InputError naming the particle, its place and its group when one lies outside the domain, or a free one lies
/// deeper than setting.max_overlap of its radius in a wall or outside every room.
void check_places(const Particles& particles, const std::vector<ParticleGroup>& groups,
                  const InsertionSetting& setting);

/// Throws InputError naming the deepest pair when two particles, not both of infinite mass, overlap by more than
/// setting.max_overlap of the smaller radius.
void check_overlaps(const Particles& particles, const std::vector<ParticleGroup>& groups,
                    const InsertionSetting& setting);

}  // namespace scree
