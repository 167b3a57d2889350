// The walls of one body that is no sphere on a device. The rules, and the order in which things are added up, are those of
// particles/sweep_shape_walls.h.
#include "scree/kernels/meet_shapes.h"
#include "scree/kernels/meet_wall.h"

/// A body among walls.
typedef struct {
  sc_body_at_walls at;
  real by_volume;  // radius [m]
  real inscribed;  // radius of a sphere inside [m]
  int material;
} sc_wall_visitor;

SC_FN void sc_note_place(sc_near_faces f, size_t slot, sc_body_gap gap) {
  const sc_vec touching = sc_touching_point(gap);
  f.gaps[slot] = (real4)(gap.normal.x, gap.normal.y, gap.normal.z, gap.support - gap.overlap);
  f.corners[slot] = gap.corners;
  f.places[3 * slot] = (real4)(gap.arm.x, gap.arm.y, gap.arm.z, gap.growth);
  f.places[3 * slot + 1] = (real4)(touching.x, touching.y, touching.z, gap.overlap);
  f.places[3 * slot + 2] = (real4)(gap.support, gap.plain ? R(1) : R(0), R(0), R(0));
}

SC_FN sc_body_gap sc_noted_place(sc_near_faces f, size_t slot) {
  const real4 arm = f.places[3 * slot], support = f.places[3 * slot + 2];
  sc_body_gap gap;
  gap.arm = sc_first(arm);
  gap.growth = arm.w;
  gap.normal = sc_first(f.gaps[slot]);
  gap.overlap = f.places[3 * slot + 1].w;
  gap.support = support.x;
  gap.plain = support.y != R(0);
  gap.corners = f.corners[slot];
  return gap;
}

/// The memory of one place of a face, aside.
typedef struct {
  uint code;
  real4 slide, roll, shape[2];
} sc_place_memory;

SC_FN sc_place_memory sc_take_place_memory(sc_near_faces f, size_t slot) {
  sc_place_memory m;
  m.code = f.entries[slot] & ~SC_PARTNER;
  m.slide = f.slides[slot];
  m.roll = SC_ROLLS ? f.rolls[slot] : (real4)(R(0));
  m.shape[0] = f.shapes[2 * slot];
  m.shape[1] = f.shapes[2 * slot + 1];
  sc_forget(f, slot);
  return m;
}

SC_FN void sc_put_place_memory(sc_near_faces f, size_t slot, sc_place_memory m) {
  f.entries[slot] |= m.code;
  f.slides[slot] = m.slide;
  if (SC_ROLLS) f.rolls[slot] = m.roll;
  f.shapes[2 * slot] = m.shape[0];
  f.shapes[2 * slot + 1] = m.shape[1];
}

/// Gives the memories of the places of one face, from slot k on, to the gaps that are there now.
SC_FN void sc_match_memories(sc_near_faces f, int k, sc_vec centre, const sc_body_gap* gaps, int count) {
  const sc_wall_pose pose = f.poses[sc_face_at(f, sc_face_slot(f, k)).body];
  sc_place_memory old[SC_FRUSTUM_GAPS];
  sc_vec was[SC_FRUSTUM_GAPS], at[SC_FRUSTUM_GAPS];
  int memories = 0, to[SC_FRUSTUM_GAPS];
  for (int l = 0; l < SC_FRUSTUM_GAPS; ++l) {
    const size_t slot = sc_face_slot(f, k + l);
    if (l < count) at[l] = sc_from_wall(pose, sc_add(centre, gaps[l].arm));
    if (f.entries[slot] >> SC_CODE_SHIFT == 0u) continue;
    was[memories] = sc_first(f.shapes[2 * slot]);
    old[memories++] = sc_take_place_memory(f, slot);
  }
  sc_match_places(at, count, was, memories, to);
  for (int m = 0; m < memories; ++m)
    if (to[m] >= 0) sc_put_place_memory(f, sc_face_slot(f, k + to[m]), old[m]);
}

/// Finds how the body meets the face that has the slots from k on; returns how many they are.
SC_FN int sc_find_places(sc_device_step p, sc_wall_visitor v, sc_near_faces f, int k, __global const sc_pair_law* laws) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const sc_wall face = sc_face_at(f, sc_face_slot(f, k));
  const sc_wall_pose pose = f.poses[face.body];
  const int places = sc_wall_places(face.kind);
  const sc_body_shape body = v.at.shape;
  int near = body.radius + p.margin > sc_gap_to_wall(face, pose, v.at.centre).distance;
  for (int l = 0; l < places; ++l) near |= f.entries[sc_face_slot(f, k + l)] >> SC_CODE_SHIFT != 0u;
  sc_body_gap gaps[SC_FRUSTUM_GAPS];
  int count = 0;
  if (near) {
    const sc_pair_law law = laws[v.material * p.counts.materials + face.material];
    const real reach = sc_reach_at_wall(chosen, law, body, v.by_volume, v.at.excess);
    count = sc_body_to_wall(face, pose, body, v.at.centre, reach, gaps);
    if (places > 1) sc_match_memories(f, k, v.at.centre, gaps, count);
  }
  for (int l = 0; l < places; ++l) {
    const size_t slot = sc_face_slot(f, k + l);
    if (l < count)
      sc_note_place(f, slot, gaps[l]);
    else
      f.corners[slot] = SC_FACE_DROPPED;
  }
  return places;
}

/// Finds the places where the body may touch its walls; marks those that do not count.
SC_FN void sc_find_all_places(sc_device_step p, sc_wall_visitor v, sc_near_faces f, __global const sc_pair_law* laws) {
  int joined = 0;
  for (int k = 0; k < f.count;) {
    joined |= sc_face_at(f, sc_face_slot(f, k)).corner[0] >= 0;
    k += sc_find_places(p, v, f, k, laws);
  }
  if (joined) sc_drop_faces(f, v.at.shape.radius, R(0));
  // Two places of a round wall may also have become one.
  sc_forget_dropped(f);
}

/// Remembers where a contact is: on the wall, and from the centre of the body.
SC_FN void sc_keep_place(sc_near_faces f, size_t slot, sc_wall_pose pose, sc_wall_meeting m, real reach) {
  const sc_vec anchor = sc_from_wall(pose, m.at), arm = m.place.arm_a;
  f.shapes[2 * slot] = (real4)(anchor.x, anchor.y, anchor.z, reach);
  f.shapes[2 * slot + 1] = (real4)(arm.x, arm.y, arm.z, m.place.radius);
}

SC_FN sc_wall_memory sc_wall_memory_at(sc_near_faces f, size_t slot) {
  const real4 anchor = f.shapes[2 * slot];
  sc_wall_memory m;
  m.anchor = sc_first(anchor);
  m.reach = anchor.w;
  m.radius = f.shapes[2 * slot + 1].w;
  return m;
}

/// The contacts of a body with walls: force, and torque in place of the turn.
SC_FN sc_gathered sc_meet_walls_as_body(sc_device_step p, sc_wall_visitor v, sc_near_faces f,
                                        __global const sc_pair_law* laws, __global real4* works, sc_found* found) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  sc_gathered g = sc_nothing_gathered();
  sc_find_all_places(p, v, f, laws);
  for (int k = 0; k < f.count; ++k) {
    const size_t slot = sc_face_slot(f, k);
    if (f.corners[slot] & SC_FACE_DROPPED) continue;
    const sc_body_gap gap = sc_noted_place(f, slot);
    const int acted = f.entries[slot] >> SC_CODE_SHIFT != 0u;
    if (gap.overlap + p.margin <= R(0) && !acted) continue;
    g.near = 1;
    const sc_wall face = sc_face_at(f, slot);
    const sc_wall_pose pose = f.poses[face.body];
    const sc_wall_memory memory = sc_wall_remembers(acted, sc_wall_memory_at(f, slot), v.at.shape, gap, v.by_volume);
    const sc_pair_law law = laws[v.material * p.counts.materials + face.material];
    const sc_wall_meeting m = sc_meet_wall(v.at, pose, gap, memory, law);
    const sc_contact_state before = sc_state_at(f, slot);
    if (!pose.present) {
      // A wall that is taken away takes along what its contacts hold.
      if (acted) works[f.particle].w -= sc_held(m.law, m.touch, before);
      sc_forget(f, slot);
      continue;
    }
    const sc_contact_result r = sc_contact_act(chosen, m.law, m.touch, p.time, before);
    const sc_shape_loads loads = sc_loads_of(m.place, r.action);
    g.force = sc_add(g.force, loads.force);
    g.turn = sc_add(g.turn, loads.torque_a);
    g.loss_normal += r.action.loss_normal;
    g.loss_sliding += r.action.loss_sliding;
    g.loss_rolling += r.action.loss_rolling;
    if (pose.moves) works[f.particle].w += sc_wall_work(p, pose, m.arm, gap.normal, r.action);
    // One that is put there brings along what its contacts hold at once.
    if (r.action.touching && pose.changed) works[f.particle].w += sc_held(m.law, m.touch, r.state);
    found->deepest = SC_MAX(found->deepest, m.place.overlap / v.inscribed);
    sc_keep_contact(f, slot, r, found);
    if (r.action.touching) sc_keep_place(f, slot, pose, m, memory.reach);
  }
  return g;
}

/// The contacts of a sphere with walls, in the same way.
SC_FN sc_gathered sc_meet_walls_as_sphere(sc_device_step p, sc_row own, sc_near_faces f, __global const sc_pair_law* laws,
                                          __global real4* works, sc_found* found) {
  sc_gathered g = sc_meet_walls(p, own, f, laws, works, found);
  g.turn = sc_add(sc_scale(own.place.w, g.turn), g.couple);
  return g;
}
