// A spring with a memory, a dashpot beside it and a slider that limits both: the element of static friction, rolling
// and twisting resistance (Cundall and Strack 1979).
#ifndef SCREE_PHYSICS_CONTACT_SPRING_H
#define SCREE_PHYSICS_CONTACT_SPRING_H

#include "scree/physics/contact/contact.h"

/// A spring element before a step. "Force" and "mass" mean couple and moment of inertia where angles are stretched.
typedef struct {
  sc_vec stretch;   // at the last evaluation, turned with the contact
  real hold;        // stiffness at the last evaluation over the present one
  sc_vec velocity;  // at the time `lead` before the positions
  real span;        // time in contact since the last evaluation [s]
  real stiffness;
  real damping;   // coefficient of the dashpot, as its force counts in this kick
  real drained;   // the coefficient itself times the span: what the dashpot takes, over the velocity squared
  int passive;    // a changing stiffness must not gain energy
  real mass;      // which the element accelerates
  real sticking;  // the largest force that it holds
  real sliding;   // the force at which it slides
} sc_spring;

/// What the element does during a step.
typedef struct {
  sc_vec force;
  sc_vec stretch;  // at the end of the step
  real loss;       // energy taken out [J]
  int slides;
} sc_spring_action;

/// The force of the element, its new stretch and the energy that it turned into heat.
///
/// The dashpot uses the velocity at the time of the positions, predicted with the element's own force:
/// v' = v - lead (k x + c v')/m makes the pull k x + c v' = (k x + c v) m/(m + c lead). Beyond the limit force and
/// stretch shrink by the same factor, so a sliding spring never gains energy, however strong the dashpot.
///
/// Where the stiffness grows, the force stays and the stretch shrinks; where it falls, the stretch stays and the force
/// shrinks: no cycle gains energy (Elata and Berryman 1996).
///
/// The spring's part of the loss is (force before + force after)/2 times the motion, less the gain of stored energy;
/// summed over a contact it is exactly what the kicks of the leapfrog take out. A spring that passes zero within a step
/// could seem to gain a little: that counts as nothing. The dashpot's part goes with the velocity in the middle between
/// the two evaluations, which is known whatever else acts on the bodies; once the spring slides, with the dashpot's own
/// share of the limited force. All works follow from three products: stretch and velocity span everything here.
SC_FN sc_spring_action sc_pull_spring(sc_spring s, sc_contact_time time) {
  sc_spring_action out;
  const real loading = s.passive ? SC_MIN(s.hold, R(1)) : R(1);
  const real way = R(0.5) * (R(1) + loading) * s.span;
  const sc_vec trial = sc_add_scaled(sc_scale(loading, s.stretch), way, s.velocity);
  const real inverse = R(1) / (s.mass + s.damping * time.lead);
  const real left = s.mass * inverse;
  const sc_vec pull = sc_add_scaled(sc_scale(left * s.stiffness, trial), left * s.damping, s.velocity);
  const real size = SC_SQRT(sc_dot(pull, pull));
  out.slides = size > s.sticking;
  const real share = out.slides ? s.sliding / size : R(1);
  const real kept = s.sticking > R(0) ? share : R(0);  // what cannot hold does not stretch
  out.force = sc_scale(-share, pull);
  out.stretch = sc_scale(kept, trial);
  const real stretch2 = sc_dot(s.stretch, s.stretch);
  const real along = sc_dot(s.stretch, s.velocity);
  const real speed2 = sc_dot(s.velocity, s.velocity);
  const real trial_along = loading * along + way * speed2;
  const real trial2 = loading * (loading * stretch2 + way * along) + way * trial_along;
  const real work = s.span * (kept * trial_along + s.hold * along);  // before and after, over half the stiffness
  const real gain = kept * kept * trial2 - s.hold * stretch2;
  const real middle = out.slides ? inverse * (s.mass * speed2 - time.lead * s.stiffness * trial_along) : speed2;
  const real loss = R(0.5) * s.stiffness * (work - gain) + share * s.drained * middle;
  out.loss = s.passive ? SC_MAX(loss, R(0)) : loss;
  return out;
}

#endif
