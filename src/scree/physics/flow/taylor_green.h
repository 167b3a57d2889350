// Frozen Taylor-Green vortices (report, 6.1 to 6.3): free of divergence, but no steady solution of the flow equations.
#ifndef SCREE_PHYSICS_FLOW_TAYLOR_GREEN_H
#define SCREE_PHYSICS_FLOW_TAYLOR_GREEN_H

#include "scree/physics/math.h"
#include "scree/physics/vec.h"

/// Velocity [m/s] at x for the amplitude A [m/s] and the wavenumber a [1/m]; period 2 pi/a, cells pi/a wide, mean speed
/// 0.77994166 A (the report's 0.7839 is wrong).
SC_FN sc_vec sc_taylor_green(sc_vec x, real amplitude, real wavenumber) {
  const real sx = sc_sin(wavenumber * x.x);
  const real cx = sc_cos(wavenumber * x.x);
  const real sy = sc_sin(wavenumber * x.y);
  const real cy = sc_cos(wavenumber * x.y);
  const real sz = sc_sin(wavenumber * x.z);
  const real cz = sc_cos(wavenumber * x.z);
  return sc_make_vec(-amplitude * (sx * cy * cz), -amplitude * (cx * sy * cz), R(2) * amplitude * (cx * cy * sz));
}

#endif
