// Surfaces from STL files, both kinds: text and binary.
#pragma once

#include <string>
#include <string_view>

#include "scree/input/mesh.h"

namespace scree {

/// The triangles of an STL file, each with three corners of its own; normals and attributes are ignored. Binary is what
/// has the length that its count of triangles asks for, whatever its header says; several solids in a text are joined.
/// Throws InputError that begins with `name` and line or byte.
TriangleMesh parse_stl(std::string_view bytes, const std::string& name);

}  // namespace scree
