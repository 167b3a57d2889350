// A contact of a body with a wall from what the search has found to what the laws read.
#ifndef SCREE_KERNELS_MEET_WALL_H
#define SCREE_KERNELS_MEET_WALL_H

#include "scree/physics/touch/body_wall.h"

/// A contact ready for the laws.
typedef struct {
  sc_contact_place place;
  sc_vec at, arm;  // the contact, and it from the pivot of the wall [m]
  sc_touch touch;
  sc_pair_law law;
} sc_wall_meeting;

/// The wall as partner B of a contact, `arm` from its pivot.
SC_FN sc_body_side sc_side_of_wall(sc_wall_pose pose, sc_vec arm, sc_vec normal) {
  sc_body_side s;
  s.velocity = pose.moves ? sc_wall_speed(pose, pose.velocity, pose.spin, arm, normal) : sc_zero_vec();
  s.spin = pose.moves ? pose.spin : sc_zero_vec();
  s.inverse_mass = R(0);
  s.inverse_moments = sc_zero_vec();
  s.turn = sc_unit_mat();
  return s;
}

/// A body at a wall.
typedef struct {
  sc_body_shape shape;
  sc_body_side side;
  sc_vec centre;  // [m]
  real excess;    // of its effect surface [m]
} sc_body_at_walls;

/// How a body meets a wall at a place where they are so near, with what the contact remembers.
SC_FN sc_wall_meeting sc_meet_wall(sc_body_at_walls body, sc_wall_pose pose, sc_body_gap gap, sc_wall_memory memory,
                                   sc_pair_law law) {
  sc_wall_meeting m;
  const real ratio = sc_wall_ratio(gap, memory);
  m.place = sc_place_at_wall(gap, memory);
  m.at = sc_add(body.centre, m.place.arm_a);
  m.arm = sc_sub(m.at, pose.place);
  const sc_body_side wall = sc_side_of_wall(pose, m.arm, m.place.normal);
  m.touch = sc_touch_at(m.place, body.side, wall, body.excess / ratio);
  m.law = sc_law_of_growth(law, ratio);
  return m;
}

/// What a contact goes by that remembers `before`, if it `acted`, or else begins. On a flat face the overlap is a
/// potential wherever the body is.
SC_FN sc_wall_memory sc_wall_remembers(int acted, sc_wall_memory before, sc_body_shape body, sc_body_gap gap,
                                       real by_volume) {
  sc_wall_memory m = before;
  if (!acted) m = sc_wall_met(body, gap, by_volume);
  if (gap.plain) m.reach = gap.support;
  return m;
}

/// Where the scaled body touches the face, from the centre: that of a plane is not its contact point, which lies below
/// the farthest point of the body as it is.
SC_FN sc_vec sc_touching_point(sc_body_gap gap) {
  return gap.plain ? sc_scale(gap.growth, sc_add_scaled(gap.arm, gap.overlap, gap.normal)) : gap.arm;
}

#endif
