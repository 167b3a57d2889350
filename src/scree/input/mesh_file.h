// A surface of triangles from a file.
#pragma once

#include <string>

#include "scree/input/mesh.h"

namespace scree {

/// Reads an STL (text or binary) or OBJ file, as its name ends, and welds it (mesh_weld.h); coordinates are those of
/// the file. Throws InputError naming the file and line or byte: unreadable, not what its name says, cut off,
/// coordinates that are no finite numbers, no triangle with an area.
TriangleMesh read_mesh(const std::string& path);

}  // namespace scree
