// Bodies of any shape on a device. A step is four launches: which pairs need a look (pairs.cl); those, each once, with what it
// does to both partners written down; the walls; and every particle gathers what its partners gave in the order of their ids,
// adds its walls, and moves. The rules are those of particles/sweep_shapes.h.
#include "scree/kernels/opencl/bodies.cl"

/// All particles: full_bodies.cl or mixed_bodies.cl say how their present state is kept.
typedef struct {
  sc_bodies_now now;
  __global const real4 *orientations, *momenta, *inertias;
  __global const int *material, *form, *ghost;
  __global const sc_form* forms;
  __global const sc_pair_law* laws;
} sc_bodies;

/// What is known of pairs besides: the way of both surfaces up to which they are apart, and whether their loads hold.
typedef struct {
  sc_kept_pairs kept;
  __global real* apart;
  __global uchar* full;
} sc_known_pairs;

/// Particle i for the narrow phase.
SC_FN sc_body_shape sc_shape_at(sc_bodies b, size_t i) {
  sc_body_shape s;
  s.form = b.forms[b.form[i]];
  s.radius = sc_reach_at(b.now, i);
  s.turn = sc_quat_mat(sc_quat_from(b.orientations[i]));
  return s;
}

SC_FN sc_law_side sc_side_at(sc_bodies b, size_t i) {
  return sc_law_side_at(b.now, i, sc_first(b.inertias[i]), sc_quat_mat(sc_quat_from(b.orientations[i])));
}

/// Radius of a sphere inside particle i, over which its overlaps count.
SC_FN real sc_inscribed_at(sc_bodies b, size_t i) { return sc_reach_at(b.now, i) * b.forms[b.form[i]].inscribed; }

SC_FN sc_shape_memory sc_shape_memory_at(sc_kept_pairs q, size_t c) {
  const real4 start = convert_double4(q.shapes[2 * c]), radii = convert_double4(q.shapes[2 * c + 1]);
  sc_shape_memory m;
  m.start.point = sc_first(start);
  m.start.share = start.w;
  m.reach = radii.x;
  m.radius = radii.y;
  return m;
}

SC_FN void sc_keep_shape_memory(sc_kept_pairs q, size_t c, sc_shape_memory m) {
  q.shapes[2 * c] = sc_to_pair_row((real4)(m.start.point.x, m.start.point.y, m.start.point.z, m.start.share));
  q.shapes[2 * c + 1] = sc_to_pair_row((real4)(m.reach, m.radius, R(0), R(0)));
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
  const real excess = sc_excess_at(b.now, i) + sc_excess_at(b.now, j);
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

/// The laws for pair c, and what it remembers.
SC_FN void sc_act_on_found(sc_device_step p, sc_bodies b, sc_kept_pairs q, size_t c, sc_shape_meeting m, sc_found* found) {
  const size_t i = q.pairs[c].x & SC_PARTNER, j = q.pairs[c].y;
  sc_found of_pair = sc_nothing_found();
  const int touching = sc_act_as_found(b.now, q, c, m, sc_side_at(b, i), sc_side_at(b, j), p.time, &of_pair);
  const real smaller = SC_MIN(sc_inscribed_at(b, i), sc_inscribed_at(b, j));
  found->deepest = SC_MAX(found->deepest, m.place.overlap / smaller);
  if (touching) sc_keep_shape_memory(q, c, m.memory);
  // Two ranks that share a pair both do this: that of the lower id, which owns it, counts.
  if (!sc_is_ghost(b.ghost, i)) *found = sc_join(*found, of_pair);
}

/// The contact of pair c.
SC_FN void sc_meet_pair(sc_device_step p, sc_bodies b, sc_known_pairs q, size_t c, sc_found* found) {
  const uint2 pair = q.kept.pairs[c];
  const int acted = pair.x >> SC_CODE_SHIFT != 0u;
  const size_t i = pair.x & SC_PARTNER, j = pair.y;
  const sc_vec branch = sc_way_between(p.box, b.now, i, j);
  const real own = sc_reach_at(b.now, i), other = sc_reach_at(b.now, j);
  const real reach = own + other, distance = sc_norm(branch), way = b.momenta[i].w + b.momenta[j].w;
  const sc_pair_law law = b.laws[b.material[i] * p.counts.materials + b.material[j]];
  int acts = 0;
  real gap = sc_sphere_gap(branch, reach);
  if (!(gap > p.margin && !acted)) {
    sc_shape_meeting m;
    if (b.form[i] == 0 && b.form[j] == 0) {
      m = sc_meet_as_spheres(branch, own, other, law, sc_excess_at(b.now, i) + sc_excess_at(b.now, j));
      gap = R(0);
    } else {
      const sc_pair_found f = sc_search_pair(b, i, j, branch, acted, sc_shape_memory_at(q.kept, c), law);
      m = f.meeting;
      gap = f.gap;
    }
    acts = (m.in_reach && m.place.overlap + p.margin > R(0)) || acted;
    if (acts) sc_act_on_found(p, b, q.kept, c, m, found);
  }
  const real free_way = sc_free_way(gap, distance, reach, sc_shortest_period(p.box)) - (p.margin + sc_blur(b.now));
  q.full[c] = (uchar)acts;
  q.apart[c] = acts ? R(0) : sc_apart_until(way, free_way);
}

/// The contacts of the pairs that need a look (sc_list_looks), by as many items as the host gives, each the next one in turn.
/// What groups have found is noted from `note_at` on.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_meet_pairs(
    const sc_device_step p, const int step, const int count, __global int* stale, SC_BODIES_NOW,
    __global const real4* orientations, __global const real4* momenta, __global const real4* inertias,
    __global const int* material, __global const int* form, __global const int* ghost, __global const sc_form* forms,
    __global const sc_pair_law* laws, __global uint2* pairs, __global sc_pair_row* slides, __global sc_pair_row* rolls,
    __global sc_pair_row* shapes, __global sc_pair_row* loads, __global real* apart, __global uchar* full,
    __global const uint* looks, __global const int* numbers, const int note_at, __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const sc_bodies b = {SC_BODIES_HELD, orientations, momenta, inertias, material, form, ghost, forms, laws};
  const sc_known_pairs q = {{pairs, slides, rolls, shapes, loads}, apart, full};
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
    const sc_device_step p, const int step, __global int* stale, SC_BODIES_NOW, __global const real4* orientations,
    __global const real4* inertias, __global const int* material, __global const int* form,
    __global const sc_form* forms, __global const sc_pair_law* laws, __global const sc_wall* faces,
    __global const sc_wall_pose* poses,
    __global const int* face_counts, __global uint* near_faces, __global real4* face_slides, __global real4* face_rolls,
    __global real4* face_shapes, __global real4* gaps, __global int* corners, __global real4* places,
    __global real4* works, __global real4* loads, const int note_at, __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles) {
    const sc_bodies b = {SC_BODIES_HELD, orientations, 0, inertias, material, form, 0, forms, laws};
    const sc_row own = sc_body_row(b.now, i, material);
    const sc_near_faces f = {i,           (size_t)p.counts.particles,   face_counts[i], faces,
                             poses + step * p.counts.walls, near_faces, face_slides,    face_rolls,
                             gaps,        corners,                      form[i] != 0,   face_shapes,
                             places};
    sc_gathered g = sc_nothing_gathered();
    if (f.count > 0 && f.is_body) {
      sc_wall_visitor v;
      v.at.shape = sc_shape_at(b, i);
      v.at.side = sc_side_of(own.speed, own.rim, sc_first(inertias[i]), v.at.shape.turn);
      v.at.centre = sc_first(own.place);
      v.at.excess = sc_excess_at(b.now, i);
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
SC_FN sc_gathered sc_gather_pairs(sc_bodies_now now, size_t n, size_t i, int count, __global const uint* gather,
                                  __global const uchar* full, __global const sc_pair_row* loads) {
  sc_gathered g = sc_nothing_gathered();
  for (int k = 0; k < count; ++k) {
    const uint entry = gather[(size_t)k * n + i];
    const size_t c = entry >> 1;
    if (!full[c]) continue;
    const int partner = (int)(entry & 1u);
    const sc_gathered_pair pair = sc_pair_at(now, loads, c);
    g.force = sc_add(g.force, sc_scale(partner ? R(-1) : R(1), sc_first(pair.force)));
    g.turn = sc_add(g.turn, sc_first(partner ? pair.other : pair.own));
    g.loss_normal += R(0.5) * pair.force.w;
    g.loss_sliding += R(0.5) * pair.own.w;
    g.loss_rolling += R(0.5) * pair.other.w;
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
    const sc_device_step p, const int step, __global int* stale, SC_BODIES_NOW, SC_BODIES_NEXT,
    __global real4* orientations, __global real4* momenta, __global const real4* inertias, __global const int* material,
    __global const int* ghost, __global const int* counts, __global const uint* gather, __global const uchar* full,
    __global const sc_pair_row* loads, __global const real4* wall_loads, __global int4* images,
    __global const sc_field* fields, __global const real4* streams, __global const real4* pulls,
    __global const real4* befores, __global real4* losses, __global real4* works, __global real4* impulses,
    __global real4* angulars, __global real4* drag_impulses, __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles && !sc_is_ghost(ghost, i)) {
    const sc_bodies_now now = SC_BODIES_HELD;
    const sc_bodies_next next = SC_BODIES_TO;
    const sc_row own = sc_body_row(now, i, material);
    const real4 momentum = momenta[i];
    const int free_body = own.speed.w > R(0);
    const sc_gathered of_partners = sc_gather_pairs(now, (size_t)p.counts.particles, i, counts[i], gather, full, loads);
    const sc_gathered of_walls = p.counts.faces > 0 ? sc_gathered_of_walls(wall_loads, i) : sc_nothing_gathered();
    const sc_gathered all_of = sc_gather_walls(of_partners, of_walls);
    const sc_body_motion s = sc_body_at(own, sc_quat_from(orientations[i]), momentum, inertias[i]);
    sc_body_motion from = s;
    from.centre.position = sc_start_at(s.centre.position);
    const sc_acting acting = {fields, {streams, pulls, befores}};
    const sc_books books = {losses, works, impulses, angulars, drag_impulses};
    const sc_body_moved moved =
        sc_move_body(sc_move_at(p), from, all_of.force, all_of.turn, sc_field_on(p, s.centre, acting, i));
    const sc_gathered push = free_body ? of_walls : all_of;
    const int among_others = SC_CHOSEN_FIELDS != SC_FIELDS_NONE || !free_body || of_walls.near;
    sc_store_losses(i, all_of, losses);
    sc_store_books(p, i, s.centre, push.force, push.turn, moved.centre, moved.prescribed_work, among_others, books);
    const sc_quat turned = moved.orientation;
    const sc_vec l = moved.angular_momentum;
    const sc_vec rim = free_body ? sc_scale(own.place.w, moved.spin) : sc_first(own.rim);
    sc_store_body(p, i, now, next, own, moved.centre, rim, images, &found);
    orientations[i] = (real4)(turned.w, turned.x, turned.y, turned.z);
    momenta[i] = (real4)(l.x, l.y, l.z, sc_further(momentum.w, moved.path));
  }
  sc_report(p, step, found, halted, all, stale, findings);
}

/// Sizes of what the host passes besides where some particles are no spheres.
__kernel void sc_shape_sizes(__global int* out) {
  if (get_global_id(0) == 0) out[0] = (int)sizeof(sc_form);
}
