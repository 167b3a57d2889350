#include "scree/fluid/boundary.h"

#include <fmt/format.h>

#include <cmath>

#include "scree/base/error.h"
#include "scree/fluid/solids.h"

namespace scree {
namespace {

/// What may be missing of what enters before it is no rounding: formulas of profiles are integrated by the midpoint.
constexpr double largest_imbalance = 1e-3;

void evaluate(BoundaryFace& f, const PatchValues& values, double time) {
  for (int c = 0; c < 3; ++c)
    if (values.velocity[c]) f.velocity[c] = values.velocity[c](f.place, time);
  if (values.pressure) f.pressure = values.pressure(f.place, time);
}

double outward_flux(const FluidSolver& s, const BoundaryFace& f) { return f.side * s.state.flux[f.axis][f.face]; }

/// Volume that must leave: the fluid displaced by what else is there, in a step.
void balance_inlets(FluidSolver& s) {
  double out = 0, moved = 0, area = 0;
  for (const BoundaryFace& f : s.boundary) {
    if (f.kind != PatchKind::inlet) continue;
    const double q = outward_flux(s, f);
    out += q;
    moved += std::abs(q);
    if (q != 0) area += f.area;
  }
  out = s.ranks.sum(out);
  moved = s.ranks.sum(moved);
  area = s.ranks.sum(area);
  if (moved == 0) return;
  if (std::abs(out) > largest_imbalance * moved)
    throw PhysicsError(
        fmt::format("the inlets of the fluid bring in {:.6g} m3/s more than they take out, and there is "
                    "no outlet\n  = help: give a patch of the boundary type = \"outlet\"",
                    -out));
  for (const BoundaryFace& f : s.boundary)
    if (f.kind == PatchKind::inlet && s.state.flux[f.axis][f.face] != 0)
      s.state.flux[f.axis][f.face] -= f.side * out * (f.area / area);
}

}  // namespace

void set_boundary(FluidSolver& s, double time) {
  for (BoundaryFace& f : s.boundary) {
    if (f.patch >= 0) evaluate(f, s.settings.patches[f.patch], time);
    if (f.kind == PatchKind::permeable) {
      const PatchValues& plate = s.settings.patches[f.patch];
      f.resistance = plate.resistance + plate.quadratic * std::abs(s.state.flux[f.axis][f.face]) / f.area;
    }
    if (gives_pressure(f)) continue;
    const bool passes = f.kind == PatchKind::inlet;
    const double fraction = s.settings.loaded ? 1 : s.state.fraction[f.cell];
    s.state.flux[f.axis][f.face] = passes ? fraction * f.area * f.velocity[f.axis] : 0;
  }
  if (!s.mesh.outlets && !s.settings.moving_void_fraction) balance_inlets(s);
}

WallFriction wall_exchange(const BoundaryFace& f, double strength) {
  if (f.depth == 1) return {strength / f.half, 0};
  const double y1 = f.half, y2 = f.second;
  return {strength * y2 / (y1 * (y2 - y1)), strength * y1 / (y2 * (y2 - y1))};
}

WallFriction wall_friction(const FluidSolver& s, const BoundaryFace& f, int component) {
  if (!holds(f, component)) return {};
  return wall_exchange(f, s.rubbed()[f.cell] * f.viscosity * f.area);
}

double force_without_plate(const FluidSolver& s, const BoundaryFace& f) {
  const double force = s.work.face_force[0].empty() ? 0.0 : s.work.face_force[f.axis][f.face];
  return force - f.side * (f.pressure - s.state.pressure[f.cell]) / f.half;
}

double boundary_force(const FluidSolver& s, const BoundaryFace& f) {
  const auto force_at = [&](std::int64_t face) {
    return s.work.face_force[0].empty() ? 0.0 : s.work.face_force[f.axis][face] - push_drift(s, f.axis, face);
  };
  const Field& p = s.state.pressure;
  if (gives_pressure(f))
    return force_without_plate(s, f) - f.resistance * s.state.flux[f.axis][f.face] / (f.area * f.half);
  if (f.depth == 1) return 0;
  // The faces of the cells behind, as if they pointed along the axis.
  const std::int64_t second = f.cell + f.inward, third = second + f.inward;
  const double near = force_at(f.side > 0 ? f.cell : second) - f.side * (p[f.cell] - p[second]) / (f.second - f.half);
  if (f.depth == 2) return near;
  const double beyond = force_at(f.side > 0 ? second : third) - f.side * (p[second] - p[third]) / f.far;
  const double own_width = 2 * f.half, next_width = 2 * (f.second - 2 * f.half);
  return near + (near - beyond) * (own_width / next_width);
}

double boundary_pressure(const FluidSolver& s, const BoundaryFace& f) {
  if (gives_pressure(f)) return f.pressure + f.side * f.resistance * s.state.flux[f.axis][f.face] / f.area;
  const double force = s.work.face_force[0].empty() ? 0.0 : s.work.face_force[f.axis][f.face];
  return s.state.pressure[f.cell] - f.side * f.half * (boundary_force(s, f) - force);
}

double passing_velocity(const FluidSolver& s, const BoundaryFace& f, int component) {
  if (!gives_pressure(f)) return f.velocity[component];
  if (f.kind == PatchKind::permeable && outward_flux(s, f) < 0)
    return component == f.axis ? s.state.flux[f.axis][f.face] / (f.area * s.state.fraction[f.cell]) : 0;
  return s.state.velocity[component][f.cell];
}

void add_boundary_convection(FluidSolver& s) {
  for (const BoundaryFace& f : s.boundary) {
    if (f.kind != PatchKind::inlet && !gives_pressure(f)) continue;
    const double out = outward_flux(s, f);
    for (int c = 0; c < 3; ++c) s.work.rhs[c][f.cell] -= out * passing_velocity(s, f, c);
  }
}

void add_boundary_friction(FluidSolver& s) {
  for (const BoundaryFace& f : s.boundary)
    for (int c = 0; c < 3; ++c) {
      const WallFriction w = wall_friction(s, f, c);
      if (w.own == 0) continue;
      const double behind = f.depth > 1 ? s.state.velocity[c][f.cell + f.inward] : 0;
      s.work.rhs[c][f.cell] += w.own * f.velocity[c] + w.behind * (behind - f.velocity[c]);
    }
}

}  // namespace scree
