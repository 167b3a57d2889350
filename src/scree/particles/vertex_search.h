// The vertices of a body that lie in another one or behind a plane, eight at a time: the search of the vertex method.
// Blocks of vertices whose sphere misses the other body's box are passed over. The bits are those of every instruction
// set: sums go lane by lane in the order of the blocks.
#pragma once

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

/// Eight vertices against the inside-outside function.
template <int Kind>
[[gnu::always_inline]] inline void search_block(const VertexView& of, int block, const VertexMap& m,
                                                const sc_exponents& e, VertexHits& hits) {
  const double* p = of.points + std::int64_t{48} * block;
  const lane8 px = load8(p), py = load8(p + 8), pz = load8(p + 16);
  const lane8 x = mapped(m, 0, px, py, pz), y = mapped(m, 1, px, py, pz), z = mapped(m, 2, px, py, pz);
  const mask8 in_box = (size_of(x) <= 1) & (size_of(y) <= 1) & (size_of(z) <= 1);
  if (bits_of(in_box) == 0) return;
  alignas(64) double at[3][8], value[8];
  const lane8 none{};
  store8(at[0], in_box ? x : none);
  store8(at[1], in_box ? y : none);
  store8(at[2], in_box ? z : none);
#pragma omp simd
  for (int l = 0; l < 8; ++l)
    value[l] = sc_inside_outside(sc_growth_exponents(Kind, e), sc_make_vec(at[0][l], at[1][l], at[2][l]));
  note_block(of, block, in_box & (load8(value) <= 1), hits);
}

template <int Kind>
[[gnu::noinline]] void search_kind(const VertexView& of, const VertexMap& m, const sc_exponents& e, VertexHits& hits) {
  for (int group = 0; group < of.blocks; group += 8) {
    const double* s = of.spheres + 4 * group;
    const lane8 px = load8(s), py = load8(s + 8), pz = load8(s + 16), radius = load8(s + 24);
    mask8 near = size_of(mapped(m, 0, px, py, pz)) <= 1 + m.spread[0] * radius;
    near &= size_of(mapped(m, 1, px, py, pz)) <= 1 + m.spread[1] * radius;
    near &= size_of(mapped(m, 2, px, py, pz)) <= 1 + m.spread[2] * radius;
    for (unsigned bits = bits_of(near); bits; bits &= bits - 1)
      search_block<Kind>(of, group + __builtin_ctz(bits), m, e, hits);
  }
}

/// The vertices of a body that lie in another one, whose centre is `branch` away [m].
inline void search_vertices(const VertexView& of, const sc_body_shape& body, const sc_body_shape& in,
                            const sc_vec& branch, VertexHits& hits) {
  const VertexMap m = map_into(body, in, branch);
  const sc_exponents& e = in.form.gauge;
  const int kind = sc_growth_kind(e, e);
  if (kind == SC_GROWTH_22) return search_kind<SC_GROWTH_22>(of, m, e, hits);
  if (kind == SC_GROWTH_44) return search_kind<SC_GROWTH_44>(of, m, e, hits);
  if (kind == SC_GROWTH_82) return search_kind<SC_GROWTH_82>(of, m, e, hits);
  if (kind == SC_GROWTH_88) return search_kind<SC_GROWTH_88>(of, m, e, hits);
  search_kind<SC_GROWTH_GENERAL>(of, m, e, hits);
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
  double sum[6] = {};
  for (int k = 0; k < 6; ++k)
    for (int l = 0; l < 8; ++l) sum[k] += hits.sum[k][l];
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

/// How two bodies meet by their vertices: `first` is the body with the lower id. Bodies that did not touch before are
/// first looked at for a plane between them, which changes no answer: no vertex lies beyond it.
[[gnu::noinline, maybe_unused]] sc_shape_touch touch_by_vertices(const VertexView& of_first, const sc_body_shape& first,
                                                                 const VertexView& of_second,
                                                                 const sc_body_shape& second, const sc_vec& branch,
                                                                 bool acted) {
  sc_vec direction = sc_parting_direction(first, second, branch);
  if (!acted) {
    const double gap = sc_shapes_gap(first, second, branch, direction);
    if (gap > 0) return sc_vertices_apart(branch, direction, gap);
  }
  VertexHits of_a, of_b;
  search_vertices(of_first, first, second, branch, of_a);
  if (of_a.count > 0) search_vertices(of_second, second, first, sc_scale(-1, branch), of_b);
  if (of_b.count == 0) return sc_vertices_apart(branch, direction, 0);
  const sc_vertices_within a = within(first, of_a), b = within(second, of_b);
  const sc_vec normal = sc_normal_of_vertices(a, b);
  if (sc_dot(normal, normal) == 0) return sc_vertices_apart(branch, direction, 0);
  return sc_touch_of_vertices(a, b, branch, normal, reach_along(of_first, first, of_a, normal),
                              reach_along(of_second, second, of_b, sc_scale(-1, normal)));
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
