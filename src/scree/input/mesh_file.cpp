#include "scree/input/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/input/mesh_weld.h"
#include "scree/input/obj.h"
#include "scree/input/stl.h"

namespace scree {

TriangleMesh read_mesh(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".stl" && ending != ".obj")
    throw InputError(fmt::format("{}: expected a file of triangles whose name ends in .stl or .obj", path));
  const std::string bytes = read_text_file(path);
  const TriangleMesh loose = ending == ".stl" ? parse_stl(bytes, path) : parse_obj(bytes, path);
  TriangleMesh mesh = weld(loose);
  if (mesh.triangles.empty())
    throw InputError(loose.triangles.empty() ? fmt::format("{}: there is no triangle in this file", path)
                                             : fmt::format("{}: none of the {} triangles of this file has an area",
                                                           path, loose.triangles.size()));
  return mesh;
}

}  // namespace scree
