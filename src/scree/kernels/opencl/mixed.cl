// Particles in mixed precision: positions are whole numbers (fixed_space.h), contacts between particles are in single precision
// (the texts of partners.cl, pair_contacts.cl and of the laws, whose names begin with sf_ there), and all else is in double:
// where bodies that are no spheres touch, walls, fields, motion, books. Velocities have two numbers each: what partners read, and
// the rest, which is below its last digit.
#include "scree/kernels/opencl/fixed_space.h"

/// What only a particle itself reads and writes: three numbers each.
typedef struct {
  __global uint* places;   // of the numbers of places what others do not read
  __global float* speeds;  // of velocities what has no place in the first number
  __global float* spins;
} sc_rests;

SC_FN ulong sc_number_of(uint near, uint rest, int turn) {
  return rotate((ulong)near << 32 | rest, (ulong)(64 - turn));
}

/// The number of a coordinate.
SC_FN ulong sc_number_at(real x, real low, real span) {
  const real share = (x - low) / span;  // 2^64 of them make 1
  return share > R(0) ? convert_ulong_sat(share * R(18446744073709551616.0)) : 0;
}

/// A radius as others read it.
SC_FN uint sc_ticks_of(sc_fixed_space s, real radius) { return convert_uint_sat_rte(radius / s.tick); }

/// The coordinate of a number, below `high`.
SC_FN real sc_coordinate(sc_fixed_space s, int axis, ulong number) {
  const real x = s.low[axis] + s.span[axis] * (R(5.421010862427522e-20) * (real)number);
  const real high = s.low[axis] + s.span[axis];
  return x < high ? x : nextafter(high, s.low[axis]);
}

/// The place of particle i, with its radius.
SC_FN real4 sc_place_of_numbers(sc_fixed_space s, uint4 near, sc_rests rests, size_t i) {
  const uint3 rest = vload3(i, rests.places);
  return (real4)(sc_coordinate(s, 0, sc_number_of(near.x, rest.x, s.turn[0])),
                 sc_coordinate(s, 1, sc_number_of(near.y, rest.y, s.turn[1])),
                 sc_coordinate(s, 2, sc_number_of(near.z, rest.z, s.turn[2])), s.tick * (real)near.w);
}

SC_FN sf_space sc_space_of(sc_fixed_space s) {
  sf_space out;
  for (int k = 0; k < 3; ++k) out.scale[k] = s.scale[k];
  out.tick = (float)(s.tick / s.length);
  return out;
}

SC_FN sc_vec sc_widen(float4 a, float3 rest, real unit) {
  return sc_make_vec(unit * ((real)a.x + (real)rest.x), unit * ((real)a.y + (real)rest.y), unit * ((real)a.z + (real)rest.z));
}

SC_FN float4 sc_narrow(sc_vec v, real unit, float w) {
  return (float4)((float)(v.x / unit), (float)(v.y / unit), (float)(v.z / unit), w);
}

/// What narrowing has left out.
SC_FN float3 sc_rest_of(sc_vec v, real unit, float4 kept) {
  return (float3)((float)(v.x / unit - (real)kept.x), (float)(v.y / unit - (real)kept.y), (float)(v.z / unit - (real)kept.z));
}

SC_FN sc_vec sc_wide_vec(sf_vec v, real unit) { return sc_make_vec(unit * (real)v.x, unit * (real)v.y, unit * (real)v.z); }

/// The same particle in double precision and SI units.
SC_FN sc_row sc_widen_row(sc_fixed_space s, sf_row own, real4 place, sc_rests rests, size_t i) {
  const real speed = s.length / s.time;
  const sc_vec velocity = sc_widen(own.speed, vload3(i, rests.speeds), speed);
  const sc_vec rim = sc_widen(own.rim, vload3(i, rests.spins), speed);
  sc_row r;
  r.place = place;
  r.speed = (real4)(velocity.x, velocity.y, velocity.z, (real)own.speed.w / s.mass);
  r.rim = (real4)(rim.x, rim.y, rim.z, (real)own.rim.w / s.length);
  r.excess = s.length * (real)own.excess;
  r.material = own.material;
  return r;
}

SC_FN sc_gathered sc_widen_gathered(sc_fixed_space s, sf_gathered g) {
  const real force = s.mass * s.length / (s.time * s.time), energy = force * s.length;
  sc_gathered out = sc_nothing_gathered();
  out.force = sc_wide_vec(g.force, force);
  out.turn = sc_wide_vec(g.turn, force);
  out.couple = sc_wide_vec(g.couple, energy);
  out.loss_normal = energy * (real)g.loss_normal;
  out.loss_sliding = energy * (real)g.loss_sliding;
  out.loss_rolling = energy * (real)g.loss_rolling;
  return out;
}

SC_FN sc_found sc_widen_found(sf_found f) {
  sc_found out = sc_nothing_found();
  out.deepest = (real)f.deepest;
  out.contacts = f.contacts;
  out.impacts = f.impacts;
  out.impact_speed = f.impact_speed;
  return out;
}

SC_FN sf_contact_time sc_narrow_time(sc_contact_time t, real unit) {
  sf_contact_time out;
  out.dt = (float)(t.dt / unit);
  out.lead = (float)(t.lead / unit);
  out.kick = (float)(t.kick / unit);
  return out;
}

/// A number that has gone on, and how many periods it has wrapped.
typedef struct {
  ulong number;
  int wrapped, outside;
} sc_gone;

/// Adds `way` [m] to the number of a coordinate: to its last digit, however slow the motion.
SC_FN sc_gone sc_go_on(sc_fixed_space s, int axis, ulong number, real way) {
  const real share = way / s.span[axis];
  sc_gone g;
  g.outside = !(fabs(share) < R(0.25));
  const long step = g.outside ? 0 : convert_long_rte(share * R(18446744073709551616.0));
  g.number = number + (ulong)step;
  g.wrapped = step > 0 && g.number < number ? 1 : step < 0 && g.number > number ? -1 : 0;
  if (s.periodic[axis]) return g;
  // The box is the middle half where it does not wrap.
  const int below = g.number < (1UL << 62), above = g.number >= (3UL << 62);
  g.outside |= (below && !(s.open & (1 << axis))) || (above && !(s.open & (8 << axis))) || g.wrapped != 0;
  return g;
}

/// Keeps the numbers of the place of particle i.
SC_FN void sc_keep_place_numbers(sc_fixed_space s, size_t i, ulong x, ulong y, ulong z, uint ticks, __global uint4* near,
                                 __global uint* rest_places) {
  const ulong u = rotate(x, (ulong)s.turn[0]), v = rotate(y, (ulong)s.turn[1]), w = rotate(z, (ulong)s.turn[2]);
  near[i] = (uint4)((uint)(u >> 32), (uint)(v >> 32), (uint)(w >> 32), ticks);
  vstore3((uint3)((uint)u, (uint)v, (uint)w), i, rest_places);
}

/// Keeps how fast particle i and its rim are.
SC_FN void sc_keep_speeds(sc_fixed_space s, size_t i, sc_vec velocity, float inverse_mass, sc_vec rim, float inverse_radius,
                          sc_rests rests, __global float4* speed, __global float4* spin) {
  const real unit = s.length / s.time;
  const float4 kept = sc_narrow(velocity, unit, inverse_mass), kept_rim = sc_narrow(rim, unit, inverse_radius);
  speed[i] = kept;
  spin[i] = kept_rim;
  vstore3(sc_rest_of(velocity, unit, kept), i, rests.speeds);
  vstore3(sc_rest_of(rim, unit, kept_rim), i, rests.spins);
}

/// How a particle goes on: by `way`, and how fast it and its rim are then.
typedef struct {
  sc_vec way, velocity, rim;
} sc_going_on;

/// Writes where particle i has gone from the numbers of `near`, and the rest of them; and notes how.
SC_FN void sc_store_mixed(sc_fixed_space s, size_t i, sc_going_on q, uint4 near, float inverse_mass, float inverse_radius,
                          sc_rests rests, __global int4* images, __global uint4* near_out, __global float4* speed_out,
                          __global float4* spin_out, sc_found* found) {
  const uint3 rest = vload3(i, rests.places);
  const sc_gone x = sc_go_on(s, 0, sc_number_of(near.x, rest.x, s.turn[0]), q.way.x);
  const sc_gone y = sc_go_on(s, 1, sc_number_of(near.y, rest.y, s.turn[1]), q.way.y);
  const sc_gone z = sc_go_on(s, 2, sc_number_of(near.z, rest.z, s.turn[2]), q.way.z);
  sc_keep_place_numbers(s, i, x.number, y.number, z.number, near.w, near_out, rests.places);
  if (x.wrapped != 0 || y.wrapped != 0 || z.wrapped != 0) images[i] += (int4)(x.wrapped, y.wrapped, z.wrapped, 0);
  sc_keep_speeds(s, i, q.velocity, inverse_mass, q.rim, inverse_radius, rests, speed_out, spin_out);
  sc_note_speed(q.velocity, found);
  found->outside |= x.outside | y.outside | z.outside;
}

/// Whether lists do not hold any more after a step of `way`. What others read does not tell a way as long as a window.
SC_FN int sc_is_stale(sc_fixed_space s, sc_vec way, uint4 listed, uint4 near, real stale_square) {
  const sf_space space = sc_space_of(s);
  const sc_vec gone = sc_wide_vec(sf_branch(space, sf_place_of(space, listed), sf_place_of(space, near)), s.length);
  return !(sc_dot(way, way) <= stale_square) || !(sc_dot(gone, gone) <= R(0.999999) * stale_square);
}

#if !SC_SHAPED
/// One step, like sc_pass.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_pass_mixed(
    const sc_device_step p, const int step, __global int* stale, const sc_fixed_space s, __global const uint4* near,
    __global const float4* speed, __global const float4* spin, __global uint4* near_out, __global float4* speed_out,
    __global float4* spin_out, __global uint* rest_places, __global float* rest_speeds, __global float* rest_spins,
    __global const float* excess, __global const int* material, __global const uint4* listed,
    __global const sf_pair_law* pair_laws, __global const sc_pair_law* laws, __global const int* counts,
    __global uint* partners, __global float4* slides, __global float4* rolls, __global const sc_wall* faces,
    __global const sc_wall_pose* poses, __global const int* face_counts, __global uint* near_faces,
    __global real4* face_slides, __global real4* face_rolls, __global real4* gaps, __global int* corners,
    __global int4* images, __global const sc_field* fields, __global const real4* streams, __global const real4* pulls,
    __global const real4* befores, __global real4* losses, __global real4* works, __global real4* impulses,
    __global real4* angulars, __global real4* drag_impulses, __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles) {
    const sf_space space = sc_space_of(s);
    const sf_state state = {near, speed, spin, excess, material};
    const sf_meeting meeting = {space,
                                sc_narrow_time(p.time, s.time),
                                (size_t)p.counts.particles,
                                p.counts.materials,
                                (float)(p.margin / s.length),
                                (float)(SC_SPEED_QUANTUM * s.time / s.length)};
    const sf_row own = sf_read_row(state, i, sf_place_at(space, state, i));
    sf_found found_there = sf_nothing_found();
    const sf_gathered g =
        sf_meet_partners(meeting, i, own, state, pair_laws, counts[i], partners, slides, rolls, &found_there);
    found = sc_widen_found(found_there);
    const sc_rests rests = {rest_places, rest_speeds, rest_spins};
    const uint4 here = near[i];
    const int near_count = p.counts.faces > 0 ? face_counts[i] : 0;
    const sc_near_faces f = {i,     (size_t)p.counts.particles,   near_count,
                             faces, poses + step * p.counts.walls, near_faces,
                             face_slides, face_rolls, gaps, corners, 0, 0, 0};
    const sc_acting acting = {fields, {streams, pulls, befores}};
    const sc_books books = {losses, works, impulses, angulars, drag_impulses};
    const sc_row wide = sc_widen_row(s, own, sc_place_of_numbers(s, here, rests, i), rests, i);
    const sc_sphere_motion q =
        sc_go(p, wide, sc_zero_vec(), sc_widen_gathered(s, g), f, laws, acting, books, &found).motion;
    const sc_going_on gone = {q.position, q.velocity, q.rim};
    sc_store_mixed(s, i, gone, here, own.speed.w, own.rim.w, rests, images, near_out, speed_out, spin_out, &found);
    found.stale = sc_is_stale(s, q.position, listed[i], near_out[i], p.stale_square);
  }
  sc_report(p, step, found, halted, all, stale, findings);
}
#endif

/// Puts `count` rows in double precision, from row `first` on, into mixed precision.
__kernel void sc_narrow_state(const int first, const int count, const sc_fixed_space s, __global const real4* motion,
                              __global const real4* spin, __global const real* excess, __global uint4* near,
                              __global float4* speed, __global float4* spin_out, __global uint* rest_places,
                              __global float* rest_speeds, __global float* rest_spins, __global float* excess_out) {
  const size_t item = get_global_id(0), i = item + (size_t)first;
  if (item >= (size_t)count) return;
  const sc_rests rests = {rest_places, rest_speeds, rest_spins};
  const real4 place = motion[2 * i], moves = motion[2 * i + 1], turns = spin[i];
  sc_keep_place_numbers(s, i, sc_number_at(place.x, s.low[0], s.span[0]), sc_number_at(place.y, s.low[1], s.span[1]),
                        sc_number_at(place.z, s.low[2], s.span[2]), sc_ticks_of(s, place.w), near, rest_places);
  sc_keep_speeds(s, i, sc_first(moves), (float)(moves.w * s.mass), sc_first(turns), (float)(turns.w * s.length), rests,
                 speed, spin_out);
  excess_out[i] = (float)(excess[i] / s.length);
}

/// Takes velocities and spins from the rows in double precision, where something has changed them; others do not change.
__kernel void sc_narrow_speeds(const int step, __global const int* stale, const int n, const sc_fixed_space s,
                               __global const real4* motion, __global const real4* spin, __global float4* speed,
                               __global float4* spin_out, __global uint* rest_places, __global float* rest_speeds,
                               __global float* rest_spins) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n || stale[step] != 0) return;
  const sc_rests rests = {rest_places, rest_speeds, rest_spins};
  sc_keep_speeds(s, i, sc_first(motion[2 * i + 1]), speed[i].w, sc_first(spin[i]), spin_out[i].w, rests, speed, spin_out);
}

/// Keeps places by other windows of the same box, to their last bit.
__kernel void sc_change_windows(const int n, const sc_fixed_space was, const sc_fixed_space s, __global const real4* motion,
                                __global uint4* near, __global uint* rest_places) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n) return;
  const uint4 here = near[i];
  const uint3 rest = vload3(i, rest_places);
  sc_keep_place_numbers(s, i, sc_number_of(here.x, rest.x, was.turn[0]), sc_number_of(here.y, rest.y, was.turn[1]),
                        sc_number_of(here.z, rest.z, was.turn[2]), sc_ticks_of(s, motion[2 * i].w), near, rest_places);
}

/// Brings positions, velocities and spins back into the rows in double precision; radii and masses there stay.
__kernel void sc_widen_state(const int n, const sc_fixed_space s, __global const uint4* near, __global const float4* speed,
                             __global const float4* spin, __global uint* rest_places, __global float* rest_speeds,
                             __global float* rest_spins, __global real4* motion, __global real4* spin_out) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n) return;
  const sc_rests rests = {rest_places, rest_speeds, rest_spins};
  const real4 place = sc_place_of_numbers(s, near[i], rests, i);
  const real unit = s.length / s.time;
  const sc_vec velocity = sc_widen(speed[i], vload3(i, rest_speeds), unit);
  const sc_vec rim = sc_widen(spin[i], vload3(i, rest_spins), unit);
  motion[2 * i] = (real4)(place.x, place.y, place.z, motion[2 * i].w);
  motion[2 * i + 1] = (real4)(velocity.x, velocity.y, velocity.z, motion[2 * i + 1].w);
  spin_out[i] = (real4)(rim.x, rim.y, rim.z, spin_out[i].w);
}

/// Size of what the host passes.
__kernel void sc_mixed_sizes(__global int* out) {
  if (get_global_id(0) == 0) out[0] = (int)sizeof(sc_fixed_space);
}
