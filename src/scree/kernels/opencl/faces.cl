// The walls of one particle on a device: which of the faces near it count, and of a sphere what each of these does. The rules,
// and the order in which things are added up, are those of particles/sweep_walls.h.
#include "scree/physics/touch/sphere_wall.h"
#include "scree/physics/touch/wall_faces.h"

/// The faces listed for one particle, by rising number. What is kept of them lies slot by slot, [slot][particle].
typedef struct {
  size_t particle, particles;
  int count;
  __global const sc_wall* faces;
  __global const sc_wall_pose* poses;  // of all walls in this step
  __global uint* entries;              // number of the face, and contact_code()
  __global real4* slides;
  __global real4* rolls;
  __global real4* gaps;   // of this step: sc_wall_gap::normal and distance
  __global int* corners;  // of this step: sc_wall_gap::corners, and SC_FACE_DROPPED
  // Of a particle that is no sphere: what a contact remembers besides (anchor, distance | arm, radius: sc_wall_memory); and of
  // this step (arm, growth | where the scaled body touches, overlap | support, plain: sc_body_gap).
  int is_body;
  __global real4* shapes;
  __global real4* places;
} sc_near_faces;

SC_FN size_t sc_face_slot(sc_near_faces f, int k) { return (size_t)k * f.particles + f.particle; }

SC_FN sc_wall sc_face_at(sc_near_faces f, size_t slot) { return f.faces[f.entries[slot] & SC_PARTNER]; }

SC_FN sc_wall_gap sc_gap_at(sc_near_faces f, size_t slot) {
  const real4 row = f.gaps[slot];
  sc_wall_gap gap;
  gap.normal = sc_first(row);
  gap.distance = row.w;
  gap.corners = f.corners[slot];
  return gap;
}

/// Leaves the contact without a memory.
SC_FN void sc_forget(sc_near_faces f, size_t slot) { f.entries[slot] &= SC_PARTNER; }

/// How far away a face is: the way to it, or how far a body has to grow.
SC_FN real sc_face_away(sc_near_faces f, size_t slot) {
  if (!SC_SHAPED || !f.is_body) return f.gaps[slot].w;
  return f.corners[slot] == SC_FACE_DROPPED ? R(1e300) : f.places[3 * slot].w;
}

/// Where the nearest point of a face is, from the centre.
SC_FN sc_vec sc_face_point(sc_near_faces f, size_t slot) {
  const sc_wall_gap gap = sc_gap_at(f, slot);
  return SC_SHAPED && f.is_body ? sc_first(f.places[3 * slot + 1]) : sc_scale(gap.distance, gap.normal);
}

/// Whether slot k counts, like counts() in particles/sweep_walls.h.
SC_FN int sc_face_counts(sc_near_faces f, int k, real radius) {
  const size_t w = sc_face_slot(f, k);
  const sc_wall face = sc_face_at(f, w);
  const int corners = f.corners[w];
  const real away = sc_face_away(f, w);
  for (int l = 0; l < f.count; ++l) {
    const size_t u = sc_face_slot(f, l);
    const sc_wall other = sc_face_at(f, u);
    if ((f.entries[u] & SC_PARTNER) == (f.entries[w] & SC_PARTNER) || other.body != face.body) continue;
    if (sc_gives_way(corners, away, sc_face_away(f, u)) && sc_wall_has_corners(other, face, corners)) return 0;
    if (l > k || (f.corners[u] & SC_FACE_DROPPED)) continue;
    if (sc_is_one_place(sc_sub(sc_face_point(f, u), sc_face_point(f, w)), radius)) return 0;
  }
  return 1;
}

/// A particle that has gone over an edge takes the memory of the face it leaves to the face in slot k, which it enters.
SC_FN void sc_take_over(sc_near_faces f, int k) {
  const size_t w = sc_face_slot(f, k);
  const sc_wall face = sc_face_at(f, w);
  for (int l = 0; l < f.count; ++l) {
    const size_t u = sc_face_slot(f, l);
    const uint entry = f.entries[u];
    const sc_wall other = sc_face_at(f, u);
    if (!(f.corners[u] & SC_FACE_DROPPED) || entry >> SC_CODE_SHIFT == 0u || other.body != face.body) continue;
    if (!sc_wall_meet(other, face)) continue;
    f.entries[w] = (f.entries[w] & SC_PARTNER) | (entry & ~SC_PARTNER);
    f.slides[w] = f.slides[u];
    if (SC_ROLLS) f.rolls[w] = f.rolls[u];
    if (SC_SHAPED && f.is_body) sc_copy_shape_memory(f.shapes, u, w);
    sc_forget(f, u);
    return;
  }
}

/// Whether a face is near enough to count. A place of a body where there is no gap is none.
SC_FN int sc_is_near(sc_near_faces f, size_t slot, real reach) {
  if (SC_SHAPED && f.is_body) return f.corners[slot] != SC_FACE_DROPPED;
  return f.entries[slot] >> SC_CODE_SHIFT != 0u || reach > f.gaps[slot].w;
}

/// What does not count keeps no memory.
SC_FN void sc_forget_dropped(sc_near_faces f) {
  for (int k = 0; k < f.count; ++k) {
    const size_t w = sc_face_slot(f, k);
    if (f.corners[w] & SC_FACE_DROPPED) sc_forget(f, w);
  }
}

/// Marks the faces that do not count, of those nearer than `reach` to the centre, and hands their memory on.
SC_FN void sc_drop_faces(sc_near_faces f, real radius, real reach) {
  for (int k = 0; k < f.count; ++k) {
    const size_t w = sc_face_slot(f, k);
    if (sc_is_near(f, w, reach) && !sc_face_counts(f, k, radius)) f.corners[w] |= SC_FACE_DROPPED;
  }
  for (int k = 0; k < f.count; ++k) {
    const size_t w = sc_face_slot(f, k);
    const int bare = !(f.corners[w] & SC_FACE_DROPPED) && f.entries[w] >> SC_CODE_SHIFT == 0u;
    if (bare && sc_is_near(f, w, reach)) sc_take_over(f, k);
  }
  sc_forget_dropped(f);
}

/// Finds the way to every face; marks those that do not count.
SC_FN void sc_find_gaps(sc_near_faces f, sc_sphere_wall s, real margin) {
  int joined = 0;
  for (int k = 0; k < f.count; ++k) {
    const size_t w = sc_face_slot(f, k);
    const sc_wall face = sc_face_at(f, w);
    const sc_wall_gap gap = sc_gap_to_wall(face, f.poses[face.body], s.position);
    f.gaps[w] = (real4)(gap.normal.x, gap.normal.y, gap.normal.z, gap.distance);
    f.corners[w] = gap.corners;
    joined |= face.corner[0] >= 0;
  }
  if (joined) sc_drop_faces(f, s.radius, s.radius + margin);
}

SC_FN sc_sphere_wall sc_sphere_at_wall(sc_row own) {
  sc_sphere_wall s;
  s.position = sc_first(own.place);
  s.velocity = sc_first(own.speed);
  s.rim_speed = sc_first(own.rim);
  s.spin = sc_scale(own.rim.w, s.rim_speed);
  s.radius = own.place.w;
  s.inverse_mass = own.speed.w;
  s.excess = own.excess;
  return s;
}

/// Energy that a contact holds [J].
SC_FN real sc_held(sc_pair_law law, sc_touch touch, sc_contact_state state) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const sc_contact_energy e = sc_contact_energy_of(chosen, law, touch, state);
  return e.elastic + e.cohesive;
}

/// What a contact with a moving wall brings in [J]; `arm` leads from the pivot of the wall to the contact.
SC_FN real sc_wall_work(sc_device_step p, sc_wall_pose pose, sc_vec arm, sc_vec normal, sc_contact_action a) {
  const sc_vec force = sc_add(a.normal_force, a.tangential_force);
  const sc_vec speed = sc_wall_speed(pose, pose.velocity_now, pose.spin_now, arm, normal);
  return p.move.kick * (sc_dot(force, speed) + sc_dot(a.couple, pose.spin_now));
}

/// What the contact in a slot remembers.
SC_FN sc_contact_state sc_state_at(sc_near_faces f, size_t slot) {
  const uint code = f.entries[slot] >> SC_CODE_SHIFT;
  const real4 slide = code ? f.slides[slot] : (real4)(R(0));
  const real4 roll = SC_ROLLS && code ? f.rolls[slot] : (real4)(R(0));
  return sc_state_from(code, slide, roll);
}

/// Keeps what a contact remembers, if it still touches.
SC_FN void sc_keep_contact(sc_near_faces f, size_t slot, sc_contact_result r, sc_found* found) {
  const int acts = r.action.touching != 0;
  f.entries[slot] = (f.entries[slot] & SC_PARTNER) | (sc_contact_code(acts, r.state.slid) << SC_CODE_SHIFT);
  if (acts) f.slides[slot] = sc_slide_row(r.state);
  if (SC_ROLLS && acts) f.rolls[slot] = sc_roll_row(r.state);
  found->contacts += acts;
  found->wall_contacts += acts;
}

/// The contacts of a sphere with walls; `works` are all particles' books, of which walls have the fourth number.
SC_FN sc_gathered sc_meet_walls(sc_device_step p, sc_row own, sc_near_faces f, __global const sc_pair_law* laws,
                                __global real4* works, sc_found* found) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const sc_sphere_wall s = sc_sphere_at_wall(own);
  sc_gathered g = sc_nothing_gathered();
  sc_find_gaps(f, s, p.margin);
  for (int k = 0; k < f.count; ++k) {
    const size_t slot = sc_face_slot(f, k);
    const sc_wall_gap gap = sc_gap_at(f, slot);
    if (gap.corners & SC_FACE_DROPPED) continue;
    const sc_wall face = sc_face_at(f, slot);
    const sc_wall_pose pose = f.poses[face.body];
    const sc_sphere_touch t = sc_touch_wall_at(s, pose, gap);
    const int code = f.entries[slot] >> SC_CODE_SHIFT != 0u;
    if (t.touch.overlap + p.margin <= R(0) && !code) continue;
    g.near = 1;
    const sc_contact_state before = sc_state_at(f, slot);
    const sc_pair_law law = laws[own.material * p.counts.materials + face.material];
    if (!pose.present) {
      // A wall that is taken away takes along what its contacts hold.
      if (code) works[f.particle].w -= sc_held(law, t.touch, before);
      sc_forget(f, slot);
      continue;
    }
    const sc_contact_result r = sc_contact_act(chosen, law, t.touch, p.time, before);
    g = sc_gather(g, t, r.action, R(1));
    if (pose.moves)
      works[f.particle].w += sc_wall_work(p, pose, sc_wall_arm(pose, s.position, gap), gap.normal, r.action);
    // One that is put there brings along what its contacts hold at once.
    if (r.action.touching && pose.changed) works[f.particle].w += sc_held(law, t.touch, r.state);
    found->deepest = SC_MAX(found->deepest, t.touch.overlap / s.radius);
    sc_keep_contact(f, slot, r, found);
  }
  return g;
}
