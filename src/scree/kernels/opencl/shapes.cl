// Bodies of any shape on a device. A step is four launches: which pairs need a look (pairs.cl); those, each once, with what it
// does to both partners written down; the walls; and every particle gathers what its partners gave in the order of their ids,
// adds its walls, and moves. The rules are those of particles/sweep_shapes.h.
#include "scree/kernels/meet_shapes.h"
#include "scree/kernels/move_body.h"

/// All particles.
typedef struct {
  __global const real4 *motion, *spin, *orientations, *momenta, *inertias;
  __global const real* excess;
  __global const int *material, *form, *ghost;
  __global const sc_form* forms;
  __global const sc_pair_law* laws;
} sc_bodies;

/// All pairs: who takes part (the owner with sc_contact_code(), the partner) and what they remember, two rows of `shapes` a
/// pair. `apart`: the way of both surfaces up to which they are apart; `loads`: three rows, force on the owner and loss by
/// damping, torque on the owner and loss by sliding, torque on the partner and loss by rolling; `full`: whether those hold.
typedef struct {
  __global uint2* pairs;
  __global real4 *slides, *rolls, *shapes, *loads;
  __global real* apart;
  __global uchar* full;
} sc_pairs;

SC_FN sc_quat sc_orientation_at(sc_bodies b, size_t i) {
  const real4 q = b.orientations[i];
  return sc_make_quat(q.x, q.y, q.z, q.w);
}

/// Particle i for the narrow phase.
SC_FN sc_body_shape sc_shape_at(sc_bodies b, size_t i) {
  sc_body_shape s;
  s.form = b.forms[b.form[i]];
  s.radius = b.motion[2 * i].w;
  s.turn = sc_quat_mat(sc_orientation_at(b, i));
  return s;
}

/// Particle i for the laws.
SC_FN sc_body_side sc_side_at(sc_bodies b, size_t i) {
  const real4 speed = b.motion[2 * i + 1], rim = b.spin[i];
  sc_body_side s;
  s.velocity = sc_first(speed);
  s.spin = sc_scale(rim.w, sc_first(rim));
  s.inverse_mass = speed.w;
  s.inverse_moments = sc_first(b.inertias[i]);
  s.turn = sc_quat_mat(sc_orientation_at(b, i));
  return s;
}

/// Radius of a sphere inside particle i, over which its overlaps count.
SC_FN real sc_inscribed_at(sc_bodies b, size_t i) { return b.motion[2 * i].w * b.forms[b.form[i]].inscribed; }

SC_FN sc_shape_memory sc_shape_memory_at(sc_pairs q, size_t c) {
  const real4 start = q.shapes[2 * c], radii = q.shapes[2 * c + 1];
  sc_shape_memory m;
  m.start.point = sc_first(start);
  m.start.share = start.w;
  m.reach = radii.x;
  m.radius = radii.y;
  return m;
}

SC_FN void sc_keep_shape_memory(sc_pairs q, size_t c, sc_shape_memory m) {
  q.shapes[2 * c] = (real4)(m.start.point.x, m.start.point.y, m.start.point.z, m.start.share);
  q.shapes[2 * c + 1] = (real4)(m.reach, m.radius, R(0), R(0));
}

/// Of the box; more than any length if it is not periodic [m].
SC_FN real sc_shortest_period(sc_box box) {
  real shortest = R(1e300);
  for (int k = 0; k < 3; ++k)
    if (box.period[k] > R(0)) shortest = SC_MIN(shortest, box.period[k]);
  return shortest;
}

/// How a pair meets, and how far apart it is at least.
typedef struct {
  sc_shape_meeting meeting;
  real gap;  // [m]
} sc_pair_found;

/// Searches for the contact of the bodies i, the owner, and j.
SC_FN sc_pair_found sc_search_pair(sc_bodies b, size_t i, size_t j, sc_vec branch, int acted,
                                   sc_shape_memory memory, sc_pair_law law) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const sc_body_shape first = sc_shape_at(b, i), second = sc_shape_at(b, j);
  const real excess = b.excess[i] + b.excess[j];
  sc_growth_pair pair = sc_pair_of_shapes(first, second, branch);
  pair.limit = sc_growth_limit(chosen, first, second, acted, excess);
  const sc_shape_touch found = sc_shape_touch_of(first, second, branch, sc_growth_solve(pair, acted, memory.start));
  if (found.verdict == SC_GROWTH_TOUCHING && !acted)
    memory = sc_shapes_meet(first, second, found, b.inertias[i].w, b.inertias[j].w);
  sc_pair_found out;
  out.gap = sc_gap_as_found(first, second, branch, found);
  out.meeting = sc_meet_as_found(found, memory, law, excess);
  return out;
}

/// Evaluates the laws for pair c, writes down what they do to both bodies, and keeps what the pair remembers.
SC_FN void sc_act_on_pair(sc_device_step p, sc_bodies b, sc_pairs q, size_t c, sc_shape_meeting m, sc_found* found) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const uint2 pair = q.pairs[c];
  const uint code = pair.x >> SC_CODE_SHIFT;
  const size_t i = pair.x & SC_PARTNER, j = pair.y;
  const sc_touch touch = sc_touch_at(m.place, sc_side_at(b, i), sc_side_at(b, j), m.excess);
  const real4 slide = code ? q.slides[c] : (real4)(R(0));
  const real4 roll = SC_ROLLS && code ? q.rolls[c] : (real4)(R(0));
  const sc_contact_result r = sc_contact_act(chosen, m.law, touch, p.time, sc_state_from(code, slide, roll));
  const sc_contact_action a = r.action;
  const sc_shape_loads loads = sc_loads_of(m.place, a);
  q.loads[3 * c] = (real4)(loads.force.x, loads.force.y, loads.force.z, a.loss_normal);
  q.loads[3 * c + 1] = (real4)(loads.torque_a.x, loads.torque_a.y, loads.torque_a.z, a.loss_sliding);
  q.loads[3 * c + 2] = (real4)(loads.torque_b.x, loads.torque_b.y, loads.torque_b.z, a.loss_rolling);
  const real smaller = SC_MIN(sc_inscribed_at(b, i), sc_inscribed_at(b, j));
  found->deepest = SC_MAX(found->deepest, m.place.overlap / smaller);
  const int touching = a.touching != 0;
  q.pairs[c].x = (uint)i | (sc_contact_code(touching, r.state.slid) << SC_CODE_SHIFT);
  if (!touching) return;
  sc_keep_shape_memory(q, c, m.memory);
  q.slides[c] = sc_slide_row(r.state);
  if (SC_ROLLS) q.rolls[c] = sc_roll_row(r.state);
  // Two ranks that share a pair both do this: that of the lower id, which owns it, counts.
  if (sc_is_ghost(b.ghost, i)) return;
  ++found->contacts;
  if (code) return;
  ++found->impacts;
  found->impact_speed += (sc_count)(sc_dot(touch.velocity, touch.normal) / SC_SPEED_QUANTUM);
}

/// The contact of pair c.
SC_FN void sc_meet_pair(sc_device_step p, sc_bodies b, sc_pairs q, size_t c, sc_found* found) {
  const uint2 pair = q.pairs[c];
  const int acted = pair.x >> SC_CODE_SHIFT != 0u;
  const size_t i = pair.x & SC_PARTNER, j = pair.y;
  const real4 here = b.motion[2 * i], there = b.motion[2 * j];
  const sc_vec branch = sc_branch(p.box, here, there);
  const real reach = here.w + there.w, distance = sc_norm(branch), way = b.momenta[i].w + b.momenta[j].w;
  const sc_pair_law law = b.laws[b.material[i] * p.counts.materials + b.material[j]];
  int acts = 0;
  real gap = sc_sphere_gap(branch, reach);
  if (!(gap > p.margin && !acted)) {
    sc_shape_meeting m;
    if (b.form[i] == 0 && b.form[j] == 0) {
      m = sc_meet_as_spheres(branch, here.w, there.w, law, b.excess[i] + b.excess[j]);
      gap = R(0);
    } else {
      const sc_pair_found f = sc_search_pair(b, i, j, branch, acted, sc_shape_memory_at(q, c), law);
      m = f.meeting;
      gap = f.gap;
    }
    acts = (m.in_reach && m.place.overlap + p.margin > R(0)) || acted;
    if (acts) sc_act_on_pair(p, b, q, c, m, found);
  }
  q.full[c] = (uchar)acts;
  q.apart[c] = acts ? R(0) : sc_apart_until(way, sc_free_way(gap, distance, reach, sc_shortest_period(p.box)) - p.margin);
}

/// The contacts of the pairs that need a look (sc_list_looks), by as many items as the host gives, each the next one in turn.
/// What groups have found is noted from `note_at` on.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_meet_pairs(
    const sc_device_step p, const int step, const int count, __global int* stale, __global const real4* motion,
    __global const real4* spin, __global const real4* orientations, __global const real4* momenta,
    __global const real4* inertias, __global const real* excess, __global const int* material, __global const int* form,
    __global const int* ghost, __global const sc_form* forms, __global const sc_pair_law* laws, __global uint2* pairs,
    __global real4* slides, __global real4* rolls, __global real4* shapes, __global real4* loads, __global real* apart,
    __global uchar* full, __global const uint* looks, __global const int* numbers, const int note_at,
    __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const sc_bodies b = {motion, spin, orientations, momenta, inertias, excess, material, form, ghost, forms, laws};
  const sc_pairs q = {pairs, slides, rolls, shapes, loads, apart, full};
  const int halted = stale[step] != 0;
  const int first = numbers[2 * step], looked = halted ? 0 : first + numbers[2 * step + 1];
  sc_found found = sc_nothing_found();
  for (int k = (int)get_global_id(0); k < looked; k += (int)get_global_size(0))
    sc_meet_pair(p, b, q, looks[k < first ? k : count - 1 - (k - first)], &found);
  sc_report(p, step, found, halted, all, stale, findings + note_at);
}

/// The contacts of all particles with walls, by particle three rows: force and loss by damping, torque and loss by sliding,
/// whether some wall was near and loss by rolling.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_meet_faces(
    const sc_device_step p, const int step, __global int* stale, __global const real4* motion, __global const real4* spin,
    __global const real4* orientations, __global const real4* inertias, __global const real* excess,
    __global const int* material, __global const int* form, __global const sc_form* forms,
    __global const sc_pair_law* laws, __global const sc_wall* faces, __global const sc_wall_pose* poses,
    __global const int* face_counts, __global uint* near_faces, __global real4* face_slides, __global real4* face_rolls,
    __global real4* face_shapes, __global real4* gaps, __global int* corners, __global real4* places,
    __global real4* works, __global real4* loads, const int note_at, __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles) {
    const sc_bodies b = {motion, spin, orientations, 0, inertias, excess, material, form, 0, forms, laws};
    const sc_state state = {motion, spin, excess, material, 0, 0};
    const sc_row own = sc_read_row(state, i, motion[2 * i]);
    const sc_near_faces f = {i,           (size_t)p.counts.particles,   face_counts[i], faces,
                             poses + step * p.counts.walls, near_faces, face_slides,    face_rolls,
                             gaps,        corners,                      form[i] != 0,   face_shapes,
                             places};
    sc_gathered g = sc_nothing_gathered();
    if (f.count > 0 && f.is_body) {
      sc_wall_visitor v;
      v.at.shape = sc_shape_at(b, i);
      v.at.side = sc_side_at(b, i);
      v.at.centre = sc_first(own.place);
      v.at.excess = excess[i];
      v.by_volume = inertias[i].w;
      v.inscribed = sc_inscribed_at(b, i);
      v.material = own.material;
      g = sc_meet_walls_as_body(p, v, f, laws, works, &found);
    } else if (f.count > 0) {
      g = sc_meet_walls_as_sphere(p, own, f, laws, works, &found);
    }
    loads[3 * i] = (real4)(g.force.x, g.force.y, g.force.z, g.loss_normal);
    loads[3 * i + 1] = (real4)(g.turn.x, g.turn.y, g.turn.z, g.loss_sliding);
    loads[3 * i + 2] = (real4)((real)g.near, R(0), R(0), g.loss_rolling);
  }
  sc_report(p, step, found, halted, all, stale, findings + note_at);
}

/// What particle i has gathered of its partners, in the order of their ids: force, and torque in place of the turn.
SC_FN sc_gathered sc_gather_pairs(size_t n, size_t i, int count, __global const uint* gather, __global const uchar* full,
                                  __global const real4* loads) {
  sc_gathered g = sc_nothing_gathered();
  for (int k = 0; k < count; ++k) {
    const uint entry = gather[(size_t)k * n + i];
    const size_t c = entry >> 1;
    if (!full[c]) continue;
    const int partner = (int)(entry & 1u);
    const real4 force = loads[3 * c], own = loads[3 * c + 1], other = loads[3 * c + 2];
    g.force = sc_add(g.force, sc_scale(partner ? R(-1) : R(1), sc_first(force)));
    g.turn = sc_add(g.turn, sc_first(partner ? other : own));
    g.loss_normal += R(0.5) * force.w;
    g.loss_sliding += R(0.5) * own.w;
    g.loss_rolling += R(0.5) * other.w;
  }
  return g;
}

SC_FN sc_gathered sc_gathered_of_walls(__global const real4* loads, size_t i) {
  const real4 force = loads[3 * i], torque = loads[3 * i + 1], rest = loads[3 * i + 2];
  sc_gathered g = sc_nothing_gathered();
  g.force = sc_first(force);
  g.turn = sc_first(torque);
  g.loss_normal = force.w;
  g.loss_sliding = torque.w;
  g.loss_rolling = rest.w;
  g.near = rest.x != R(0);
  return g;
}

SC_FN sc_body_motion sc_body_at(sc_row own, sc_quat orientation, real4 momentum, real4 inertia) {
  sc_body_motion b;
  b.centre.position = sc_first(own.place);
  b.centre.velocity = sc_first(own.speed);
  b.centre.radius = inertia.w;
  b.centre.inverse_mass = own.speed.w;
  b.orientation = orientation;
  b.angular_momentum = sc_first(momentum);
  b.spin = sc_scale(own.rim.w, sc_first(own.rim));
  b.inverse_moments = sc_first(inertia);
  b.reach = own.place.w;
  return b;
}

/// Moves every particle by one step.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_move_bodies(
    const sc_device_step p, const int step, __global int* stale, __global const real4* motion, __global const real4* spin,
    __global real4* motion_out, __global real4* spin_out, __global real4* orientations, __global real4* momenta,
    __global const real4* inertias, __global const real* excess, __global const int* material, __global const int* ghost,
    __global const real4* listed, __global const int* counts, __global const uint* gather, __global const uchar* full,
    __global const real4* loads, __global const real4* wall_loads, __global int4* images, __global const sc_field* fields,
    __global const real4* streams, __global const real4* pulls, __global const real4* befores, __global real4* losses,
    __global real4* works, __global real4* impulses, __global real4* angulars, __global real4* drag_impulses,
    __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles && !sc_is_ghost(ghost, i)) {
    const sc_state state = {motion, spin, excess, material, 0, 0};
    const sc_row own = sc_read_row(state, i, motion[2 * i]);
    const real4 momentum = momenta[i], q = orientations[i];
    const int free_body = own.speed.w > R(0);
    const sc_gathered of_partners = sc_gather_pairs((size_t)p.counts.particles, i, counts[i], gather, full, loads);
    const sc_gathered of_walls = p.counts.faces > 0 ? sc_gathered_of_walls(wall_loads, i) : sc_nothing_gathered();
    const sc_gathered all_of = sc_gather_walls(of_partners, of_walls);
    const sc_body_motion s = sc_body_at(own, sc_make_quat(q.x, q.y, q.z, q.w), momentum, inertias[i]);
    const sc_acting acting = {fields, {streams, pulls, befores}};
    const sc_books books = {losses, works, impulses, angulars, drag_impulses};
    const sc_body_moved moved =
        sc_move_body(sc_move_at(p), s, all_of.force, all_of.turn, sc_field_on(p, s.centre, acting, i));
    const sc_gathered push = free_body ? of_walls : all_of;
    const int among_others = SC_CHOSEN_FIELDS != SC_FIELDS_NONE || !free_body || of_walls.near;
    sc_store_losses(i, all_of, losses);
    sc_store_books(p, i, s.centre, push.force, push.turn, moved.centre, moved.prescribed_work, among_others, books);
    sc_store_centre(p, i, own, moved.centre, listed[i], images, motion_out, &found);
    const sc_quat turned = moved.orientation;
    const sc_vec l = moved.angular_momentum, rim = sc_scale(own.place.w, moved.spin);
    orientations[i] = (real4)(turned.w, turned.x, turned.y, turned.z);
    momenta[i] = (real4)(l.x, l.y, l.z, sc_further(momentum.w, moved.path));
    spin_out[i] = free_body ? (real4)(rim.x, rim.y, rim.z, own.rim.w) : own.rim;
  }
  sc_report(p, step, found, halted, all, stale, findings);
}

/// Sizes of what the host passes besides where some particles are no spheres.
__kernel void sc_shape_sizes(__global int* out) {
  if (get_global_id(0) == 0) out[0] = (int)sizeof(sc_form);
}
