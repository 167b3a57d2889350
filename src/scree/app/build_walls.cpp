#include "scree/app/build_walls.h"

#include "scree/app/build.h"
#include "scree/app/build_materials.h"
#include "scree/app/vec3.h"
#include "scree/app/wall_motion.h"
#include "scree/input/mesh_file.h"
#include "scree/input/mesh_weld.h"

namespace scree {
namespace {

void add_box(std::vector<sc_wall>& faces, const Vec3& min, const Vec3& max) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {min[axis], max[axis]}) {
      Vec3 low = min, high = max;
      low[axis] = high[axis] = side;
      faces.push_back(sc_wall_block(SC_WALL_RECTANGLE, vec_of(low), vec_of(high)));
    }
}

sc_wall plate(const WallKeys& keys) {
  sc_wall face = sc_wall_of(SC_WALL_PLATE);
  face.a = vec_of(keys.corner);
  face.b = vec_of(keys.edge_a);
  face.c = vec_of(keys.edge_b);
  return face;
}

/// Cylinder or cone; its rims are corners 0 and 1, shared with the discs that close it.
void add_round(std::vector<sc_wall>& faces, const WallKeys& keys) {
  const bool cone = keys.type == "cone";
  const sc_vec start = vec_of(keys.start), end = vec_of(keys.end), along = sc_sub(end, start);
  sc_wall side = sc_wall_of(SC_WALL_FRUSTUM);
  side.length = sc_norm(along);
  const sc_vec axis = side.length > 0 ? along : vec_of(keys.axis);
  side.a = start;
  side.b = sc_scale(1 / sc_norm(axis), axis);
  side.start_radius = cone ? keys.start_radius : keys.radius;
  side.end_radius = cone ? keys.end_radius : keys.radius;
  side.corner[0] = keys.closed ? 0 : -1;
  side.corner[1] = keys.closed ? 1 : -1;
  faces.push_back(side);
  if (!keys.closed) return;
  for (const int rim : {0, 1}) {
    sc_wall disc = sc_wall_of(SC_WALL_FRUSTUM);
    disc.a = rim == 0 ? start : end;
    disc.b = side.b;
    disc.start_radius = rim == 0 ? side.start_radius : side.end_radius;
    disc.corner[0] = rim;
    if (disc.start_radius > 0) faces.push_back(disc);
  }
}

/// The surface of a wall of type 'triangles' or 'mesh', in metres. Throws InputError if the file cannot be read.
TriangleMesh mesh_of(const WallKeys& keys) {
  if (keys.type == "mesh") {
    TriangleMesh mesh = read_mesh(keys.file);
    for (sc_vec& x : mesh.vertices) x = sc_add_scaled(vec_of(keys.offset), keys.scale, x);
    return mesh;
  }
  TriangleMesh loose;
  for (std::size_t i = 0; i < keys.vertices.size(); ++i) {
    loose.vertices.push_back(vec_of(keys.vertices[i]));
    const int corner = static_cast<int>(i);
    if (i % 3 == 2) loose.triangles.push_back({corner - 2, corner - 1, corner});
  }
  return weld(loose);
}

void add_triangles(std::vector<sc_wall>& faces, const TriangleMesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    sc_wall face = sc_wall_of(SC_WALL_TRIANGLE);
    face.a = mesh.vertices[a];
    face.b = mesh.vertices[b];
    face.c = mesh.vertices[c];
    face.corner[0] = a;
    face.corner[1] = b;
    face.corner[2] = c;
    faces.push_back(face);
  }
}

std::vector<sc_wall> faces_of(const WallKeys& keys, std::vector<MeshReport>* reports) {
  std::vector<sc_wall> faces;
  if (keys.type == "plane") {
    const sc_vec normal = vec_of(keys.normal);
    faces.push_back(sc_wall_plane(vec_of(keys.point), sc_scale(1 / sc_norm(normal), normal)));
  } else if (keys.type == "rectangle") {
    faces.push_back(sc_wall_block(SC_WALL_RECTANGLE, vec_of(keys.min), vec_of(keys.max)));
  } else if (keys.type == "plate") {
    faces.push_back(plate(keys));
  } else if (keys.type == "box" && keys.side == "outside") {
    faces.push_back(sc_wall_block(SC_WALL_SOLID_BOX, vec_of(keys.min), vec_of(keys.max)));
  } else if (keys.type == "box") {
    add_box(faces, keys.min, keys.max);
  } else if (keys.type == "triangles" || keys.type == "mesh") {
    const TriangleMesh mesh = mesh_of(keys);
    if (reports) reports->push_back(report_mesh(mesh));
    add_triangles(faces, mesh);
  } else {
    add_round(faces, keys);
  }
  return faces;
}

}  // namespace

Walls build_walls(const Case& c, std::vector<MeshReport>* reports) {
  Walls walls;
  for (const WallKeys& keys : c.walls) {
    const std::int32_t body = static_cast<std::int32_t>(walls.names.size());
    const int material = material_index(c, keys.material);
    walls.names.push_back(keys.name);
    for (sc_wall face : faces_of(keys, reports)) {
      face.body = body;
      face.material = material;
      walls.faces.push_back(face);
    }
    if (keys.type == "box" && keys.side == "inside") walls.rooms.push_back({keys.min, keys.max, body});
  }
  const std::vector<WallMotion> motions = build_wall_motions(c, walls, build_domain(c));
  for (WallMotion motion : motions) walls.poses.push_back(pose_at(motion, 0, 0, 0));
  plant_trees(walls);
  return walls;
}

}  // namespace scree
