// The chosen drag law.
#ifndef SCREE_PHYSICS_DRAG_DRAG_H
#define SCREE_PHYSICS_DRAG_DRAG_H

#include "scree/physics/drag/schiller_naumann.h"
#include "scree/physics/drag/stokes.h"

enum { SC_DRAG_NONE = 0, SC_DRAG_STOKES = 1, SC_DRAG_SCHILLER_NAUMANN = 2 };

/// Rate beta at which drag relaxes the velocity: drag force over mass and relative velocity [1/s]. `slip` is the
/// relative speed [m/s], density and viscosity [kg/m3], [Pa s] those of the fluid.
SC_FN real sc_drag_rate(int law, real slip, real diameter, real inverse_mass, real density, real viscosity) {
  if (law == SC_DRAG_STOKES) return inverse_mass * sc_stokes_coefficient(diameter, viscosity);
  if (law == SC_DRAG_SCHILLER_NAUMANN) {
    return inverse_mass * sc_schiller_naumann_coefficient(slip, diameter, density, viscosity);
  }
  return R(0);
}

#endif
