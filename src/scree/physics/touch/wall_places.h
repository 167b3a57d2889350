// Several places of contact of one body with one face of a wall: which of them is which from step to step.
#ifndef SCREE_PHYSICS_TOUCH_WALL_PLACES_H
#define SCREE_PHYSICS_TOUCH_WALL_PLACES_H

#include "scree/physics/touch/wall.h"

enum { SC_FRUSTUM_GAPS = 4 };

/// How many places of contact a face may have.
SC_FN int sc_wall_places(int kind) { return kind == SC_WALL_FRUSTUM ? SC_FRUSTUM_GAPS : 1; }

/// Gives each of the memories of a face, which were at the places `was`, the number of the place that it is at now in
/// `to`: again and again to the two that are nearest to each other, so that the order does not matter. `at`: where the
/// `count` contacts are now. Memories left over get the numbers after those, as far as there are any; the rest get -1.
SC_FN void sc_match_places(const sc_vec* at, int count, const sc_vec* was, int memories, int* to) {
  int taken[SC_FRUSTUM_GAPS];
  for (int g = 0; g < SC_FRUSTUM_GAPS; ++g) taken[g] = 0;
  for (int m = 0; m < memories; ++m) to[m] = -1;
  for (int matched = 0; matched < SC_MIN(count, memories); ++matched) {
    int gap = -1, memory = -1;
    real least = R(0);
    for (int g = 0; g < count; ++g)
      for (int m = 0; m < memories; ++m) {
        if (taken[g] || to[m] >= 0) continue;
        const sc_vec apart = sc_sub(at[g], was[m]);
        const real square = sc_dot(apart, apart);
        if (gap >= 0 && square >= least) continue;
        least = square;
        gap = g;
        memory = m;
      }
    to[memory] = gap;
    taken[gap] = 1;
  }
  int next = count;
  for (int m = 0; m < memories; ++m)
    if (to[m] < 0 && next < SC_FRUSTUM_GAPS) to[m] = next++;
}

#endif
