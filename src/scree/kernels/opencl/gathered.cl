// What a particle on a device reads, gathers from its contacts, and finds; and what a contact remembers.
#include "scree/kernels/opencl/parameters.h"
#include "scree/physics/contact/law.h"

// SC_GROUP, the items of a group, SC_SHAPED, whether some particles are no spheres, and the chosen laws are given by the host.
#define SC_CHOSEN_LAWS \
  { SC_CHOSEN_NORMAL, SC_CHOSEN_TANGENTIAL, SC_CHOSEN_ROLLING, SC_CHOSEN_TWISTING, SC_CHOSEN_COHESION }
#define SC_ROLLS (SC_CHOSEN_ROLLING != SC_ROLLING_NONE || SC_CHOSEN_TWISTING != SC_TWISTING_NONE)

/// What a particle has gathered.
typedef struct {
  sc_vec force, turn, couple;
  real loss_normal, loss_sliding, loss_rolling;
  int near;  // some wall was near enough to be looked at
} sc_gathered;

/// What a particle has found.
typedef struct {
  real fastest_square, deepest;
  int contacts, wall_contacts, impacts, unsound, outside, stale;
  sc_count impact_speed;
} sc_found;

/// A particle as it was read.
typedef struct {
  sc_place place;    // x y z radius
  real4 speed, rim;  // rows of Particles: vx vy vz inverse_mass | radius * w, inverse_radius
  real excess;
  int material;
} sc_row;

SC_FN sc_vec sc_first(real4 a) { return sc_make_vec(a.x, a.y, a.z); }

SC_FN sc_found sc_nothing_found(void) {
  sc_found f;
  f.fastest_square = f.deepest = R(0);
  f.contacts = f.wall_contacts = f.impacts = f.unsound = f.outside = f.stale = 0;
  f.impact_speed = 0;
  return f;
}

SC_FN sc_gathered sc_nothing_gathered(void) {
  sc_gathered g;
  g.force = g.turn = g.couple = sc_zero_vec();
  g.loss_normal = g.loss_sliding = g.loss_rolling = R(0);
  g.near = 0;
  return g;
}

SC_FN uint sc_contact_code(int acts, real slid) { return acts ? (slid > R(0) ? 3u : 1u) : 0u; }

SC_FN sc_contact_state sc_state_from(uint code, real4 slide, real4 roll) {
  sc_contact_state s;
  s.slide = sc_first(slide);
  s.approach = slide.w;
  s.acted = code & 1u ? R(1) : R(0);
  s.slid = code & 2u ? R(1) : R(0);
  s.roll = sc_first(roll);
  s.twist = roll.w;
  return s;
}

SC_FN real4 sc_slide_row(sc_contact_state s) { return (real4)(s.slide.x, s.slide.y, s.slide.z, s.approach); }
SC_FN real4 sc_roll_row(sc_contact_state s) { return (real4)(s.roll.x, s.roll.y, s.roll.z, s.twist); }

/// Adds what a contact did to its first partner; `share` of the losses is his.
SC_FN sc_gathered sc_gather(sc_gathered g, sc_sphere_touch t, sc_contact_action a, real share) {
  g.force = sc_add(g.force, sc_add(a.normal_force, a.tangential_force));
  g.turn = sc_add(g.turn, sc_scale(t.lever, sc_cross(t.touch.normal, a.tangential_force)));
  g.couple = sc_add(g.couple, a.couple);
  g.loss_normal += share * a.loss_normal;
  g.loss_sliding += share * a.loss_sliding;
  g.loss_rolling += share * a.loss_rolling;
  return g;
}

/// What the contact of a body with a wall remembers besides, from one slot to another: where it was, and radius and distance; the
/// arm is that of the new slot.
SC_FN void sc_copy_shape_memory(__global real4* shapes, size_t from, size_t to) {
  shapes[2 * to] = shapes[2 * from];
  shapes[2 * to + 1].w = shapes[2 * from + 1].w;
}
