// When two particles that meet stay together: numbers for the check before a run and for the series.
#pragma once

#include "scree/physics/contact/contact.h"

namespace scree {

/// A head-on impact of two bodies under the linear laws with linear cohesion.
struct CohesiveImpact {
  double mass = 0;         // reduced mass m [kg]
  double stiffness = 0;    // k_e [N/m]
  double damping = 0;      // damping ratio of the normal law [-]
  double restitution = 1;  // e of a collision without cohesion
  double cohesion = 0;     // k_c [N/m]
  double reach = 0;        // L: how far apart the bodies are when cohesion begins [m]
  bool tension = false;    // spring and dashpot together may pull (the plain law)
};

/// Speed at which the bodies touch when they come with `speed` from out of reach [m/s]: cohesion adds k_c L^2 / 2 of
/// energy (report, appendix A.2.1 with the sign of u_i corrected).
double touching_speed(const CohesiveImpact& impact, double speed);

/// Speed at which the bodies part again when they touched at `touching` [m/s], from the equation of motion
/// m y'' = -(k_e - k_c) y - eta y' + k_c L of the overlap y; -1 if they never part.
double parting_speed(const CohesiveImpact& impact, double touching);

/// The approach speed below which the bodies stay together [m/s]: exact for this law. Infinite if cohesion is as stiff
/// as the bodies.
double sticking_speed(const CohesiveImpact& impact);

/// Stickiness number L sqrt(k_c) / (e sqrt(L^2 k_c + m u^2)) (report, equation 6.5, with the reduced mass); above 1 the
/// bodies stay together, by an estimate that treats the body contact as if it felt no cohesion.
double stickiness_number(const CohesiveImpact& impact, double speed);

/// Force that separates two adhesive bodies, 3/2 pi W R* [N] (Johnson, Kendall and Roberts 1971).
double pull_off_force(double adhesion, double radius);

/// Speed below which elastic bodies with adhesion stick, sqrt(14.18 / m) (W^5 R*^4 / E*^2)^(1/6) [m/s] (Thornton and
/// Ning 1998); m is the reduced mass.
double elastic_sticking_speed(double adhesion, double radius, double young, double mass);

/// Speed below which bodies with adhesion stick, their dashpot included [m/s]: exact for this law, from the equation of
/// motion. The dashpot takes its part on the way in and on the way out, while the neck pulls.
double adhesive_sticking_speed(const sc_pair_law& law, double radius, double mass);

}  // namespace scree
