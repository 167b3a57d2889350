// A contact of two shapes from what the search for the growth distance has found to what it does to both.
#ifndef SCREE_KERNELS_MEET_SHAPES_H
#define SCREE_KERNELS_MEET_SHAPES_H

#include "scree/kernels/pair_loads.h"
#include "scree/physics/touch/shape_contact.h"

/// A contact ready for the laws.
typedef struct {
  sc_contact_place place;
  sc_pair_law law;
  real excess;             // of the effect surfaces, as the law takes it [m]
  int in_reach;            // it may act
  sc_shape_memory memory;  // if it goes on
} sc_shape_meeting;

/// How far two bodies are apart at least [m], by the direction that the search has found; 0 where they overlap.
SC_FN real sc_gap_as_found(sc_body_shape first, sc_body_shape second, sc_vec branch, sc_shape_touch found) {
  const int overlap = (found.verdict == SC_GROWTH_TOUCHING) & (found.overlap > R(0));
  return overlap ? R(0) : sc_shapes_gap(first, second, branch, found.normal);
}

/// How two bodies meet as it was found, with what they remember (sc_shapes_meet, of those that touch for the first
/// time), and the law and the excess of the effect surfaces of both.
SC_FN sc_shape_meeting sc_meet_as_found(sc_shape_touch found, sc_shape_memory memory, sc_pair_law law, real excess) {
  sc_shape_meeting m;
  const real ratio = sc_growth_ratio(memory.reach, found);
  m.in_reach = found.verdict == SC_GROWTH_TOUCHING;
  m.memory = memory;
  m.memory.start = found.start;
  m.place = sc_place_of_shapes(found, memory.radius);
  m.law = sc_law_of_growth(law, ratio);
  m.excess = excess / ratio;
  return m;
}

/// Two spheres among shapes: they have nothing to search for, and nothing to remember of it.
SC_FN sc_shape_meeting sc_meet_as_spheres(sc_vec branch, real radius_a, real radius_b, sc_pair_law law, real excess) {
  sc_shape_meeting m;
  m.in_reach = 1;
  m.memory.start.point = sc_zero_vec();
  m.memory.start.share = m.memory.reach = m.memory.radius = R(0);
  m.place = sc_place_of_spheres(branch, radius_a, radius_b);
  m.law = law;
  m.excess = excess;
  return m;
}

#endif
