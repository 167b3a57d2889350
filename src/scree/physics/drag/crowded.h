// The chosen drag law among other particles: the list of laws, their force, and where they were measured.
//
// All laws are given in one form: kappa = force over relative velocity [kg/s], with the interstitial velocity u of the
// fluid (superficial velocity over void fraction), for model A: the particle feels besides it -V grad p of the mean
// pressure, and a cell loses e grad p. Model B (the whole pressure gradient in the fluid, none on the particle) takes
// kappa/e. beta = kappa (1 - e)/V. See docs/fluid_forces.md.
#ifndef SCREE_PHYSICS_DRAG_CROWDED_H
#define SCREE_PHYSICS_DRAG_CROWDED_H

#include "scree/physics/drag/beetstra.h"
#include "scree/physics/drag/di_felice.h"
#include "scree/physics/drag/drag.h"
#include "scree/physics/drag/gidaspow.h"
#include "scree/physics/drag/syamlal_obrien.h"

// The numbers go on from those of the laws of a particle alone (drag.h), which count here as well.
enum {
  SC_DRAG_ERGUN = 3,
  SC_DRAG_WEN_YU = 4,
  SC_DRAG_GIDASPOW = 5,        // Ergun below e = 0.8, Wen and Yu above
  SC_DRAG_GIDASPOW_BLEND = 6,  // with a smooth passage
  SC_DRAG_DI_FELICE = 7,
  SC_DRAG_BEETSTRA = 8,
  SC_DRAG_SYAMLAL_OBRIEN = 9
};

/// Drag over that of Stokes at the void fraction e and Re = rho U d/mu of the interstitial slip velocity U.
SC_FN real sc_crowded_factor(int law, real voidage, real reynolds) {
  if (law == SC_DRAG_STOKES) return R(1);
  if (law == SC_DRAG_SCHILLER_NAUMANN) return sc_schiller_naumann_factor(reynolds);
  if (law == SC_DRAG_ERGUN) return sc_ergun_factor(voidage, reynolds);
  if (law == SC_DRAG_WEN_YU) return sc_wen_yu_factor(voidage, reynolds);
  if (law == SC_DRAG_GIDASPOW) return sc_gidaspow_factor(voidage, reynolds);
  if (law == SC_DRAG_GIDASPOW_BLEND) return sc_gidaspow_blend_factor(voidage, reynolds);
  if (law == SC_DRAG_DI_FELICE) return sc_di_felice_factor(voidage, reynolds);
  if (law == SC_DRAG_BEETSTRA) return sc_beetstra_factor(voidage, reynolds);
  if (law == SC_DRAG_SYAMLAL_OBRIEN) return sc_syamlal_obrien_factor(voidage, reynolds);
  return R(0);
}

/// kappa = drag force over slip [kg/s] of a sphere of the given diameter [m], model A. `slip` is the speed of the fluid
/// between the particles relative to the particle [m/s], density and viscosity [kg/m3], [Pa s] those of the fluid.
SC_FN real sc_crowded_drag(int law, real voidage, real slip, real diameter, real density, real viscosity) {
  if (law == SC_DRAG_NONE) return R(0);
  const real reynolds = density * slip * diameter / viscosity;
  return sc_stokes_coefficient(diameter, viscosity) * sc_crowded_factor(law, voidage, reynolds);
}

/// Where a law rests on measurements: void fractions, and Re = rho e U d/mu of the superficial slip velocity.
typedef struct {
  real least_voidage, most_voidage, most_reynolds;
} sc_drag_range;

SC_FN sc_drag_range sc_make_drag_range(real least_voidage, real most_voidage, real most_reynolds) {
  sc_drag_range out;
  out.least_voidage = least_voidage;
  out.most_voidage = most_voidage;
  out.most_reynolds = most_reynolds;
  return out;
}

/// The range of a law (sources in docs/fluid_forces.md); outside it the formula goes on, but nobody has measured it.
SC_FN sc_drag_range sc_range_of_drag(int law) {
  if (law == SC_DRAG_STOKES) return sc_make_drag_range(R(0.99), R(1), R(0.5));
  if (law == SC_DRAG_SCHILLER_NAUMANN) return sc_make_drag_range(R(0.99), R(1), R(2e5));
  if (law == SC_DRAG_ERGUN) return sc_make_drag_range(R(0.33), R(0.8), R(1e3));
  if (law == SC_DRAG_WEN_YU) return sc_make_drag_range(R(0.8), R(1), R(1e4));
  if (law == SC_DRAG_GIDASPOW) return sc_make_drag_range(R(0.33), R(1), R(1e3));
  if (law == SC_DRAG_GIDASPOW_BLEND) return sc_make_drag_range(R(0.33), R(1), R(1e3));
  if (law == SC_DRAG_DI_FELICE) return sc_make_drag_range(R(0.4), R(1), R(1e4));
  if (law == SC_DRAG_BEETSTRA) return sc_make_drag_range(R(0.4), R(0.9), R(1e3));
  if (law == SC_DRAG_SYAMLAL_OBRIEN) return sc_make_drag_range(R(0.4), R(1), R(3e4));
  return sc_make_drag_range(R(0), R(1), R(1e30));
}

#endif
