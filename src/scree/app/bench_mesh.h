// The meshes of the benchmark scenes, which Scree and its peers read from the same file.
#pragma once

#include <string>
#include <vector>

#include "scree/input/mesh.h"

namespace scree {

/// A closed drum about the x axis, from x = 0 to `length`: 64 segments around, triangles about as high as wide [m].
TriangleMesh drum_mesh(double radius, double length);

/// The walls of a bin that is square seen from above, of the half width `bin`, over a hopper that narrows to the half
/// width `outlet` at z = 0; open above and below [m].
TriangleMesh silo_mesh(double bin, double bin_height, double outlet, double hopper_height);

/// The mesh as a text STL file; reading it back gives the same numbers.
std::string stl_text(const std::string& name, const TriangleMesh& mesh);

/// Writes SCENE.stl into `directory` if the scene has a mesh and the file is not there yet. Returns what must be
/// changed in the scene's cases, whose first wall it is; nothing for a scene without a mesh. Throws ResourceError.
std::vector<std::string> make_mesh(const std::string& scene, const std::string& directory);

}  // namespace scree
