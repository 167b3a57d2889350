// Spheres on a device. A work item is one particle: it evaluates its contacts with all partners from its own side, in the
// order of their ids, then those with walls, and moves. Exchanging the partners changes signs and no magnitudes, so that the
// two sides of a pair get the same bits, and a particle the same as from the CPU's slots.
//
// The state is read from one set of buffers and written to another, so that nobody sees a partner that has moved. When lists
// no longer hold, the steps that were given ahead do nothing; the host makes lists and gives them again.
#include "scree/kernels/books.h"
#include "scree/kernels/wrap.h"

SC_FN real sc_nearest_image(real d, real period, real middle) {
  if (d > middle) d -= period;
  if (d < -middle) d += period;
  return d;
}

SC_FN sc_vec sc_branch(sc_box box, real4 a, real4 b) {
  return sc_make_vec(sc_nearest_image(b.x - a.x, box.period[0], box.half_period[0]),
                     sc_nearest_image(b.y - a.y, box.period[1], box.half_period[1]),
                     sc_nearest_image(b.z - a.z, box.period[2], box.half_period[2]));
}

SC_FN sc_row sc_read_row(__global const real4* motion, __global const real4* spin, __global const real* excess,
                         __global const int* material, size_t i, real4 place) {
  sc_row r;
  r.place = place;
  r.speed = motion[2 * i + 1];
  r.rim = spin[i];
  r.excess = SC_CHOSEN_COHESION != SC_COHESION_NONE ? excess[i] : R(0);
  r.material = material[i];
  return r;
}

/// How a particle meets a partner, from its own side.
SC_FN sc_sphere_touch sc_touch_rows(sc_row a, sc_row b, sc_vec branch) {
  sc_sphere_pair p;
  p.branch = branch;
  p.radii = a.place.w + b.place.w;
  p.velocity = sc_sub(sc_first(a.speed), sc_first(b.speed));
  p.inverse_mass = a.speed.w + b.speed.w;
  p.rim_speed = sc_add(sc_first(a.rim), sc_first(b.rim));
  p.inverse_radius = a.rim.w + b.rim.w;
  p.excess = a.excess + b.excess;
  p.spin = SC_ROLLS ? sc_sub(sc_scale(a.rim.w, sc_first(a.rim)), sc_scale(b.rim.w, sc_first(b.rim))) : sc_zero_vec();
  return sc_touch_spheres(p);
}

SC_FN sc_sphere_load sc_load_of(sc_gathered g) {
  sc_sphere_load l;
  l.force = g.force;
  l.turn = g.turn;
  l.couple = g.couple;
  return l;
}

/// The contacts of particle i with others.
SC_FN sc_gathered sc_meet_partners(sc_device_step p, size_t i, sc_row own, __global const real4* motion,
                                   __global const real4* spin, __global const real* excess, __global const int* material,
                                   __global const int* ghost, __global const long* id, __global const sc_pair_law* laws, int count, __global uint* partners,
                                   __global real4* slides, __global real4* rolls, sc_found* found) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  sc_gathered g = sc_nothing_gathered();
  for (int k = 0; k < count; ++k) {
    const size_t slot = (size_t)k * (size_t)p.counts.particles + i;
    const uint entry = partners[slot], code = entry >> SC_CODE_SHIFT;
    const size_t j = entry & SC_PARTNER;
    const real4 there = motion[2 * j];
    const sc_vec branch = sc_branch(p.box, own.place, there);
    const real range = own.place.w + there.w + p.margin;
    // A contact that acted is looked at once more when it has parted: the break of a bond costs energy.
    if (!(sc_dot(branch, branch) < range * range) && code == 0u) continue;
    const sc_row other = sc_read_row(motion, spin, excess, material, j, there);
    const sc_sphere_touch t = sc_touch_rows(own, other, branch);
    const real4 slide = code ? slides[slot] : (real4)(R(0));
    const real4 roll = SC_ROLLS && code ? rolls[slot] : (real4)(R(0));
    const sc_pair_law law = laws[own.material * p.counts.materials + other.material];
    const sc_contact_result r = sc_contact_act(chosen, law, t.touch, p.time, sc_state_from(code, slide, roll));
    g = sc_gather(g, t, r.action, R(0.5));
    const int acts = r.action.touching != 0;
    const uint now = sc_contact_code(acts, r.state.slid);
    if (now != code) partners[slot] = (entry & SC_PARTNER) | (now << SC_CODE_SHIFT);
    if (acts) slides[slot] = sc_slide_row(r.state);
    if (SC_ROLLS && acts) rolls[slot] = sc_roll_row(r.state);
    const real depth = t.touch.overlap * SC_MAX(own.rim.w, other.rim.w);
    found->deepest = SC_MAX(found->deepest, depth);
    // Both sides see the pair: one of them counts it, of two ranks that of the lower id.
    if (!acts || (SC_IS_GHOST(ghost, j) ? id[j] < id[i] : j < i)) continue;
    ++found->contacts;
    if (code) continue;
    ++found->impacts;
    found->impact_speed += (sc_count)(sc_dot(t.touch.velocity, t.touch.normal) / SC_SPEED_QUANTUM);
  }
  return g;
}

/// Writes where a sphere has gone, and notes how.
SC_FN void sc_store(sc_device_step p, size_t i, sc_row own, sc_sphere_motion q, real4 listed, __global int4* images,
                    __global real4* motion_out, __global real4* spin_out, sc_found* found) {
  const int4 image = images[i];
  const sc_wrapped x = sc_wrap(q.position.x, p.box.low[0], p.box.high[0], p.box.period[0], image.x);
  const sc_wrapped y = sc_wrap(q.position.y, p.box.low[1], p.box.high[1], p.box.period[1], image.y);
  const sc_wrapped z = sc_wrap(q.position.z, p.box.low[2], p.box.high[2], p.box.period[2], image.z);
  if (x.image != image.x || y.image != image.y || z.image != image.z)
    images[i] = (int4)(x.image, y.image, z.image, image.w);
  const real4 place = (real4)(x.x, y.x, z.x, own.place.w);
  motion_out[2 * i] = place;
  motion_out[2 * i + 1] = (real4)(q.velocity.x, q.velocity.y, q.velocity.z, own.speed.w);
  spin_out[i] = (real4)(q.rim.x, q.rim.y, q.rim.z, own.rim.w);
  const real square = sc_dot(q.velocity, q.velocity);
  const sc_vec way = sc_branch(p.box, listed, place);
  found->fastest_square = SC_MAX(found->fastest_square, square);
  found->unsound |= !(square < R(1e300));
  found->outside |= x.outside | y.outside | z.outside;
  found->stale |= !(sc_dot(way, way) <= p.stale_square);
}

/// Adds to the books of particle i what is not zero.
SC_FN void sc_store_books(sc_device_step p, size_t i, sc_sphere_motion s, sc_gathered walls, sc_gathered all,
                          sc_sphere_moved moved, int among_others, __global real4* losses, __global real4* works,
                          __global real4* impulses, __global real4* angulars, __global real4* drag_impulses) {
  if (all.loss_normal != R(0) || all.loss_sliding != R(0) || all.loss_rolling != R(0))
    losses[i] += (real4)(all.loss_normal, all.loss_sliding, all.loss_rolling, R(0));
  if (!among_others && !p.book_gravity) return;
  const sc_sphere_load load = sc_load_of(s.inverse_mass > R(0) ? walls : all);
  const sc_vec torque = sc_add_scaled(load.couple, s.radius, load.turn);
  const sc_booked b = sc_book(p.move, sc_centre_of_sphere(s), load.force, torque, moved.centre, p.book_gravity);
  angulars[i] += (real4)(b.angular.x, b.angular.y, b.angular.z, R(0));
  if (!among_others) return;
  if (SC_CHOSEN_COUPLED) {
    // What a fluid that is solved for does to a particle is one work, whatever part of it the pressure has.
    const sc_vec drag = moved.centre.drag_impulse;
    works[i] += (real4)(moved.centre.drag_work + moved.centre.body_work, R(0), moved.prescribed_work, R(0));
    drag_impulses[i] += (real4)(drag.x, drag.y, drag.z, p.move.kick);
  } else {
    works[i] += (real4)(moved.centre.drag_work, moved.centre.body_work, moved.prescribed_work, R(0));
  }
  impulses[i] += (real4)(b.impulse.x, b.impulse.y, b.impulse.z, R(0));
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

/// One step, number `step` of those that `poses` ([step][wall]) were sent for. Nothing happens if lists did not hold any more
/// after an earlier one, or if what acts in this one is lost.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_pass(
    const sc_device_step p, const int step, __global int* stale, __global const int* lost, __global const real4* motion,
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
  const int no_number = SC_CHOSEN_WATCHED ? lost[step] : 0;
  const int halted = (stale[step] | no_number) != 0;
  if (halted) {
    if (i == 0) stale[step + 1] = 1;
  }
  sc_found found;
  found.fastest_square = found.deepest = R(0);
  found.contacts = found.wall_contacts = found.impacts = found.unsound = found.outside = found.stale = 0;
  found.impact_speed = 0;
  if (!halted && i < (size_t)p.counts.particles && !SC_IS_GHOST(ghost, i)) {
    const sc_row own = sc_read_row(motion, spin, excess, material, i, motion[2 * i]);
    sc_gathered all_of = sc_meet_partners(p, i, own, motion, spin, excess, material, ghost, id, laws, counts[i],
                                          partners, slides, rolls, &found);
    sc_gathered of_walls = sc_nothing_gathered();
    const int free_body = own.speed.w > R(0);
    if (free_body && p.counts.faces > 0) {
      const sc_near_faces f = {i,     (size_t)p.counts.particles,   face_counts[i],
                               faces, poses + step * p.counts.walls, near_faces,
                               face_slides, face_rolls, gaps, corners};
      of_walls = sc_meet_walls(p, own, f, laws, works, &found);
      all_of.force = sc_add(all_of.force, of_walls.force);
      all_of.turn = sc_add(all_of.turn, of_walls.turn);
      all_of.couple = sc_add(all_of.couple, of_walls.couple);
      all_of.loss_normal += of_walls.loss_normal;
      all_of.loss_sliding += of_walls.loss_sliding;
      all_of.loss_rolling += of_walls.loss_rolling;
    }
    sc_sphere_motion s;
    s.position = sc_first(own.place);
    s.velocity = sc_first(own.speed);
    s.rim = sc_first(own.rim);
    s.radius = own.place.w;
    s.inverse_mass = own.speed.w;
    s.inverse_radius = own.rim.w;
    sc_move m = p.move;
    m.drag = SC_CHOSEN_DRAG;
    const sc_said said = {streams, pulls, befores};
    const sc_field field = SC_CHOSEN_FIELDS == SC_FIELDS_APART  ? fields[i]
                           : SC_CHOSEN_FIELDS == SC_FIELDS_HERE ? sc_field_at(p, sc_centre_of_sphere(s), said, i)
                                                                : sc_no_field();
    const sc_sphere_moved moved = sc_move_sphere(m, s, sc_load_of(all_of), field);
    const int among_others = SC_CHOSEN_FIELDS != SC_FIELDS_NONE || !free_body || of_walls.near;
    sc_store_books(p, i, s, of_walls, all_of, moved, among_others, losses, works, impulses, angulars, drag_impulses);
    sc_store(p, i, own, moved.motion, listed[i], images, motion_out, spin_out, &found);
  }
  // What all items of the group have found, joined two by two; no barrier is under a condition.
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
}
