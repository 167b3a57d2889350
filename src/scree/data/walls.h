// The walls of a run: the surfaces that the narrow phase sees, and the closed rooms that particles must be in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scree/data/face_tree.h"
#include "scree/physics/touch/sphere_wall.h"

namespace scree {

/// A box whose inside holds the particles.
struct Room {
  std::array<double, 3> min{}, max{};  // [m]
  std::int32_t owner = 0;              // index into Walls::names
};

/// Every wall of the case has one face or more, a box with particles inside six. Contacts with walls are summed in the
/// order of the faces. Faces stay where they are at t = 0; the pose of their wall tells where that is now.
struct Walls {
  std::vector<sc_wall> faces;
  std::vector<sc_wall_pose> poses;      // of the walls of the case
  std::vector<std::size_t> first_face;  // of each wall, and the number of faces
  std::vector<FaceTree> trees;          // of each wall, at home
  std::vector<std::string> names;       // of the walls of the case
  std::vector<Room> rooms;

  std::size_t size() const { return faces.size(); }
  const sc_wall_pose& pose_of(std::size_t face) const { return poses[faces[face].body]; }
  const std::string& name_of(std::size_t face) const { return names[faces[face].body]; }
};

/// The box around a face at home.
FaceBox box_of(const sc_wall& face);

/// Makes the trees for the faces and walls that there are; the faces of a wall must follow each other.
void plant_trees(Walls& walls);

/// Calls visit(face, gap) for every face within `reach` [m] of a point, present or not, in any order
/// but walls after walls.
template <class Visit>
void for_each_face_near(const Walls& walls, sc_vec x, double reach, Visit&& visit) {
  for (std::size_t body = 0; body < walls.trees.size(); ++body) {
    const sc_wall_pose& pose = walls.poses[body];
    const sc_vec home = sc_from_wall(pose, x);
    walls.trees[body].for_each_near(FaceBox::around(home, reach), [&](int number) {
      const std::size_t face = walls.first_face[body] + static_cast<std::size_t>(number);
      const sc_wall_gap gap = sc_gap_to_wall(walls.faces[face], pose, x);
      if (gap.distance < reach) visit(face, gap);
    });
  }
}

}  // namespace scree
