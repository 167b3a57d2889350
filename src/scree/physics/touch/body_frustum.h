// A body and a surface of revolution between two circles: cylinder, cone, disc, ring; from inside, from outside, and at
// the rims.
//
// On each generator (the segment between the circles at an angle) the gauge is convex and has one minimum. Over the
// angle there may be several, each a contact of its own: a rod across a pipe touches it at both ends. They are
// bracketed on a regular grid of angles and refined by golden section and parabolas (Brent 1973).
#ifndef SCREE_PHYSICS_TOUCH_BODY_FRUSTUM_H
#define SCREE_PHYSICS_TOUCH_BODY_FRUSTUM_H

#include "scree/physics/touch/body_face.h"
#include "scree/physics/touch/frustum.h"

enum { SC_FRUSTUM_ANGLES = 48, SC_FRUSTUM_GAPS = 4 };

/// A frustum as a body sees it, from the centre of the body.
typedef struct {
  sc_frustum shape;
  sc_vec across, third;  // unit vectors that with the axis make a frame
} sc_frustum_view;

/// The contact on the generator at an angle.
SC_FN sc_body_gap sc_body_generator(sc_body_shape body, sc_frustum_view view, real angle) {
  const sc_vec outward = sc_add_scaled(sc_scale(sc_cos(angle), view.across), sc_sin(angle), view.third);
  const sc_vec start = sc_add_scaled(view.shape.start, view.shape.start_radius, outward);
  const sc_vec middle = sc_add_scaled(view.shape.start, view.shape.length, view.shape.axis);
  sc_body_gap gap = sc_body_segment(body, start, sc_add_scaled(middle, view.shape.end_radius, outward), 1, 2);
  gap.corners = gap.corners == (1 | 2) ? SC_INSIDE_FACE : gap.corners;
  return gap;
}

/// The minimum between the angles low and high, which enclose one at `best`.
SC_FN sc_body_gap sc_body_frustum_refine(sc_body_shape body, sc_frustum_view view, real low, real high) {
  const real golden = R(0.6180339887498949);
  real x1 = high - golden * (high - low), x2 = low + golden * (high - low);
  sc_body_gap g1 = sc_body_generator(body, view, x1), g2 = sc_body_generator(body, view, x2);
  for (int i = 0; i < 60 && high - low > R(1e-9); ++i) {
    if (g1.growth <= g2.growth) {
      high = x2;
      x2 = x1;
      g2 = g1;
      x1 = high - golden * (high - low);
      g1 = sc_body_generator(body, view, x1);
    } else {
      low = x1;
      x1 = x2;
      g1 = g2;
      x2 = low + golden * (high - low);
      g2 = sc_body_generator(body, view, x2);
    }
  }
  return sc_less_growth(g1, g2);
}

/// The places of contact with a frustum whose centres are given from the centre of the body, least growth first;
/// returns how many there are (at most SC_FRUSTUM_GAPS, which `gaps` has room for).
SC_FN int sc_body_frustum(sc_body_shape body, sc_frustum frustum, sc_body_gap* gaps) {
  sc_frustum_view view;
  view.shape = frustum;
  view.across = sc_perpendicular(frustum.axis);
  view.third = sc_cross(frustum.axis, view.across);
  const real step = R(6.283185307179586477) / R(SC_FRUSTUM_ANGLES);
  real growth[SC_FRUSTUM_ANGLES];
  for (int i = 0; i < SC_FRUSTUM_ANGLES; ++i) growth[i] = sc_body_generator(body, view, step * (real)i).growth;
  int count = 0;
  for (int i = 0; i < SC_FRUSTUM_ANGLES; ++i) {
    const real before = growth[i > 0 ? i - 1 : SC_FRUSTUM_ANGLES - 1];
    const real after = growth[i + 1 < SC_FRUSTUM_ANGLES ? i + 1 : 0];
    if (!(growth[i] < before && growth[i] <= after)) continue;
    const sc_body_gap gap = sc_body_frustum_refine(body, view, step * (real)(i - 1), step * (real)(i + 1));
    int place = count < SC_FRUSTUM_GAPS ? count : SC_FRUSTUM_GAPS;
    for (; place > 0 && gap.growth < gaps[place - 1].growth; --place)
      if (place < SC_FRUSTUM_GAPS) gaps[place] = gaps[place - 1];
    if (place < SC_FRUSTUM_GAPS) gaps[place] = gap;
    count = count < SC_FRUSTUM_GAPS ? count + 1 : count;
  }
  if (count == 0) gaps[count++] = sc_body_generator(body, view, R(0));
  return count;
}

#endif
