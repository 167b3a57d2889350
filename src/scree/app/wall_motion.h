// Walls that move as prescribed: where each of them is at any time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scree/base/expression.h"
#include "scree/data/domain.h"
#include "scree/data/walls.h"
#include "scree/input/case.h"

namespace scree {

/// The motion of a wall. Places are functions of time alone, so that a run which continues finds the wall where one
/// that never stopped has it.
struct WallMotion {
  enum class Kind { none, velocity, rotation, oscillation, expression, surface };

  std::string wall;  // its name
  Kind kind = Kind::none;
  sc_vec velocity{}, amplitude{};                   // [m/s], [m]
  sc_vec pivot{}, axis{};                           // a point [m] and the unit direction of the axis of rotation
  double rate = 0, phase = 0;                       // angular velocity or frequency [rad/s]; [rad]
  std::vector<Expression> formulas;                 // displacement x y z [m], angle [rad]; of t
  double start = 0, stop = 0, from = 0, until = 0;  // of the motion, and of the wall [s]
  double reach = 0;   // how far from the axis of rotation the wall goes, as far as particles get there [m]
  double extent = 0;  // the same, of the parts whose turning changes the shape of the wall [m]
};

/// The motions of all walls of a case.
std::vector<WallMotion> build_wall_motions(const Case& c, const Walls& walls, const Domain& domain);

/// The pose of a wall at `time`, where steps take `dt` and contacts see velocities of `lag` before [s]. Throws
/// PhysicsError when its formulas give no finite number then.
sc_wall_pose pose_at(WallMotion& motion, double time, double lag, double dt);

/// The fastest that any part or surface of the wall gets up to a time [s], from samples where it moves by formulas
/// [m/s].
double fastest_speed(WallMotion& motion, double end);

/// How far any part of the wall that particles may meet goes between two times, at most [m].
double greatest_way(WallMotion& motion, double from, double to);

}  // namespace scree
