#include "scree/app/build_walls.h"

#include "scree/app/build_materials.h"

namespace scree {
namespace {

sc_vec vec_of(const Vec3& v) { return sc_make_vec(v[0], v[1], v[2]); }

sc_wall face_of(int kind, int material) {
  sc_wall face{};
  face.kind = kind;
  face.material = material;
  return face;
}

sc_wall plane(const WallKeys& keys, int material) {
  sc_wall face = face_of(SC_WALL_PLANE, material);
  const sc_vec normal = vec_of(keys.normal);
  face.point = vec_of(keys.point);
  face.normal = sc_scale(1 / sc_norm(normal), normal);
  return face;
}

sc_wall block(int kind, const Vec3& min, const Vec3& max, int material) {
  sc_wall face = face_of(kind, material);
  face.low = vec_of(min);
  face.high = vec_of(max);
  return face;
}

}  // namespace

Walls build_walls(const Case& c) {
  Walls walls;
  for (const WallKeys& keys : c.walls) {
    const std::int32_t owner = static_cast<std::int32_t>(walls.names.size());
    const int material = material_index(c, keys.material);
    walls.names.push_back(keys.name);
    if (keys.type == "plane") {
      walls.faces.push_back(plane(keys, material));
    } else if (keys.type == "rectangle") {
      walls.faces.push_back(block(SC_WALL_RECTANGLE, keys.min, keys.max, material));
    } else if (keys.side == "outside") {
      walls.faces.push_back(block(SC_WALL_SOLID_BOX, keys.min, keys.max, material));
    } else {
      for (int axis = 0; axis < 3; ++axis)
        for (const double side : {keys.min[axis], keys.max[axis]}) {
          Vec3 min = keys.min, max = keys.max;
          min[axis] = max[axis] = side;
          walls.faces.push_back(block(SC_WALL_RECTANGLE, min, max, material));
        }
      walls.rooms.push_back({keys.min, keys.max, owner});
    }
    walls.owner.resize(walls.faces.size(), owner);
  }
  return walls;
}

}  // namespace scree
