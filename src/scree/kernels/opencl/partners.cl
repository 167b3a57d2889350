// The contacts of one sphere with others on a device, from its own side.

/// What contacts between particles depend on in a step.
typedef struct {
  sc_space space;
  sc_contact_time time;
  size_t particles;
  int materials;
  real margin;         // how far apart bodies may be and still act on each other
  real speed_quantum;  // SC_SPEED_QUANTUM
} sc_meeting;

SC_FN sc_row sc_read_row(sc_state state, size_t i, sc_place place) {
  sc_row r;
  r.place = place;
  r.speed = sc_speed_at(state, i);
  r.rim = state.spin[i];
  r.excess = SC_CHOSEN_COHESION != SC_COHESION_NONE ? state.excess[i] : R(0);
  r.material = state.material[i];
  return r;
}

/// How a particle meets a partner, from its own side.
SC_FN sc_sphere_touch sc_touch_rows(sc_space space, sc_row a, sc_row b, sc_vec branch) {
  sc_sphere_pair p;
  p.branch = branch;
  p.radii = a.place.w + b.place.w;
  p.velocity = sc_sub(sc_first(a.speed), sc_first(b.speed));
  p.inverse_mass = a.speed.w + b.speed.w;
  p.rim_speed = sc_add(sc_first(a.rim), sc_first(b.rim));
  p.inverse_radius = a.rim.w + b.rim.w;
  p.excess = a.excess + b.excess;
  p.spin = SC_ROLLS ? sc_sub(sc_scale(a.rim.w, sc_first(a.rim)), sc_scale(b.rim.w, sc_first(b.rim))) : sc_zero_vec();
  return sc_refine(space, a.place, b.place, p);
}

/// The contacts of particle i with others.
SC_FN sc_gathered sc_meet_partners(sc_meeting m, size_t i, sc_row own, sc_state state, __global const sc_pair_law* laws,
                                   int count, __global uint* partners, __global real4* slides, __global real4* rolls,
                                   sc_found* found) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  sc_gathered g = sc_nothing_gathered();
  for (int k = 0; k < count; ++k) {
    const size_t slot = (size_t)k * m.particles + i;
    const uint entry = partners[slot], code = entry >> SC_CODE_SHIFT;
    const size_t j = entry & SC_PARTNER;
    const sc_place there = sc_place_at(m.space, state, j);
    const sc_vec branch = sc_branch(m.space, own.place, there);
    // A contact that acted is looked at once more when it has parted: the break of a bond costs energy.
    if (!sc_is_within(branch, own.place.w + there.w + m.margin) && code == 0u) continue;
    const sc_row other = sc_read_row(state, j, there);
    const sc_sphere_touch t = sc_touch_rows(m.space, own, other, branch);
    const real4 slide = code ? slides[slot] : (real4)(R(0));
    const real4 roll = SC_ROLLS && code ? rolls[slot] : (real4)(R(0));
    const sc_pair_law law = laws[own.material * m.materials + other.material];
    const sc_contact_result r = sc_contact_act(chosen, law, t.touch, m.time, sc_state_from(code, slide, roll));
    g = sc_gather(g, t, r.action, R(0.5));
    const int acts = r.action.touching != 0;
    const uint now = sc_contact_code(acts, r.state.slid);
    if (now != code) partners[slot] = (entry & SC_PARTNER) | (now << SC_CODE_SHIFT);
    if (acts) slides[slot] = sc_slide_row(r.state);
    if (SC_ROLLS && acts) rolls[slot] = sc_roll_row(r.state);
    const real depth = t.touch.overlap * SC_MAX(own.rim.w, other.rim.w);
    found->deepest = SC_MAX(found->deepest, depth);
    if (!acts || !sc_counts_pair(state, i, j)) continue;
    ++found->contacts;
    if (code) continue;
    ++found->impacts;
    found->impact_speed += (sc_count)(sc_dot(t.touch.velocity, t.touch.normal) / m.speed_quantum);
  }
  return g;
}
