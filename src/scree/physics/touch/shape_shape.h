// Two bodies in the world, and how they meet there.
#ifndef SCREE_PHYSICS_TOUCH_SHAPE_SHAPE_H
#define SCREE_PHYSICS_TOUCH_SHAPE_SHAPE_H

#include "scree/physics/touch/certified.h"

/// A body as the narrow phase sees it.
typedef struct {
  sc_form form;
  real radius;  // bounding radius [m]
  sc_mat turn;  // from its frame to the world
} sc_body_shape;

/// How two bodies meet, in the world.
typedef struct {
  int verdict;            // SC_GROWTH_...
  sc_vec normal;          // unit, from the first to the second
  real overlap;           // along the normal [m]
  real support;           // distance of the centres along the normal where they just touch [m]
  sc_vec arm;             // contact point from the centre of the first [m]
  sc_vec arm_second;      // the same from that of the second, arm - branch
  real low, high;         // bracket of the growth distance
  sc_growth_point start;  // for the next solve: in the frame of the body that the solver takes as A
} sc_shape_touch;

/// Whether the solver takes the second body as its A: that is the one that is no sphere, else the one that is not
/// smaller, of equal ones the first.
SC_FN int sc_shapes_reversed(sc_body_shape first, sc_body_shape second) {
  return sc_one_is_sphere(first.form, second.form) ? first.form.is_sphere : second.radius > first.radius;
}

/// The pair as the solver wants it. `first` is the body with the lower id, so that exchanging the bodies changes no
/// bits; `branch` goes from its centre to that of the second [m].
SC_FN sc_growth_pair sc_pair_of_shapes(sc_body_shape first, sc_body_shape second, sc_vec branch) {
  const int reversed = sc_shapes_reversed(first, second);
  const sc_body_shape a = reversed ? second : first;
  const sc_body_shape b = reversed ? first : second;
  const sc_vec d = reversed ? sc_scale(R(-1), branch) : branch;
  return sc_make_growth_pair(a.form, a.radius, b.form, b.radius, sc_turn_between(a.turn, b.turn),
                             sc_turn_back(a.turn, d));
}

/// The same seen from the other body, unless `as_it_is`.
SC_FN sc_shape_touch sc_shape_touch_from(sc_shape_touch touch, int as_it_is) {
  sc_shape_touch out = touch;
  if (as_it_is) return out;
  out.normal = sc_scale(R(-1), touch.normal);
  out.arm = touch.arm_second;
  out.arm_second = touch.arm;
  return out;
}

/// What the solver found, in the world, seen from its A: `turn` is A's, `branch` goes from A to B [m].
SC_FN sc_shape_touch sc_touch_in_world(sc_mat turn, sc_vec branch, sc_growth_touch found) {
  sc_shape_touch out;
  out.verdict = found.verdict;
  out.normal = sc_turn(turn, found.normal);
  out.arm = sc_turn(turn, found.point);
  out.arm_second = sc_sub(out.arm, branch);
  out.support = found.support;
  out.overlap = (R(1) - found.growth) * found.support;
  out.low = found.low;
  out.high = found.high;
  out.start = found.start;
  return out;
}

/// What the solver found, in the world.
SC_FN sc_shape_touch sc_shape_touch_of(sc_body_shape first, sc_body_shape second, sc_vec branch,
                                       sc_growth_touch found) {
  const int reversed = sc_shapes_reversed(first, second);
  const sc_mat turn = reversed ? second.turn : first.turn;
  const sc_vec d = reversed ? sc_scale(R(-1), branch) : branch;
  return sc_shape_touch_from(sc_touch_in_world(turn, d, found), !reversed);
}

/// How two bodies meet, where it matters up to a growth distance of `limit`; `warm` says that `start` is where the last
/// solve ended.
SC_FN sc_shape_touch sc_touch_shapes_within(sc_body_shape first, sc_body_shape second, sc_vec branch, real limit,
                                            int warm, sc_growth_point start) {
  sc_growth_pair pair = sc_pair_of_shapes(first, second, branch);
  pair.limit = limit;
  return sc_shape_touch_of(first, second, branch, sc_growth_solve(pair, warm, start));
}

/// How two bodies meet, where it matters whether they overlap.
SC_FN sc_shape_touch sc_touch_shapes(sc_body_shape first, sc_body_shape second, sc_vec branch, int warm,
                                     sc_growth_point start) {
  return sc_touch_shapes_within(first, second, branch, R(1), warm, start);
}

#endif
