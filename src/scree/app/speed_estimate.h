// How fast things may get in a case, estimated before the run.
#pragma once

#include <string>
#include <vector>

#include "scree/app/body_kinds.h"
#include "scree/data/walls.h"
#include "scree/input/case.h"

namespace scree {

/// Speeds of the undisturbed flow [m/s].
struct FlowSpeeds {
  double mean = 0, fastest = 0;
};

/// Of Taylor-Green by formula (mean 0.7799416 A, fastest 2 A), else from samples over the domain and the run.
FlowSpeeds flow_speeds(const Case& c);

/// Relaxation time m / (3 pi mu d) of a sphere in the fluid of the case under Stokes drag [s].
double relaxation_time(const Case& c, double density, double diameter);

/// The fastest impact that is to be expected and where it comes from.
struct TopSpeed {
  double value = 0;  // [m/s]
  std::string source = {};
  std::string wall = {};  // the fastest one, if walls that move are part of it
};

/// simulation.top_speed if given. Else the largest of: the relative speeds of two groups, or of a group and a wall, at
/// the start (random velocities count with four standard deviations); with drag, the fastest flow; and, with a body
/// force, the speed v of the start increased by a fall through the domain, sqrt(v^2 + 2 sum |g_k| L_k), of which drag
/// leaves at most v plus the terminal speed of Stokes for the largest particle. Along a periodic axis the fall has no
/// end: drag decides, or without it one period counts. Buoyancy counts where it is on. A rotating frame adds the speed
/// of its farthest corner, walls that move the speed of the fastest of them; `walls` are those of the case.
TopSpeed top_speed(const Case& c, const std::vector<BodyKind>& kinds, const Walls& walls);

}  // namespace scree
