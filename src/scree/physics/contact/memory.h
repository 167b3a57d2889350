// What a contact remembers, brought to the present: how long it lasts, and its spring turned with it.
#ifndef SCREE_PHYSICS_CONTACT_MEMORY_H
#define SCREE_PHYSICS_CONTACT_MEMORY_H

#include "scree/physics/contact/contact.h"

/// A contact's memory at the present evaluation.
typedef struct {
  int begins;     // the bodies met since the last evaluation
  real approach;  // normal velocity [m/s]
  real span;      // time in contact since the last evaluation [s]
  real weight;    // of forces that jump when the bodies meet [-]
  sc_vec slide;   // tangential spring, turned with the contact [m]
  real hold;      // stiffness of the springs at the last evaluation over the present one [-]
} sc_contact_memory;

/// Brings the memory of a contact to the present.
///
/// A kick carries the force of one evaluation over the time around it. The first one after the bodies met, a time
/// `span` ago, stands for all from the meeting to its end: a force that jumps at the meeting (a dashpot) counts (span +
/// kick - lead)/kick times, which makes its impulse second order in dt.
///
/// The spring loses its part along the normal and regains its old length. `growing` says that the tangential stiffness
/// goes with the square root of `depth`, an overlap. Both need a square root of a ratio q near 1; (1 + 3 q)/(3 + q) is
/// wrong by (q - 1)^3/32 only (3e-14 for a turn of 0.01 rad) and lets both and the span share one division. Of the
/// spring's squared length before the turn, `lost` is what goes: q = before/(before - lost). At the
/// first touch the stiffness grows from 0 (`hold` 1/3 makes its mean 2/3 of it), but from a part of it with adhesion.
/// `bonded`: the contact cannot begin now.
SC_FN sc_contact_memory sc_remember(sc_touch t, sc_contact_time time, sc_contact_state s, int growing, real depth,
                                    int bonded) {
  sc_contact_memory out;
  out.approach = sc_dot(t.velocity, t.normal);
  const real advance = out.approach * time.dt;
  // A contact counts from a little above zero overlap, so that rounding does not decide for bodies that start just
  // touching. One comparison stands for both, because loops with mixed flags do not vectorise.
  const real least = R(1e-9) * SC_MAX(out.approach, R(0)) * time.kick;
  out.begins = (bonded ? R(0) : SC_MIN(t.overlap - least, advance + least - t.overlap)) > R(0);
  const real along = sc_dot(s.slide, t.normal);
  const sc_vec turned = sc_add_scaled(s.slide, -along, t.normal);
  const real lost = along * along;
  const real four = R(4) * sc_dot(s.slide, s.slide);
  const real length = four > SC_TINY ? four - R(3) * lost : R(1);
  const real closing = SC_MIN(advance, depth);
  const real growth = growing ? R(4) * depth - closing : R(1);
  const real both = length * growth;
  const real divisor = out.begins ? out.approach * time.kick : both;
  const real inverse = R(1) / divisor;
  const int kept = (out.begins ? R(0) : both) > SC_TINY;
  out.span = out.begins ? t.overlap * inverse * time.kick : time.dt;
  out.weight = out.begins ? (t.overlap + out.approach * (time.kick - time.lead)) * inverse
                          : ((bonded ? R(1) : t.overlap - least) > R(0) ? R(1) : R(0));
  out.slide = sc_scale(kept ? (four - lost) * growth * inverse : R(0), turned);
  const real fresh = t.overlap < depth ? R(1) : R(1.0 / 3.0);
  const real held = kept ? (R(4) * depth - R(3) * closing) * length * inverse : (out.begins ? fresh : R(1));
  out.hold = growing ? held : R(1);
  return out;
}

#endif
