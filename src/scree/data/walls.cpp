#include "scree/data/walls.h"

#include <limits>

namespace scree {
namespace {

FaceBox point_box(sc_vec x) { return {x, x}; }

/// The box around a circle.
FaceBox circle_box(sc_vec centre, sc_vec axis, double radius) {
  const auto reach = [radius](double along) { return radius * SC_SQRT(SC_MAX(1 - along * along, 0.0)); };
  const sc_vec half = sc_make_vec(reach(axis.x), reach(axis.y), reach(axis.z));
  return {sc_sub(centre, half), sc_add(centre, half)};
}

}  // namespace

FaceBox box_of(const sc_wall& face) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (face.kind == SC_WALL_PLANE)
    return {sc_make_vec(-infinity, -infinity, -infinity), sc_make_vec(infinity, infinity, infinity)};
  FaceBox box = FaceBox::empty();
  if (face.kind == SC_WALL_FRUSTUM) {
    box.extend(circle_box(face.a, face.b, face.start_radius));
    box.extend(circle_box(sc_add_scaled(face.a, face.length, face.b), face.b, face.end_radius));
    return box;
  }
  box.extend(point_box(face.a));
  if (face.kind == SC_WALL_PLATE) {
    const sc_vec end = sc_add(face.a, face.b);
    box.extend(point_box(end));
    box.extend(point_box(sc_add(face.a, face.c)));
    box.extend(point_box(sc_add(end, face.c)));
    return box;
  }
  box.extend(point_box(face.b));
  if (face.kind == SC_WALL_TRIANGLE) box.extend(point_box(face.c));
  return box;
}

void plant_trees(Walls& walls) {
  walls.trees.clear();
  walls.first_face.assign(1, 0);
  for (std::size_t body = 0; body < walls.poses.size(); ++body) {
    std::vector<FaceBox> boxes;
    std::size_t face = walls.first_face.back();
    for (; face < walls.faces.size() && walls.faces[face].body == static_cast<int>(body); ++face)
      boxes.push_back(box_of(walls.faces[face]));
    walls.trees.emplace_back(boxes);
    walls.first_face.push_back(face);
  }
}

}  // namespace scree
