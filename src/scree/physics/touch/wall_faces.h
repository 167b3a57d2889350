// Which of the faces of a wall a body touches where they meet: at an edge the nearest of them, and at one place one.
#ifndef SCREE_PHYSICS_TOUCH_WALL_FACES_H
#define SCREE_PHYSICS_TOUCH_WALL_FACES_H

#include "scree/physics/touch/wall.h"

/// Bit of sc_wall_gap::corners that marks a face which does not count.
enum { SC_FACE_DROPPED = 16 };

/// Whether a nearest point on the edge or the corner `corners` of a face, `away` from the body, gives way to another
/// face that is `other_away` and has that edge or corner too. Faces as near up to rounding do not give way.
SC_FN int sc_gives_way(int corners, real away, real other_away) {
  return corners != SC_INSIDE_FACE && other_away < R(1 - 1e-12) * away;
}

/// Whether closest points of two faces, `apart` [m], are one place of contact for a body of this radius [m].
SC_FN int sc_is_one_place(sc_vec apart, real radius) {
  return sc_dot(apart, apart) < R(1e-5) * R(1e-5) * radius * radius;
}

#endif
