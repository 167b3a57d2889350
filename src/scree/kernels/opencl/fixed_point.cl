// What particles read of each other in single precision. Places are whole numbers that begin anew after every window of
// the box (fixed_space.h): their differences are exact, nearest images among them. Lengths, masses and times are in the
// units of the run.
#include "scree/kernels/opencl/parameters.h"
#include "scree/physics/touch/sphere_sphere.h"

typedef float4 real4;

/// There are no copies of particles of other ranks.
SC_FN int sc_is_ghost(__global const int* ghost, size_t i) {
  (void)ghost;
  (void)i;
  return 0;
}

/// A place: its number along each axis, the radius in ticks and, as in double precision, in w.
typedef struct {
  uint x, y, z, ticks;
  real w;
} sc_place;

/// What differences of places depend on.
typedef struct {
  uint scale[3];  // a step of the numbers of an axis over a tick, times 2^31
  real tick;      // a power of two
} sc_space;

/// The present state of all particles.
typedef struct {
  __global const uint4* near;   // numbers of places, radius in ticks
  __global const real4* speed;  // vx vy vz inverse_mass
  __global const real4* spin;   // radius * w, inverse_radius
  __global const real* excess;
  __global const int* material;
} sc_state;

SC_FN sc_place sc_place_of(sc_space space, uint4 row) {
  sc_place p;
  p.x = row.x;
  p.y = row.y;
  p.z = row.z;
  p.ticks = row.w;
  p.w = space.tick * (real)row.w;
  return p;
}

SC_FN sc_place sc_place_at(sc_space space, sc_state state, size_t i) { return sc_place_of(space, state.near[i]); }
SC_FN real4 sc_speed_at(sc_state state, size_t i) { return state.speed[i]; }

/// Both sides see a pair: one of them counts it.
SC_FN int sc_counts_pair(sc_state state, size_t i, size_t j) {
  (void)state;
  return j > i;
}

/// The way from one number to another [ticks]. The same backwards but for the sign.
SC_FN int sc_ticks_between(uint from, uint to, uint scale) {
  const int way = (int)(to - from);
  const int ticks = (int)(((ulong)abs(way) * scale + 0x40000000UL) >> 31);
  return way < 0 ? -ticks : ticks;
}

SC_FN sc_vec sc_branch(sc_space space, sc_place a, sc_place b) {
  return sc_make_vec(space.tick * (real)sc_ticks_between(a.x, b.x, space.scale[0]),
                     space.tick * (real)sc_ticks_between(a.y, b.y, space.scale[1]),
                     space.tick * (real)sc_ticks_between(a.z, b.z, space.scale[2]));
}

/// Whether bodies may act on each other that do so within `range`: rounding must not hide any.
SC_FN int sc_is_within(sc_vec branch, real range) { return sc_dot(branch, branch) < R(1.000002) * range * range; }

/// The touch. Its overlap, a small difference of lengths, comes from the exact difference of their squares.
SC_FN sc_sphere_touch sc_refine(sc_space space, sc_place a, sc_place b, sc_sphere_pair p) {
  sc_sphere_touch t = sc_touch_spheres(p);
  const long x = sc_ticks_between(a.x, b.x, space.scale[0]);
  const long y = sc_ticks_between(a.y, b.y, space.scale[1]);
  const long z = sc_ticks_between(a.z, b.z, space.scale[2]);
  const long radii = (long)a.ticks + (long)b.ticks;
  const real squares = (real)(radii * radii - (x * x + y * y + z * z)) * space.tick * space.tick;
  t.touch.overlap = squares / (p.radii + (p.radii - t.touch.overlap));
  t.touch.reach = t.touch.overlap + p.excess;
  return t;
}
