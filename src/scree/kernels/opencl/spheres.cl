// Spheres on a device. A work item is one particle: it evaluates its contacts with all partners from its own side, in the
// order of their ids, then those with walls, and moves. Exchanging the partners changes signs and no magnitudes, so that the
// two sides of a pair get the same bits, and a particle the same as from the CPU's slots.
//
// The state is read from one set of buffers and written to another, so that nobody sees a partner that has moved. When lists
// no longer hold, the steps that were given ahead do nothing; the host makes lists and gives them again.
#include "scree/kernels/books.h"
#include "scree/kernels/wrap.h"
#include "scree/physics/flow/shear.h"
#include "scree/physics/flow/taylor_green.h"

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

SC_FN sc_vec sc_flow_at(sc_flow f, sc_vec x) {
  if (f.kind == SC_FLOW_UNIFORM) return f.stream;
  if (f.kind == SC_FLOW_TAYLOR_GREEN) return sc_taylor_green(x, f.amplitude, f.wavenumber);
  if (f.kind == SC_FLOW_SHEAR) return sc_shear_flow(x, f.shear_rate, f.shear_origin);
  return sc_zero_vec();
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
  const real square = sc_dot(q.velocity, q.velocity);
  const sc_vec way = sc_branch(p.box, listed, place);
  found->fastest_square = SC_MAX(found->fastest_square, square);
  found->unsound |= !(square < R(1e300));
  found->outside |= x.outside | y.outside | z.outside;
  found->stale |= !(sc_dot(way, way) <= p.stale_square);
}

SC_FN void sc_store_losses(size_t i, sc_gathered all, __global real4* losses) {
  if (all.loss_normal != R(0) || all.loss_sliding != R(0) || all.loss_rolling != R(0))
    losses[i] += (real4)(all.loss_normal, all.loss_sliding, all.loss_rolling, R(0));
}

/// Adds to the books of particle i what is not zero: of a force and a torque as sc_book() takes them, and of fields.
SC_FN void sc_store_books(sc_device_step p, size_t i, sc_centre before, sc_vec force, sc_vec torque, sc_centre_moved moved,
                          real prescribed_work, int among_others, __global real4* works, __global real4* impulses,
                          __global real4* angulars) {
  if (!among_others && !p.book_gravity) return;
  const sc_booked b = sc_book(p.move, before, force, torque, moved, p.book_gravity);
  angulars[i] += (real4)(b.angular.x, b.angular.y, b.angular.z, R(0));
  if (!among_others) return;
  works[i] += (real4)(moved.drag_work, moved.body_work, prescribed_work, R(0));
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

SC_FN sc_found sc_nothing_found(void) {
  sc_found f;
  f.fastest_square = f.deepest = R(0);
  f.contacts = f.wall_contacts = f.impacts = f.unsound = f.outside = f.stale = 0;
  f.impact_speed = 0;
  return f;
}

/// Joins what all items of a group have found, two by two, and adds it to what the group found before, unless the step was
/// not done. What must not go on sets the flag of the next step. No barrier is under a condition.
SC_FN void sc_note_found(sc_device_step p, int halted, sc_found found, __local sc_found* all, __global sc_findings* findings,
                         __global int* stale_after) {
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
    if (sum.stale || sum.unsound || sum.outside || sum.deepest > p.max_overlap) *stale_after = 1;
  }
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

/// The law of motion for what a particle may meet: no fluid without fields.
SC_FN sc_move sc_move_at(sc_device_step p) {
  sc_move m = p.move;
  if (!p.fields) m.drag = SC_DRAG_NONE;
  return m;
}

/// What acts on a particle at its place.
SC_FN sc_field sc_field_at(sc_device_step p, sc_vec position) {
  sc_field field = sc_no_field();
  if (p.fields) field.fluid = sc_flow_at(p.flow, position);
  return field;
}

#if !SC_SHAPED
/// One step, number `step` of those that `poses` ([step][wall]) were sent for. Nothing happens if lists did not hold any more
/// after an earlier one.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_pass(
    const sc_device_step p, const int step, __global int* stale, __global const real4* motion, __global const real4* spin,
    __global real4* motion_out, __global real4* spin_out, __global const real* excess, __global const int* material,
    __global const int* ghost, __global const long* id, __global const real4* listed, __global const sc_pair_law* laws, __global const int* counts, __global uint* partners,
    __global real4* slides, __global real4* rolls, __global const sc_wall* faces, __global const sc_wall_pose* poses,
    __global const int* face_counts, __global uint* near_faces, __global real4* face_slides, __global real4* face_rolls,
    __global real4* gaps, __global int* corners, __global int4* images,
    __global real4* losses, __global real4* works, __global real4* impulses, __global real4* angulars,
    __global sc_findings* findings) {
  __local sc_found all[SC_GROUP];
  const size_t i = get_global_id(0);
  const int halted = stale[step] != 0;
  if (halted) {
    if (i == 0) stale[step + 1] = 1;
  }
  sc_found found = sc_nothing_found();
  if (!halted && i < (size_t)p.counts.particles && SC_IS_OWN(ghost, i)) {
    const sc_row own = sc_read_row(motion, spin, excess, material, i, motion[2 * i]);
    sc_gathered all_of = sc_meet_partners(p, i, own, motion, spin, excess, material, ghost, id, laws, counts[i],
                                          partners, slides, rolls, &found);
    sc_gathered of_walls = sc_nothing_gathered();
    const int free_body = own.speed.w > R(0);
    if (free_body && p.counts.faces > 0) {
      const sc_near_faces f = {i,     (size_t)p.counts.particles,   face_counts[i],
                               faces, poses + step * p.counts.walls, near_faces,
                               face_slides, face_rolls, gaps, corners, 0, 0, 0};
      of_walls = sc_meet_walls(p, own, f, laws, works, &found);
      all_of = sc_gather_walls(all_of, of_walls);
    }
    const sc_sphere_motion s = sc_sphere_at(own);
    const sc_sphere_moved moved = sc_move_sphere(sc_move_at(p), s, sc_load_of(all_of), sc_field_at(p, s.position));
    const sc_gathered push = free_body ? of_walls : all_of;
    const int among_others = p.fields || !free_body || of_walls.near;
    sc_store_losses(i, all_of, losses);
    sc_store_books(p, i, sc_centre_of_sphere(s), push.force, sc_add_scaled(push.couple, s.radius, push.turn), moved.centre,
                   moved.prescribed_work, among_others, works, impulses, angulars);
    sc_store_centre(p, i, own, moved.centre, listed[i], images, motion_out, &found);
    const sc_vec rim = moved.motion.rim;
    spin_out[i] = (real4)(rim.x, rim.y, rim.z, own.rim.w);
  }
  sc_note_found(p, halted, found, all, findings, stale + step + 1);
}
#endif
