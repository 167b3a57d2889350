// The walls of a run: the surfaces that the narrow phase sees, and the closed rooms that particles must be in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scree/physics/touch/wall.h"

namespace scree {

/// A box whose inside holds the particles.
struct Room {
  std::array<double, 3> min{}, max{};  // [m]
  std::int32_t owner = 0;              // index into Walls::names
};

/// Every wall of the case becomes one face, a box with particles inside six. Contacts with walls are summed in the
/// order of the faces.
struct Walls {
  std::vector<sc_wall> faces;
  std::vector<std::int32_t> owner;  // [faces]: index into names
  std::vector<std::string> names;   // of the walls of the case
  std::vector<Room> rooms;

  std::size_t size() const { return faces.size(); }
};

}  // namespace scree
