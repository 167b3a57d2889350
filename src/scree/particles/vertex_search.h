// The vertices of a body that lie in another one or behind a plane, eight at a time: the search of the vertex method.
// Blocks of vertices whose sphere misses the other body's box are passed over. The bits are those of every instruction
// set: sums go lane by lane in the order of the blocks.
#pragma once

#include <type_traits>

#include "scree/particles/lanes.h"
#include "scree/particles/rows.h"
#include "scree/particles/sweep_view.h"
#include "scree/physics/shape/inside_outside.h"
#include "scree/physics/touch/shape_contact.h"
#include "scree/physics/touch/vertices.h"

namespace scree {
namespace {

/// The vertices found, in the frame of their body at bounding radius 1: sums of places and normals in eight lanes, and
/// which they are.
struct VertexHits {
  lane8 sum[6] = {};
  int count = 0, blocks = 0;
  std::int16_t block[most_vertex_blocks];
  std::uint8_t lanes[most_vertex_blocks];
};

/// The lanes of which a bit is set: the inverse of bits_of().
[[gnu::always_inline]] inline mask8 mask_of(unsigned bits) {
  const mask8 one = {1, 2, 4, 8, 16, 32, 64, 128};
  return (one & static_cast<std::int64_t>(bits)) != 0;
}

inline void note_block(const VertexView& of, int block, mask8 found, VertexHits& hits) {
  unsigned lanes = bits_of(found);
  if (block == of.blocks - 1) lanes &= of.last;
  if (lanes == 0) return;
  const mask8 counts = mask_of(lanes);
  const double* p = of.points + std::int64_t{48} * block;
  for (int k = 0; k < 6; ++k) hits.sum[k] += (lane8)((mask8)load8(p + 8 * k) & counts);
  hits.count += __builtin_popcount(lanes);
  hits.block[hits.blocks] = static_cast<std::int16_t>(block);
  hits.lanes[hits.blocks] = static_cast<std::uint8_t>(lanes);
  ++hits.blocks;
}

[[gnu::always_inline]] inline lane8 size_of(lane8 x) { return x < 0 ? -x : x; }

/// A body at bounding radius 1 as another one sees it, over the half axes of that: rows of the map, its centre, and how
/// much of each half axis its radius is.
struct VertexMap {
  double row[3][3], centre[3], spread[3];
};

inline VertexMap map_into(const sc_body_shape& of, const sc_body_shape& in, const sc_vec& branch) {
  const sc_mat turn = sc_turn_between(in.turn, of.turn);
  const sc_vec from = sc_turn_back(in.turn, branch);
  const double size = of.radius / in.radius, unit = -1 / in.radius;
  const sc_vec rows[3] = {turn.x, turn.y, turn.z};
  const double inverse[3] = {in.form.inverse_axes.x, in.form.inverse_axes.y, in.form.inverse_axes.z};
  const double place[3] = {from.x, from.y, from.z};
  VertexMap m;
  for (int k = 0; k < 3; ++k) {
    const double scale = size * inverse[k];
    m.row[k][0] = scale * rows[k].x;
    m.row[k][1] = scale * rows[k].y;
    m.row[k][2] = scale * rows[k].z;
    m.centre[k] = unit * inverse[k] * place[k];
    m.spread[k] = scale;
  }
  return m;
}

[[gnu::always_inline]] inline lane8 mapped(const VertexMap& m, int k, lane8 x, lane8 y, lane8 z) {
  return ((m.row[k][0] * x + m.row[k][1] * y) + m.row[k][2] * z) + m.centre[k];
}

/// Eight vertices of a block in the frame of the other body, over its half axes.
struct MappedBlock {
  lane8 x, y, z;
  mask8 in_box;
};

[[gnu::always_inline]] inline MappedBlock mapped_block(const VertexView& of, int block, const VertexMap& m) {
  const double* p = of.points + std::int64_t{48} * block;
  const lane8 px = load8(p), py = load8(p + 8), pz = load8(p + 16);
  const lane8 x = mapped(m, 0, px, py, pz), y = mapped(m, 1, px, py, pz), z = mapped(m, 2, px, py, pz);
  return {x, y, z, (size_of(x) <= 1) & (size_of(y) <= 1) & (size_of(z) <= 1)};
}

/// What stands for the inside-outside function where a body is no superellipsoid, at a point over the half axes.
inline double square_of_gauge(const sc_form& form, const sc_vec& x) {
  const double gauge = sc_gauge(form, 1, sc_make_vec(form.axes.x * x.x, form.axes.y * x.y, form.axes.z * x.z)).value;
  return gauge * gauge;
}

/// The inside-outside function at those in the box.
template <int Kind>
[[gnu::always_inline]] inline lane8 values_in_box(const MappedBlock& b, const sc_form& in) {
  alignas(64) double at[3][8], value[8];
  const lane8 none{};
  store8(at[0], b.in_box ? b.x : none);
  store8(at[1], b.in_box ? b.y : none);
  store8(at[2], b.in_box ? b.z : none);
  if constexpr (Kind == SC_GROWTH_OTHER) {
    for (int l = 0; l < 8; ++l) value[l] = square_of_gauge(in, sc_make_vec(at[0][l], at[1][l], at[2][l]));
  } else {
#pragma omp simd
    for (int l = 0; l < 8; ++l)
      value[l] = sc_inside_outside(sc_growth_exponents(Kind, in.gauge), sc_make_vec(at[0][l], at[1][l], at[2][l]));
  }
  return load8(value);
}

/// Eight vertices against the inside-outside function.
template <int Kind>
[[gnu::always_inline]] inline void search_block(const VertexView& of, int block, const VertexMap& m, const sc_form& in,
                                                VertexHits& hits) {
  const MappedBlock b = mapped_block(of, block, m);
  if (bits_of(b.in_box) == 0) return;
  note_block(of, block, b.in_box & (values_in_box<Kind>(b, in) <= 1), hits);
}

/// What can lie in another body, seen from a body at bounding radius 1: nothing that reaches less far along a
/// direction.
struct VertexCut {
  sc_vec along;
  double least;
};

/// The cut where a body begins, `begin` [m] along n (unit, in the world) from the centre of the other.
inline VertexCut cut_at(const sc_body_shape& body, const sc_vec& n, double begin) {
  return {sc_turn_back(body.turn, n), begin / body.radius - 1e-12};
}

[[gnu::always_inline]] inline lane8 along(const sc_vec& d, const double* p) {
  return (d.x * load8(p) + d.y * load8(p + 8)) + d.z * load8(p + 16);
}

template <int Kind>
[[gnu::noinline]] void search_kind(const VertexView& of, const VertexMap& m, const VertexCut& cut, const sc_form& in,
                                   VertexHits& hits) {
  for (int group = 0; group < of.blocks; group += 8) {
    const double* s = of.spheres + 4 * group;
    const lane8 px = load8(s), py = load8(s + 8), pz = load8(s + 16), radius = load8(s + 24);
    mask8 near = along(cut.along, s) + radius >= cut.least;
    if (bits_of(near) == 0) continue;
    near &= size_of(mapped(m, 0, px, py, pz)) <= 1 + m.spread[0] * radius;
    near &= size_of(mapped(m, 1, px, py, pz)) <= 1 + m.spread[1] * radius;
    near &= size_of(mapped(m, 2, px, py, pz)) <= 1 + m.spread[2] * radius;
    for (unsigned bits = bits_of(near); bits; bits &= bits - 1)
      search_block<Kind>(of, group + __builtin_ctz(bits), m, in, hits);
  }
}

/// Lets `act` have the kind of a body as a constant.
template <class Act>
[[gnu::always_inline]] inline auto with_kind(const sc_form& form, Act act) {
  const int kind = sc_growth_kind(form, form);
  if (kind == SC_GROWTH_OTHER) return act(std::integral_constant<int, SC_GROWTH_OTHER>{});
  if (kind == SC_GROWTH_22) return act(std::integral_constant<int, SC_GROWTH_22>{});
  if (kind == SC_GROWTH_44) return act(std::integral_constant<int, SC_GROWTH_44>{});
  if (kind == SC_GROWTH_82) return act(std::integral_constant<int, SC_GROWTH_82>{});
  if (kind == SC_GROWTH_88) return act(std::integral_constant<int, SC_GROWTH_88>{});
  return act(std::integral_constant<int, SC_GROWTH_GENERAL>{});
}

/// The vertices of a body that lie in another one, which its map and cut tell of.
inline void search_vertices(const VertexView& of, const VertexMap& m, const VertexCut& cut, const sc_form& in,
                            VertexHits& hits) {
  with_kind(in, [&](auto kind) { search_kind<kind>(of, m, cut, in, hits); });
}

[[gnu::always_inline]] inline lane8 larger(lane8 a, lane8 b) { return a > b ? a : b; }

/// How far points are from the box and the cut at least, over the bounding radius of their body; below 0 within both.
[[gnu::always_inline]] inline lane8 outside(const VertexMap& m, const VertexCut& cut, const double* p) {
  const lane8 x = load8(p), y = load8(p + 8), z = load8(p + 16);
  lane8 far = cut.least - along(cut.along, p);
  for (int k = 0; k < 3; ++k) far = larger(far, (size_of(mapped(m, k, x, y, z)) - 1) / m.spread[k]);
  return far;
}

[[gnu::always_inline]] inline double least_of(lane8 v) {
  double least = v[0];
  for (int l = 1; l < 8; ++l) least = SC_MIN(least, v[l]);
  return least;
}

/// How far the vertices of a block are from another body at least, over the bounding radius of their own. A gauge g
/// grows by 1 along no less than the radius of a ball in the body, here that in the octahedron between its poles, and
/// with F = g^n1 > 1, g - 1 > (1 - 1/F)/n1.
template <int Kind>
[[gnu::always_inline]] inline double block_distance(const VertexView& of, int block, const VertexMap& m,
                                                    const VertexCut& cut, const sc_form& in) {
  const double ball = 1 / SC_SQRT(m.spread[0] * m.spread[0] + m.spread[1] * m.spread[1] + m.spread[2] * m.spread[2]);
  const lane8 far = outside(m, cut, of.points + std::int64_t{48} * block);
  const MappedBlock b = mapped_block(of, block, m);
  if (bits_of(b.in_box) == 0) return least_of(far);
  const lane8 by_gauge = (1 - 1 / values_in_box<Kind>(b, in)) * (in.gauge.outer.inverse * ball);
  return least_of(b.in_box ? larger(far, by_gauge) : far);
}

/// How far the vertices of a body are from another one at least, over the bounding radius of their own. The block whose
/// sphere is nearest comes first; others are looked at if their spheres are nearer than what was found.
template <int Kind>
[[gnu::noinline]] double distance_by_kind(const VertexView& of, const VertexMap& m, const VertexCut& cut,
                                          const sc_form& in) {
  double far[most_vertex_blocks + 8];
  int nearest = 0;
  for (int group = 0; group < of.blocks; group += 8) {
    const double* s = of.spheres + 4 * group;
    store8(far + group, outside(m, cut, s) - load8(s + 24));
    for (int l = group; l < group + 8; ++l) nearest = far[l] < far[nearest] ? l : nearest;
  }
  double least = block_distance<Kind>(of, nearest, m, cut, in);
  for (int group = 0; group < of.blocks; group += 8)
    for (unsigned bits = bits_of(load8(far + group) < least); bits; bits &= bits - 1) {
      const int block = group + __builtin_ctz(bits);
      if (far[block] < least) least = SC_MIN(least, block_distance<Kind>(of, block, m, cut, in));
    }
  return least;
}

inline double vertices_distance(const VertexView& of, const VertexMap& m, const VertexCut& cut, const sc_form& in) {
  return with_kind(in, [&](auto kind) { return distance_by_kind<kind>(of, m, cut, in); });
}

/// The vertices behind the plane at a distance from the centre of a body along n (unit, in the world).
inline void search_behind(const VertexView& of, const sc_body_shape& body, const sc_vec& n, double distance,
                          VertexHits& hits) {
  const sc_vec d = sc_turn_back(body.turn, n);
  const double limit = distance / body.radius;
  for (int group = 0; group < of.blocks; group += 8) {
    const double* s = of.spheres + 4 * group;
    const lane8 depth = ((d.x * load8(s) + d.y * load8(s + 8)) + d.z * load8(s + 16)) + load8(s + 24);
    for (unsigned bits = bits_of(depth > limit); bits; bits &= bits - 1) {
      const int block = group + __builtin_ctz(bits);
      const double* p = of.points + std::int64_t{48} * block;
      note_block(of, block, (d.x * load8(p) + d.y * load8(p + 8)) + d.z * load8(p + 16) > limit, hits);
    }
  }
}

/// Means of what was found, in the world.
inline sc_vertices_within within(const sc_body_shape& body, const VertexHits& hits) {
  double sum[6];
  for (int k = 0; k < 6; ++k) {
    const lane8 s = hits.sum[k];
    sum[k] = ((s[0] + s[4]) + (s[1] + s[5])) + ((s[2] + s[6]) + (s[3] + s[7]));
  }
  const double share = hits.count > 0 ? 1.0 / hits.count : 0.0;
  sc_vertices_within out;
  out.place = sc_turn(body.turn, sc_scale(share * body.radius, vec_of(sum)));
  out.normal = sc_turn(body.turn, sc_scale(share, vec_of(sum + 3)));
  out.count = hits.count;
  return out;
}

/// How far those found reach from the centre of their body along n [m].
inline double reach_along(const VertexView& of, const sc_body_shape& body, const VertexHits& hits, const sc_vec& n) {
  const sc_vec d = sc_turn_back(body.turn, n);
  lane8 most = lane8{} - 1e300;
  for (int b = 0; b < hits.blocks; ++b) {
    const double* p = of.points + std::int64_t{48} * hits.block[b];
    const lane8 along = (d.x * load8(p) + d.y * load8(p + 8)) + d.z * load8(p + 16);
    most = (mask_of(hits.lanes[b]) & (along > most)) ? along : most;
  }
  double farthest = most[0];
  for (int l = 1; l < 8; ++l) farthest = SC_MAX(farthest, most[l]);
  return body.radius * farthest;
}

/// The contact that vertices of both bodies tell of.
inline sc_shape_touch touch_of_hits(const VertexView& of_first, const sc_body_shape& first, const VertexHits& of_a,
                                    const VertexView& of_second, const sc_body_shape& second, const VertexHits& of_b,
                                    const sc_vec& branch) {
  const sc_vertices_within a = within(first, of_a), b = within(second, of_b);
  const sc_vec normal = sc_normal_of_vertices(a, b);
  if (sc_dot(normal, normal) == 0) return sc_vertices_apart(branch, normal, 0);
  return sc_touch_of_vertices(a, b, branch, normal, reach_along(of_first, first, of_a, normal),
                              reach_along(of_second, second, of_b, sc_scale(-1, normal)));
}

/// How far a body reaches along n (unit, in the world) [m]: exactly, or by a bound from above that takes no powers.
inline double reach_of_body(const sc_body_shape& body, const sc_vec& n, bool exact) {
  return exact ? sc_support_in_world(body, n).value
               : sc_support_at_most(body.form, body.radius, sc_turn_back(body.turn, n));
}

/// How two bodies meet by their vertices: `first` is the body with the lower id. `parting` is a direction along which
/// they may be apart or overlap by little (unit, from the first to the second), or zero; it changes no answer: no
/// vertex of one lies in the other before that begins.
[[gnu::noinline, maybe_unused]] sc_shape_touch touch_by_vertices(const VertexView& of_first, const sc_body_shape& first,
                                                                 const VertexView& of_second,
                                                                 const sc_body_shape& second, const sc_vec& branch,
                                                                 const sc_vec& parting) {
  const bool known = sc_dot(parting, parting) > 0.5;
  const sc_vec n = known ? parting : sc_parting_direction(first, second, branch);
  const double along = sc_dot(n, branch), reach_a = reach_of_body(first, n, !known),
               reach_b = reach_of_body(second, n, !known);
  const double gap = along - reach_a - reach_b - 1e-12 * (first.radius + second.radius);
  if (gap > 0) return sc_vertices_apart(branch, n, gap);
  VertexHits of_a, of_b;
  const VertexMap map_a = map_into(first, second, branch);
  const VertexCut cut_a = cut_at(first, n, along - reach_b);
  search_vertices(of_first, map_a, cut_a, second.form, of_a);
  if (of_a.count == 0)
    return sc_vertices_apart(branch, n, first.radius * vertices_distance(of_first, map_a, cut_a, second.form));
  const VertexMap map_b = map_into(second, first, sc_scale(-1, branch));
  const VertexCut cut_b = cut_at(second, sc_scale(-1, n), along - reach_a);
  search_vertices(of_second, map_b, cut_b, first.form, of_b);
  if (of_b.count == 0)
    return sc_vertices_apart(branch, n, second.radius * vertices_distance(of_second, map_b, cut_b, first.form));
  return touch_of_hits(of_first, first, of_a, of_second, second, of_b, branch);
}

/// The contact of a body with the plane of an exact contact, by its vertices.
[[gnu::noinline, maybe_unused]] sc_body_gap gap_by_vertices(const VertexView& of, const sc_body_shape& body,
                                                            const sc_body_gap& exact) {
  VertexHits behind;
  search_behind(of, body, exact.normal, exact.support - exact.overlap, behind);
  const double reach = behind.count > 0 ? reach_along(of, body, behind, exact.normal) : 0;
  return sc_gap_of_vertices(exact, within(body, behind), reach);
}

}  // namespace
}  // namespace scree
