// The chosen law of drag, lift and pitching torque of a body that is no sphere, alone or among others.
//
// Vectors are in the frame of the body; the slip is the velocity of the fluid between the particles less that of the
// body. As for spheres (crowded.h) forces are those of model A; crowding multiplies what a body alone would feel at the
// superficial velocity by Di Felice's voidage function.
#ifndef SCREE_PHYSICS_DRAG_BODY_BODY_H
#define SCREE_PHYSICS_DRAG_BODY_BODY_H

#include "scree/physics/drag/body/flow_shape.h"
#include "scree/physics/drag/body/ganser.h"
#include "scree/physics/drag/body/haider_levenspiel.h"
#include "scree/physics/drag/body/holzer_sommerfeld.h"
#include "scree/physics/drag/body/zastawny.h"
#include "scree/physics/drag/di_felice.h"
#include "scree/physics/drag/stokes.h"

// The numbers go on from those of the laws for spheres (crowded.h).
enum {
  SC_DRAG_STOKES_ELLIPSOID = 10,  // the tensor of creeping flow (Oberbeck)
  SC_DRAG_HAIDER_LEVENSPIEL = 11,
  SC_DRAG_GANSER = 12,
  SC_DRAG_HOLZER_SOMMERFELD = 13,
  SC_DRAG_ZASTAWNY_5_2 = 14,  // for ellipsoids of 2 : 2 : 5, long along z
  SC_DRAG_ZASTAWNY_5_4 = 15   // for ellipsoids of 4 : 4 : 5
};

/// A body in a stream.
typedef struct {
  sc_vec slip;                   // [m/s]
  real diameter;                 // of the sphere of equal volume [m]
  real voidage;                  // of what is around
  real density, viscosity;       // of the fluid [kg/m3], [Pa s]
  const SC_GLOBAL real* shadow;  // tables of the shape (flow_shape.h), where it has some
  const SC_GLOBAL real* mean;
} sc_body_stream;

SC_FN int sc_zastawny_shape(int law) {
  return law == SC_DRAG_ZASTAWNY_5_2   ? SC_ZASTAWNY_5_2
         : law == SC_DRAG_ZASTAWNY_5_4 ? SC_ZASTAWNY_5_4
                                       : SC_ZASTAWNY_NONE;
}

/// Re = rho e |slip| d_V/mu.
SC_FN real sc_body_reynolds(sc_body_stream b) {
  return b.density * b.voidage * sc_norm(b.slip) * b.diameter / b.viscosity;
}

/// The coefficients of Zastawny are powers of Re: held below 0.1, where they were not measured.
SC_FN real sc_zastawny_reynolds(real reynolds) { return SC_MAX(reynolds, R(0.1)); }

/// Drag of the body alone over that of Stokes on the sphere of equal volume, in a flow along the unit vector n.
SC_FN real sc_body_drag_factor(int law, sc_flow_shape s, sc_body_stream b, sc_vec n, real reynolds) {
  if (law == SC_DRAG_STOKES_ELLIPSOID) {
    return s.resistance.x * n.x * n.x + s.resistance.y * n.y * n.y + s.resistance.z * n.z * n.z;
  }
  if (law == SC_DRAG_HAIDER_LEVENSPIEL) return sc_haider_levenspiel_factor(s.sphericity, reynolds);
  if (law == SC_DRAG_GANSER) return sc_ganser_factor(s.sphericity, sc_shadow_ratio(s, b.shadow, n), reynolds);
  if (law == SC_DRAG_HOLZER_SOMMERFELD) {
    const real along = R(2) / s.sphericity - sc_mean_shadow_across(s, b.mean, n);
    return sc_holzer_sommerfeld_factor(s.sphericity, sc_shadow_ratio(s, b.shadow, n), along, reynolds);
  }
  const real cosine = SC_MIN(SC_FABS(n.z), R(1)), sine = SC_SQRT(n.x * n.x + n.y * n.y);
  const real re = sc_zastawny_reynolds(reynolds);
  return sc_zastawny_coefficients(sc_zastawny_shape(law), sine, cosine, re).drag * re * R(1.0 / 24.0);
}

/// The direction of the slip; along z without one.
SC_FN sc_vec sc_direction_of_slip(sc_vec slip) {
  const real speed = sc_norm(slip);
  return speed > R(0) ? sc_scale(R(1) / speed, slip) : sc_make_vec(R(0), R(0), R(1));
}

/// kappa = drag over slip [kg/s].
SC_FN real sc_body_drag(int law, sc_flow_shape s, sc_body_stream b) {
  const real reynolds = sc_body_reynolds(b);
  const real alone = sc_body_drag_factor(law, s, b, sc_direction_of_slip(b.slip), reynolds);
  const real crowding = b.voidage < R(1) ? sc_di_felice_crowding(b.voidage, reynolds) : R(1);
  return sc_stokes_coefficient(b.diameter, b.viscosity) * alone * crowding;
}

/// The part of the force across the slip [N].
///
/// Zastawny's for his shapes. For others from the drags k_i that flows along the axes would have: force sum k_i U_i e_i
/// less its part along U. k_i is that of creeping flow (Oberbeck), for which this is exact, and with a law for finite
/// Reynolds numbers the pressure drag of Hoelzer and Sommerfeld too, whose shadow goes from axis to axis. In a body of
/// revolution it is the law (k_across - k_along) sin cos (Sanjeevi and Padding 2017, J. Fluid Mech. 820, R1). Beside
/// Zastawny's shapes it gives 0.5 to 1 of their lift from Re = 0.1 to 300 (body_drag_test.cpp).
SC_FN sc_vec sc_body_lift(int law, sc_flow_shape s, sc_body_stream b) {
  const real reynolds = sc_body_reynolds(b);
  const sc_vec n = sc_direction_of_slip(b.slip);
  const real crowding = b.voidage < R(1) ? sc_di_felice_crowding(b.voidage, reynolds) : R(1);
  const real unit = sc_stokes_coefficient(b.diameter, b.viscosity) * crowding;
  const int zastawny = sc_zastawny_shape(law);
  if (zastawny != SC_ZASTAWNY_NONE) {
    const real cosine = SC_MIN(SC_FABS(n.z), R(1)), sine = SC_SQRT(n.x * n.x + n.y * n.y),
               re = sc_zastawny_reynolds(reynolds);
    const real factor = sc_zastawny_coefficients(zastawny, sine, cosine, re).lift * re * R(1.0 / 24.0);
    // Away from the axis as it points downstream, across the flow.
    const sc_vec axis = sc_make_vec(R(0), R(0), n.z < R(0) ? R(-1) : R(1));
    const sc_vec across = sc_sub(sc_scale(cosine, n), axis);
    return sc_scale(unit * factor * sc_norm(b.slip) / SC_MAX(sine, R(1e-12)), across);
  }
  const real fast = law == SC_DRAG_STOKES_ELLIPSOID ? R(0) : reynolds * sc_holzer_sommerfeld_pressure(s.sphericity);
  const sc_vec u = b.slip;
  const sc_vec f = sc_make_vec((s.resistance.x + fast * s.shadow.x) * u.x, (s.resistance.y + fast * s.shadow.y) * u.y,
                               (s.resistance.z + fast * s.shadow.z) * u.z);
  return sc_scale(unit, sc_reject(f, n));
}

/// Torque of the slip about the centre [N m], which turns a body broadside to the flow.
///
/// Zastawny's for his shapes. For others that of ideal flow, rho V (k U) x U with the added masses k (Munk 1924, NACA
/// Report 184), times 1.5 Re^-0.2, which is what Zastawny's two shapes have of it at 45 degrees within 20 % from Re =
/// 0.1 to 300 (body_drag_test.cpp); below Re = 0.1 the factor stays.
SC_FN sc_vec sc_body_torque(int law, sc_flow_shape s, sc_body_stream b) {
  const real reynolds = sc_body_reynolds(b);
  const real crowding = b.voidage < R(1) ? sc_di_felice_crowding(b.voidage, reynolds) * b.voidage : R(1);
  const real d = b.diameter, re = sc_zastawny_reynolds(reynolds);
  const int zastawny = sc_zastawny_shape(law);
  if (zastawny != SC_ZASTAWNY_NONE) {
    const sc_vec n = sc_direction_of_slip(b.slip);
    const real cosine = SC_MIN(SC_FABS(n.z), R(1)), sine = SC_SQRT(n.x * n.x + n.y * n.y);
    const real c = sc_zastawny_coefficients(zastawny, sine, cosine, re).torque;
    const real size = R(0.19634954084936207740) * b.density * d * d * d * sc_dot(b.slip, b.slip) * c * crowding;
    // About n x axis, away from the flow.
    const real side = n.z < R(0) ? R(-1) : R(1);
    const sc_vec about = sc_make_vec(side * n.y, -side * n.x, R(0));
    return sc_scale(size / SC_MAX(sine, R(1e-12)), about);
  }
  const sc_vec u = b.slip, k = s.added_mass;
  const sc_vec munk = sc_cross(sc_make_vec(k.x * u.x, k.y * u.y, k.z * u.z), u);
  const real mass = R(0.52359877559829887308) * d * d * d * b.density;
  return sc_scale(R(1.3) * sc_pow(re, R(-0.2)) * mass * crowding, munk);
}

/// Where a law rests on measurements: sphericity, and Re = rho e U d_V/mu of the superficial slip velocity.
typedef struct {
  real least_sphericity, least_reynolds, most_reynolds;
} sc_body_range;

SC_FN sc_body_range sc_make_body_range(real least_sphericity, real least_reynolds, real most_reynolds) {
  sc_body_range out;
  out.least_sphericity = least_sphericity;
  out.least_reynolds = least_reynolds;
  out.most_reynolds = most_reynolds;
  return out;
}

/// The range of a law of drag by shape (docs/fluid_forces.md); outside it the formula goes on.
SC_FN sc_body_range sc_range_of_body_drag(int law) {
  if (law == SC_DRAG_STOKES_ELLIPSOID) return sc_make_body_range(R(0), R(0), R(0.5));
  if (law == SC_DRAG_HAIDER_LEVENSPIEL) return sc_make_body_range(R(0.67), R(0), R(2.6e5));
  if (law == SC_DRAG_GANSER) return sc_make_body_range(R(0), R(0), R(1e5));
  if (law == SC_DRAG_ZASTAWNY_5_2 || law == SC_DRAG_ZASTAWNY_5_4) return sc_make_body_range(R(0), R(0.1), R(300));
  return sc_make_body_range(R(0), R(0), R(1e30));
}

#endif
