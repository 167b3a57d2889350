// How a body of any shape meets a face of a wall of any kind, wherever the wall is.
#ifndef SCREE_PHYSICS_TOUCH_BODY_WALL_H
#define SCREE_PHYSICS_TOUCH_BODY_WALL_H

#include "scree/physics/touch/body_frustum.h"
#include "scree/physics/touch/shape_contact.h"
#include "scree/physics/touch/sphere_wall.h"

/// A flat face of four corners, or three.
typedef struct {
  sc_vec corner[4];  // [m]
  sc_vec normal;     // unit, to any side
  int corners;
} sc_flat_face;

/// The parallelogram with a corner and two edges, in the order of sc_rectangle_nearest.
SC_FN sc_flat_face sc_flat_face_of(sc_vec corner, sc_vec first, sc_vec second) {
  sc_flat_face f;
  f.corner[0] = corner;
  f.corner[1] = sc_add(corner, first);
  f.corner[2] = sc_add(f.corner[1], second);
  f.corner[3] = sc_add(corner, second);
  f.normal = sc_rectangle_normal(first, second);
  f.corners = 4;
  return f;
}

/// The side of a box across an axis of coordinates (0, 1, 2), at its lower or upper end.
SC_FN sc_flat_face sc_box_side(sc_vec low, sc_vec high, int axis, int upper) {
  const sc_vec size = sc_sub(high, low);
  const sc_vec x = sc_make_vec(size.x, R(0), R(0)), y = sc_make_vec(R(0), size.y, R(0));
  const sc_vec z = sc_make_vec(R(0), R(0), size.z);
  const sc_vec across = axis == 0 ? x : (axis == 1 ? y : z);
  return sc_flat_face_of(upper ? sc_add(low, across) : low, axis == 0 ? y : x, axis == 2 ? y : z);
}

/// Flat faces of a wall that a body sees whose centre is at the origin; returns how many (at most three).
SC_FN int sc_flat_faces(sc_wall wall, sc_vec centre, sc_flat_face* faces) {
  const sc_vec a = sc_sub(wall.a, centre), b = sc_sub(wall.b, centre);
  if (wall.kind == SC_WALL_PLATE) {
    faces[0] = sc_flat_face_of(a, wall.b, wall.c);
    return 1;
  }
  if (wall.kind == SC_WALL_TRIANGLE) {
    faces[0].corner[0] = a;
    faces[0].corner[1] = b;
    faces[0].corner[2] = faces[0].corner[3] = sc_sub(wall.c, centre);
    faces[0].normal = sc_triangle_normal(wall.a, wall.b, wall.c);
    faces[0].corners = 3;
    return 1;
  }
  if (wall.kind == SC_WALL_RECTANGLE) {
    const int axis = wall.a.x == wall.b.x ? 0 : (wall.a.y == wall.b.y ? 1 : 2);
    faces[0] = sc_box_side(a, b, axis, 0);
    return 1;
  }
  int count = 0;
  if ((a.x > R(0)) | (b.x < R(0))) faces[count++] = sc_box_side(a, b, 0, b.x < R(0));
  if ((a.y > R(0)) | (b.y < R(0))) faces[count++] = sc_box_side(a, b, 1, b.y < R(0));
  if ((a.z > R(0)) | (b.z < R(0))) faces[count++] = sc_box_side(a, b, 2, b.z < R(0));
  return count;
}

/// The places of contact of a body and a face where its wall is at home, least growth first; returns how many. `reach`:
/// bounding radius of the body when it has grown as far as matters [m].
SC_FN int sc_body_at_wall(sc_wall wall, sc_body_shape body, sc_vec centre, real reach, sc_body_gap* gaps) {
  if (wall.kind == SC_WALL_FRUSTUM) {
    sc_frustum f;
    f.start = sc_sub(wall.a, centre);
    f.axis = wall.b;
    f.length = wall.length;
    f.start_radius = wall.start_radius;
    f.end_radius = wall.end_radius;
    return sc_body_frustum(body, f, reach, gaps);
  }
  sc_flat_face faces[3];
  const int count = wall.kind == SC_WALL_PLANE ? 0 : sc_flat_faces(wall, centre, faces);
  if (count == 0) {
    // A plane, or a box around the centre.
    const sc_wall_gap gap = wall.kind == SC_WALL_PLANE ? sc_plane_gap(wall, centre) : sc_inside_gap(wall, centre);
    gaps[0] = sc_body_plane(body, gap.normal, gap.distance);
    return 1;
  }
  for (int k = 0; k < count; ++k) {
    const sc_body_gap gap = sc_body_polygon(body, faces[k].corner, faces[k].corners, faces[k].normal);
    gaps[0] = k > 0 ? sc_less_growth(gaps[0], gap) : gap;
  }
  // Of one without numbers nobody asks for the corners.
  if (wall.corner[0] < 0) gaps[0].corners = SC_INSIDE_FACE;
  return 1;
}

/// The same wherever the wall is.
SC_FN int sc_body_to_wall(sc_wall wall, sc_wall_pose pose, sc_body_shape body, sc_vec centre, real reach,
                          sc_body_gap* gaps) {
  sc_body_shape seen = body;
  if (pose.moves) seen.turn = sc_turn_between(pose.turn, body.turn);
  const int count = sc_body_at_wall(wall, seen, sc_from_wall(pose, centre), reach, gaps);
  for (int k = 0; k < count && pose.moves; ++k) {
    gaps[k].normal = sc_turn(pose.turn, gaps[k].normal);
    gaps[k].arm = sc_turn(pose.turn, gaps[k].arm);
  }
  return count;
}

/// What the contact of a shape with a wall remembers besides what the laws do.
typedef struct {
  sc_vec anchor;  // where it was on the wall, where that is at home [m]
  real reach;     // l: support of the body at the first touch, or where the contact last was on a flat face [m]
  real radius;    // effective radius R* at the first touch [m]
} sc_wall_memory;

/// What a contact that begins will remember; `by_volume`: radius by volume [m].
SC_FN sc_wall_memory sc_wall_met(sc_body_shape body, sc_body_gap gap, real by_volume) {
  const sc_contact_radius radius = sc_contact_radius_of_wall(body, gap.normal, SC_LEAST_CURVATURE_RADIUS * by_volume,
                                                             SC_LARGEST_CURVATURE_RADIUS * by_volume);
  sc_wall_memory m;
  m.anchor = sc_zero_vec();
  m.reach = gap.support;
  m.radius = radius.radius * radius.factor * radius.factor;
  return m;
}

/// l/h, by which the potential goes with the overlap.
SC_FN real sc_wall_ratio(sc_body_gap gap, sc_wall_memory m) { return gap.plain ? R(1) : m.reach / gap.support; }

/// The place of the contact.
SC_FN sc_contact_place sc_place_at_wall(sc_body_gap gap, sc_wall_memory m) {
  sc_contact_place p;
  p.normal = gap.normal;
  p.overlap = gap.overlap;
  p.arm_a = gap.arm;
  p.arm_b = sc_zero_vec();
  p.radius = m.radius;
  return p;
}

#endif
