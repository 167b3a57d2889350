#include "scree/output/shape_file.h"

#include <fmt/format.h>

#include "scree/base/atomic_file.h"

namespace scree {

std::filesystem::path shape_file(const std::filesystem::path& directory, std::size_t form) {
  return directory / fmt::format("shape_{}.obj", form);
}

void write_shape_file(const std::filesystem::path& path, const Form& form) {
  const FormMesh mesh = form_mesh(form);
  std::string text = fmt::format("# A {} over its half axes: half_axes of the frames stretch it.\n", form.shape_name());
  for (const sc_vec& x : mesh.points) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", x.x, x.y, x.z);
  for (const sc_vec& n : mesh.normals) text += fmt::format("vn {:.9g} {:.9g} {:.9g}\n", n.x, n.y, n.z);
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a + 1, b + 1, c + 1);
  write_text_file(path, text);
}

}  // namespace scree
