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

  Kind kind = Kind::none;
  sc_vec velocity{}, amplitude{};                   // [m/s], [m]
  sc_vec pivot{}, axis{};                           // a point [m] and the unit direction of the axis of rotation
  double rate = 0, phase = 0;                       // angular velocity or frequency [rad/s]; [rad]
  std::vector<Expression> formulas;                 // displacement x y z [m], angle [rad]; of t
  double start = 0, stop = 0, from = 0, until = 0;  // of the motion, and of the wall [s]
  double extent = 0;  // how far from the pivot the parts are that turning moves near particles [m]
};

/// The motions of all walls of a case.
std::vector<WallMotion> build_wall_motions(const Case& c, const Walls& walls, const Domain& domain);

/// The pose of a wall at `time`, where steps take `dt` and contacts see velocities of `lag` before [s].
sc_wall_pose pose_at(WallMotion& motion, double time, double lag, double dt);

/// How far any part of the wall that particles may meet goes between two times, at most [m].
double greatest_way(WallMotion& motion, double from, double to);

}  // namespace scree
