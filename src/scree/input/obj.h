// Surfaces from Wavefront OBJ files.
#pragma once

#include <string>
#include <string_view>

#include "scree/input/mesh.h"

namespace scree {

/// Vertices and faces of an OBJ file. Polygons become fans of triangles; a fan that folds over is refused, which convex
/// polygons never do. Groups, materials, normals and texture are ignored, free-form surfaces refused. Throws InputError
/// that begins with `name` and line.
TriangleMesh parse_obj(std::string_view text, const std::string& name);

}  // namespace scree
