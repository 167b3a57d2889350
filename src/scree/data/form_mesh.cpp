#include "scree/data/form_mesh.h"

#include "scree/physics/math.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;

/// The point in a direction over the half axes, and the normal there.
void add_point(const Form& form, const sc_vec& d, FormMesh& out) {
  const Axes a = form.half_axes();
  const sc_norm_value g = sc_gauge(form.shape, 1, sc_make_vec(a[0] * d.x, a[1] * d.y, a[2] * d.z));
  const sc_vec n = sc_make_vec(a[0] * g.gradient.x, a[1] * g.gradient.y, a[2] * g.gradient.z);
  out.points.push_back(sc_scale(1 / g.value, d));
  out.normals.push_back(sc_scale(1 / sc_norm(n), n));
}

}  // namespace

FormMesh form_mesh(const Form& form) {
  constexpr int rows = form_mesh_rows, columns = form_mesh_columns;
  FormMesh out;
  add_point(form, sc_make_vec(0, 0, 1), out);
  for (int i = 1; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double polar = pi * i / rows, around = 2 * pi * j / columns, flat = sc_sin(polar);
      add_point(form, sc_make_vec(flat * sc_cos(around), flat * sc_sin(around), sc_cos(polar)), out);
    }
  add_point(form, sc_make_vec(0, 0, -1), out);
  const auto at = [](int i, int j) { return 1 + (i - 1) * columns + j % columns; };
  const int last = static_cast<int>(out.points.size()) - 1;
  for (int j = 0; j < columns; ++j) {
    out.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < rows; ++i) {
      out.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    out.triangles.push_back({last, at(rows - 1, j + 1), at(rows - 1, j)});
  }
  return out;
}

}  // namespace scree
