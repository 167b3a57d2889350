// Spheres on a device. A work item is one particle: it evaluates its contacts with all partners from its own side, in the
// order of their ids, then those with walls, and moves. Exchanging the partners changes signs and no magnitudes, so that the
// two sides of a pair get the same bits, and a particle the same as from the CPU's slots.
//
// The state is read from one set of buffers and written to another, so that nobody sees a partner that has moved. When lists
// no longer hold, the steps that were given ahead do nothing; the host makes lists and gives them again.
#include "scree/kernels/books.h"
#include "scree/kernels/wrap.h"

/// The books of all particles, as in Particles.
typedef struct {
  __global real4* losses;
  __global real4* works;
  __global real4* impulses;
  __global real4* angulars;
  __global real4* drag_impulses;  // of a fluid that is solved for
} sc_books;

/// What acts besides contacts: where a kernel of its own has found it, that; and what a fluid has said.
typedef struct {
  __global const sc_field* fields;
  sc_said said;
} sc_acting;

SC_FN sc_sphere_load sc_load_of(sc_gathered g) {
  sc_sphere_load l;
  l.force = g.force;
  l.turn = g.turn;
  l.couple = g.couple;
  return l;
}

SC_FN void sc_note_speed(sc_vec velocity, sc_found* found) {
  const real square = sc_dot(velocity, velocity);
  found->fastest_square = SC_MAX(found->fastest_square, square);
  found->unsound |= !(square < R(1e300));
}

/// Writes where a centre has gone and how fast it is, and notes how.
SC_FN void sc_store_centre(sc_device_step p, size_t i, sc_row own, sc_centre_moved q, real4 listed, __global int4* images,
                           __global real4* motion_out, sc_found* found) {
  const int4 image = images[i];
  const sc_wrapped x = sc_wrap(q.position.x, p.box.low[0], p.box.high[0], p.box.period[0], image.x);
  const sc_wrapped y = sc_wrap(q.position.y, p.box.low[1], p.box.high[1], p.box.period[1], image.y);
  const sc_wrapped z = sc_wrap(q.position.z, p.box.low[2], p.box.high[2], p.box.period[2], image.z);
  if (x.image != image.x || y.image != image.y || z.image != image.z)
    images[i] = (int4)(x.image, y.image, z.image, image.w);
  const real4 place = (real4)(x.x, y.x, z.x, own.place.w);
  motion_out[2 * i] = place;
  motion_out[2 * i + 1] = (real4)(q.velocity.x, q.velocity.y, q.velocity.z, own.speed.w);
  const sc_vec way = sc_branch(p.box, listed, place);
  sc_note_speed(q.velocity, found);
  found->outside |= x.outside | y.outside | z.outside;
  found->stale |= !(sc_dot(way, way) <= p.stale_square);
}

SC_FN void sc_store_losses(size_t i, sc_gathered all, __global real4* losses) {
  if (all.loss_normal != R(0) || all.loss_sliding != R(0) || all.loss_rolling != R(0))
    losses[i] += (real4)(all.loss_normal, all.loss_sliding, all.loss_rolling, R(0));
}

/// Adds to the books of particle i what is not zero: of a force and a torque as sc_book() takes them, and of fields.
SC_FN void sc_store_books(sc_device_step p, size_t i, sc_centre before, sc_vec force, sc_vec torque, sc_centre_moved moved,
                          real prescribed_work, int among_others, sc_books books) {
  if (!among_others && !p.book_gravity) return;
  const sc_booked b = sc_book(p.move, before, force, torque, moved, p.book_gravity);
  books.angulars[i] += (real4)(b.angular.x, b.angular.y, b.angular.z, R(0));
  if (!among_others) return;
  if (SC_CHOSEN_COUPLED) {
    // What a fluid that is solved for does to a particle is one work, whatever part of it the pressure has.
    const sc_vec drag = moved.drag_impulse;
    books.works[i] += (real4)(moved.drag_work + moved.body_work, R(0), prescribed_work, R(0));
    books.drag_impulses[i] += (real4)(drag.x, drag.y, drag.z, p.move.kick);
  } else {
    books.works[i] += (real4)(moved.drag_work, moved.body_work, prescribed_work, R(0));
  }
  books.impulses[i] += (real4)(b.impulse.x, b.impulse.y, b.impulse.z, R(0));
}

SC_FN sc_found sc_join(sc_found a, sc_found b) {
  sc_found c;
  c.fastest_square = SC_MAX(a.fastest_square, b.fastest_square);
  c.deepest = SC_MAX(a.deepest, b.deepest);
  c.contacts = a.contacts + b.contacts;
  c.wall_contacts = a.wall_contacts + b.wall_contacts;
  c.impacts = a.impacts + b.impacts;
  c.impact_speed = a.impact_speed + b.impact_speed;
  c.unsound = a.unsound | b.unsound;
  c.outside = a.outside | b.outside;
  c.stale = a.stale | b.stale;
  return c;
}

/// Adds what a group has found in a step to what it found before.
SC_FN sc_findings sc_add_found(sc_findings f, sc_found sum) {
  f.fastest_square = sum.fastest_square;
  f.deepest = sum.deepest;
  f.contacts = sum.contacts;
  f.wall_contacts = sum.wall_contacts;
  f.all_contacts += sum.contacts;
  f.all_wall_contacts += sum.wall_contacts;
  f.impacts += sum.impacts;
  f.impact_speed += sum.impact_speed;
  f.unsound |= sum.unsound;
  f.outside |= sum.outside;
  return f;
}

/// Adds what walls gave to what partners gave.
SC_FN sc_gathered sc_gather_walls(sc_gathered g, sc_gathered walls) {
  g.force = sc_add(g.force, walls.force);
  g.turn = sc_add(g.turn, walls.turn);
  g.couple = sc_add(g.couple, walls.couple);
  g.loss_normal += walls.loss_normal;
  g.loss_sliding += walls.loss_sliding;
  g.loss_rolling += walls.loss_rolling;
  return g;
}

SC_FN sc_sphere_motion sc_sphere_at(sc_row own) {
  sc_sphere_motion s;
  s.position = sc_first(own.place);
  s.velocity = sc_first(own.speed);
  s.rim = sc_first(own.rim);
  s.radius = own.place.w;
  s.inverse_mass = own.speed.w;
  s.inverse_radius = own.rim.w;
  return s;
}

/// The law of motion for what a particle may meet.
SC_FN sc_move sc_move_at(sc_device_step p) {
  sc_move m = p.move;
  m.drag = SC_CHOSEN_DRAG;
  return m;
}

/// What acts on particle i besides contacts.
SC_FN sc_field sc_field_on(sc_device_step p, sc_centre centre, sc_acting acting, size_t i) {
  return SC_CHOSEN_FIELDS == SC_FIELDS_APART  ? acting.fields[i]
         : SC_CHOSEN_FIELDS == SC_FIELDS_HERE ? sc_field_at(p, centre, acting.said, i)
                                              : sc_no_field();
}

/// Moves a sphere that has gathered its contacts with others: walls, fields, books. Its new position counts from `start`.
SC_FN sc_sphere_moved sc_go(sc_device_step p, sc_row own, sc_vec start, sc_gathered all_of, sc_near_faces f,
                            __global const sc_pair_law* laws, sc_acting acting, sc_books books, sc_found* found) {
  const size_t i = f.particle;
  sc_gathered of_walls = sc_nothing_gathered();
  const int free_body = own.speed.w > R(0);
  if (free_body && p.counts.faces > 0) {
    of_walls = sc_meet_walls(p, own, f, laws, books.works, found);
    all_of = sc_gather_walls(all_of, of_walls);
  }
  const sc_sphere_motion s = sc_sphere_at(own);
  sc_sphere_motion from = s;
  from.position = start;
  const sc_field field = sc_field_on(p, sc_centre_of_sphere(s), acting, i);
  const sc_sphere_moved moved = sc_move_sphere(sc_move_at(p), from, sc_load_of(all_of), field);
  const int among_others = SC_CHOSEN_FIELDS != SC_FIELDS_NONE || !free_body || of_walls.near;
  const sc_gathered push = free_body ? of_walls : all_of;
  sc_store_losses(i, all_of, books.losses);
  sc_store_books(p, i, sc_centre_of_sphere(s), push.force, sc_add_scaled(push.couple, s.radius, push.turn), moved.centre,
                 moved.prescribed_work, among_others, books);
  return moved;
}

/// Joins what all items of a group have found, two by two; no barrier is under a condition. What makes steps that were given
/// ahead void is noted for the next one, or handed on.
SC_FN void sc_report(sc_device_step p, int step, sc_found found, int halted, __local sc_found* all, __global int* stale,
                     __global sc_findings* findings) {
  const int item = (int)get_local_id(0);
  all[item] = found;
  for (int part = SC_GROUP / 2; part > 0; part /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < part) all[item] = sc_join(all[item], all[item + part]);
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  if (item == 0 && !halted) {
    const sc_found sum = all[0];
    findings[get_group_id(0)] = sc_add_found(findings[get_group_id(0)], sum);
    if (sum.stale || sum.unsound || sum.outside || sum.deepest > p.max_overlap) stale[step + 1] = 1;
  }
  if (halted && get_global_id(0) == 0) stale[step + 1] = 1;
}

#if !SC_SHAPED
/// One step, number `step` of those that `poses` ([step][wall]) were sent for. Nothing happens if lists did not hold any more
/// after an earlier one, or if what acts in this one is no number (sc_halt_where_lost).
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_pass(
    const sc_device_step p, const int step, __global int* stale, __global const real4* motion,
    __global const real4* spin, __global real4* motion_out, __global real4* spin_out, __global const real* excess,
    __global const int* material, __global const int* ghost, __global const long* id, __global const real4* listed,
    __global const sc_pair_law* laws, __global const int* counts, __global uint* partners, __global real4* slides,
    __global real4* rolls, __global const sc_wall* faces, __global const sc_wall_pose* poses, __global const int* face_counts,
    __global uint* near_faces, __global real4* face_slides, __global real4* face_rolls, __global real4* gaps,
    __global int* corners, __global int4* images, __global const sc_field* fields, __global const real4* streams,
    __global const real4* pulls, __global const real4* befores, __global real4* losses, __global real4* works,
    __global real4* impulses, __global real4* angulars, __global real4* drag_impulses, __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles && !sc_is_ghost(ghost, i)) {
    const sc_state state = {motion, spin, excess, material, ghost, id};
    const sc_meeting meeting = {p.box, p.time, (size_t)p.counts.particles, p.counts.materials, p.margin, SC_SPEED_QUANTUM};
    const int near_count = p.counts.faces > 0 ? face_counts[i] : 0;
    const sc_near_faces f = {i,     (size_t)p.counts.particles,   near_count,
                             faces, poses + step * p.counts.walls, near_faces,
                             face_slides, face_rolls, gaps, corners, 0, 0, 0};
    const sc_acting acting = {fields, {streams, pulls, befores}};
    const sc_books books = {losses, works, impulses, angulars, drag_impulses};
    const sc_row own = sc_read_row(state, i, sc_place_at(p.box, state, i));
    const sc_gathered g = sc_meet_partners(meeting, i, own, state, laws, counts[i], partners, slides, rolls, &found);
    const sc_sphere_moved q = sc_go(p, own, sc_first(own.place), g, f, laws, acting, books, &found);
    sc_store_centre(p, i, own, q.centre, listed[i], images, motion_out, &found);
    const sc_vec rim = q.motion.rim;
    spin_out[i] = (real4)(rim.x, rim.y, rim.z, own.rim.w);
  }
  sc_report(p, step, found, halted, all, stale, findings);
}
#endif
