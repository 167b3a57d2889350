// What particles read of each other in double precision: the rows of Particles, as the host has them.
#include "scree/kernels/opencl/parameters.h"
#include "scree/physics/touch/sphere_sphere.h"

typedef double4 real4;

/// SC_SEVERAL_RANKS: some of the particles are copies of those of other ranks, which move them.
SC_FN int sc_is_ghost(__global const int* ghost, size_t i) {
#if SC_SEVERAL_RANKS
  return ghost[i] != 0;
#else
  (void)ghost;
  (void)i;
  return 0;
#endif
}

/// A place, and the radius in w.
typedef real4 sc_place;

/// What differences of places depend on.
typedef sc_box sc_space;

/// The present state of all particles.
typedef struct {
  __global const real4* motion;  // x y z radius, vx vy vz inverse_mass
  __global const real4* spin;    // radius * w, inverse_radius
  __global const real* excess;
  __global const int* material;
  __global const int* ghost;
  __global const long* id;
} sc_state;

SC_FN sc_place sc_place_at(sc_space space, sc_state state, size_t i) {
  (void)space;
  return state.motion[2 * i];
}
SC_FN real4 sc_speed_at(sc_state state, size_t i) { return state.motion[2 * i + 1]; }

/// Both sides see a pair: one of them counts it, of two ranks that of the lower id.
SC_FN int sc_counts_pair(sc_state state, size_t i, size_t j) {
  return !(sc_is_ghost(state.ghost, j) ? state.id[j] < state.id[i] : j < i);
}

SC_FN sc_vec sc_branch(sc_space box, sc_place a, sc_place b) {
  return sc_to_nearest_image(box, sc_make_vec(b.x - a.x, b.y - a.y, b.z - a.z));
}

/// Whether bodies may act on each other that do so within `range` [m] or [length].
SC_FN int sc_is_within(sc_vec branch, real range) { return sc_dot(branch, branch) < range * range; }

/// The touch, with its overlap as well as it can be known: as it is.
SC_FN sc_sphere_touch sc_refine(sc_space space, sc_place a, sc_place b, sc_sphere_pair p) {
  (void)space;
  (void)a;
  (void)b;
  return sc_touch_spheres(p);
}
