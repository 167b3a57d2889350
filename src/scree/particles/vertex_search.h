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
struct alignas(64) VertexHits {
  double sum[6][8] = {};
  int count = 0, blocks = 0;
  std::int16_t block[most_vertex_blocks];
  std::uint8_t lanes[most_vertex_blocks];
};

/// Eight numbers of which the sign says something: those not negative count. They are finite, and no zero of theirs is
/// negative: poses that are not finite end a run before.
struct alignas(64) VertexSigns {
  double at[8];
};

/// Notes the vertices of a block that count.
[[gnu::always_inline]] inline void note_block(const VertexView& of, int block, VertexSigns& counts, VertexHits& hits) {
  if (block == of.blocks - 1)
    for (int l = 0; l < 8; ++l)
      if (!(of.last >> l & 1)) counts.at[l] = -1;
  const unsigned lanes = not_negative(counts.at);
  if (lanes == 0) return;
  // Times one or nothing: a choice between two numbers to add is not made lane by lane where there are no masks.
  alignas(64) double share[8];
#pragma omp simd
  for (int l = 0; l < 8; ++l) share[l] = counts.at[l] < 0 ? 0.0 : 1.0;
  const double* p = of.points + std::int64_t{48} * block;
  for (int k = 0; k < 6; ++k) {
#pragma omp simd
    for (int l = 0; l < 8; ++l) hits.sum[k][l] += share[l] * p[8 * k + l];
  }
  hits.count += __builtin_popcount(lanes);
  hits.block[hits.blocks] = static_cast<std::int16_t>(block);
  hits.lanes[hits.blocks] = static_cast<std::uint8_t>(lanes);
  ++hits.blocks;
}

/// A body at bounding radius 1 as another one sees it, over the half axes of that: rows of the map, its centre, how
/// much of each half axis its radius is, and how much of its radius each half axis.
struct VertexMap {
  double row[3][3], centre[3], spread[3], size[3];
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
    m.size[k] = 1 / scale;
  }
  return m;
}

[[gnu::always_inline]] inline double mapped(const VertexMap& m, int k, double x, double y, double z) {
  return ((m.row[k][0] * x + m.row[k][1] * y) + m.row[k][2] * z) + m.centre[k];
}

/// By how much a point in the frame of the other body, over its half axes, is within its box; negative outside.
[[gnu::always_inline]] inline double room_in_box(double x, double y, double z) {
  return 1 - SC_MAX(SC_MAX(SC_FABS(x), SC_FABS(y)), SC_FABS(z));
}

/// Eight vertices of a block in the frame of the other body, over its half axes; those outside its box in its centre.
struct alignas(64) MappedBlock {
  double at[3][8];
  VertexSigns room;
};

[[gnu::always_inline]] inline void map_block(const VertexView& of, int block, const VertexMap& m, MappedBlock& out) {
  const double* p = of.points + std::int64_t{48} * block;
#pragma omp simd
  for (int l = 0; l < 8; ++l) {
    const double px = p[l], py = p[8 + l], pz = p[16 + l];
    const double x = mapped(m, 0, px, py, pz), y = mapped(m, 1, px, py, pz), z = mapped(m, 2, px, py, pz);
    const double room = room_in_box(x, y, z);
    out.room.at[l] = room;
    out.at[0][l] = room < 0 ? 0 : x;
    out.at[1][l] = room < 0 ? 0 : y;
    out.at[2][l] = room < 0 ? 0 : z;
  }
}

/// What stands for the inside-outside function where a body is no superellipsoid, at a point over the half axes.
inline double square_of_gauge(const sc_form& form, const sc_vec& x) {
  const double gauge = sc_gauge(form, 1, sc_make_vec(form.axes.x * x.x, form.axes.y * x.y, form.axes.z * x.z)).value;
  return gauge * gauge;
}

/// The inside-outside function at eight points.
template <int Kind>
[[gnu::always_inline]] inline void values_at(const MappedBlock& b, const sc_form& in, double* value) {
  if constexpr (Kind == SC_GROWTH_OTHER) {
    for (int l = 0; l < 8; ++l) value[l] = square_of_gauge(in, sc_make_vec(b.at[0][l], b.at[1][l], b.at[2][l]));
  } else {
#pragma omp simd
    for (int l = 0; l < 8; ++l)
      value[l] =
          sc_inside_outside(sc_growth_exponents(Kind, in.gauge), sc_make_vec(b.at[0][l], b.at[1][l], b.at[2][l]));
  }
}

/// Eight vertices against the inside-outside function.
template <int Kind>
[[gnu::always_inline]] inline void search_block(const VertexView& of, int block, const VertexMap& m, const sc_form& in,
                                                VertexHits& hits) {
  MappedBlock b;
  map_block(of, block, m, b);
  if (not_negative(b.room.at) == 0) return;
  VertexSigns value;
  values_at<Kind>(b, in, value.at);
#pragma omp simd
  for (int l = 0; l < 8; ++l) value.at[l] = b.room.at[l] < 0 ? -1 : 1 - value.at[l];
  note_block(of, block, value, hits);
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

[[gnu::always_inline]] inline double along(const sc_vec& d, double x, double y, double z) {
  return (d.x * x + d.y * y) + d.z * z;
}

/// Which of eight spheres come near another body, which its map and cut tell of: a bit each.
[[gnu::always_inline]] inline unsigned spheres_near(const double* s, const VertexMap& m, const VertexCut& cut) {
  VertexSigns near;
#pragma omp simd
  for (int l = 0; l < 8; ++l) {
    const double x = s[l], y = s[8 + l], z = s[16 + l], radius = s[24 + l];
    double room = along(cut.along, x, y, z) + radius - cut.least;
    for (int k = 0; k < 3; ++k) {
      const double past = (1 + m.spread[k] * radius) - SC_FABS(mapped(m, k, x, y, z));
      room = SC_MIN(room, past);
    }
    near.at[l] = room;
  }
  return not_negative(near.at);
}

template <int Kind>
[[gnu::noinline]] void search_kind(const VertexView& of, const VertexMap& m, const VertexCut& cut, const sc_form& in,
                                   VertexHits& hits) {
  const int all = (of.blocks + 7) / 8;
  for (int first = 0; first < all; first += 8)
    for (unsigned groups = spheres_near(of.spheres + 32 * all + 4 * first, m, cut); groups; groups &= groups - 1) {
      const int block = 8 * (first + __builtin_ctz(groups));
      for (unsigned bits = spheres_near(of.spheres + 4 * block, m, cut); bits; bits &= bits - 1)
        search_block<Kind>(of, block + __builtin_ctz(bits), m, in, hits);
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

/// How far a point is from the box and the cut at least, over the bounding radius of its body; below 0 within both.
[[gnu::always_inline]] inline double outside(const VertexMap& m, const VertexCut& cut, double x, double y, double z) {
  double far = cut.least - along(cut.along, x, y, z);
  for (int k = 0; k < 3; ++k) {
    const double past = (SC_FABS(mapped(m, k, x, y, z)) - 1) * m.size[k];
    far = SC_MAX(far, past);
  }
  return far;
}

/// How far the vertices of a block are from another body at least, over the bounding radius of their own. A gauge g
/// grows by 1 along no less than the radius of a ball in the body, here that in the octahedron between its poles, and
/// with F = g^n1 > 1, g - 1 > (1 - 1/F)/n1.
template <int Kind>
[[gnu::always_inline]] inline double block_distance(const VertexView& of, int block, const VertexMap& m,
                                                    const VertexCut& cut, const sc_form& in) {
  const double ball = 1 / SC_SQRT(m.spread[0] * m.spread[0] + m.spread[1] * m.spread[1] + m.spread[2] * m.spread[2]);
  const double* p = of.points + std::int64_t{48} * block;
  alignas(64) double far[8], value[8];
#pragma omp simd
  for (int l = 0; l < 8; ++l) far[l] = outside(m, cut, p[l], p[8 + l], p[16 + l]);
  MappedBlock b;
  map_block(of, block, m, b);
  if (not_negative(b.room.at) != 0) {
    values_at<Kind>(b, in, value);
    const double scale = in.gauge.outer.inverse * ball;
#pragma omp simd
    for (int l = 0; l < 8; ++l) {
      const double by_gauge = (1 - 1 / value[l]) * scale;
      far[l] = b.room.at[l] < 0 ? far[l] : SC_MAX(far[l], by_gauge);
    }
  }
  double least = far[0];
  for (int l = 1; l < 8; ++l) least = SC_MIN(least, far[l]);
  return least;
}

/// How far the vertices of a body are from another one at least, over the bounding radius of their own. The block whose
/// sphere is nearest comes first; others are looked at if their spheres are nearer than what was found.
template <int Kind>
[[gnu::noinline]] double distance_by_kind(const VertexView& of, const VertexMap& m, const VertexCut& cut,
                                          const sc_form& in) {
  double far[most_vertex_blocks + 8];
  for (int group = 0; group < of.blocks; group += 8) {
    const double* s = of.spheres + 4 * group;
#pragma omp simd
    for (int l = 0; l < 8; ++l) far[group + l] = outside(m, cut, s[l], s[8 + l], s[16 + l]) - s[24 + l];
  }
  int nearest = 0;
  for (int block = 1; block < of.blocks; ++block) nearest = far[block] < far[nearest] ? block : nearest;
  double least = block_distance<Kind>(of, nearest, m, cut, in);
  for (int block = 0; block < of.blocks; ++block)
    if (far[block] < least && block != nearest) least = SC_MIN(least, block_distance<Kind>(of, block, m, cut, in));
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
    VertexSigns near;
#pragma omp simd
    for (int l = 0; l < 8; ++l) near.at[l] = (along(d, s[l], s[8 + l], s[16 + l]) + s[24 + l]) - limit;
    for (unsigned bits = not_negative(near.at); bits; bits &= bits - 1) {
      const int block = group + __builtin_ctz(bits);
      const double* p = of.points + std::int64_t{48} * block;
      VertexSigns behind;
#pragma omp simd
      for (int l = 0; l < 8; ++l) {
        const double depth = along(d, p[l], p[8 + l], p[16 + l]);
        behind.at[l] = depth > limit ? depth - limit : -1;
      }
      note_block(of, block, behind, hits);
    }
  }
}

/// Means of what was found, in the world.
inline sc_vertices_within within(const sc_body_shape& body, const VertexHits& hits) {
  double sum[6];
  for (int k = 0; k < 6; ++k) {
    const double* s = hits.sum[k];
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
  alignas(64) double far[8];
  for (int l = 0; l < 8; ++l) far[l] = -1e300;
  for (int b = 0; b < hits.blocks; ++b) {
    const double* p = of.points + std::int64_t{48} * hits.block[b];
    const int lanes = hits.lanes[b];
#pragma omp simd
    for (int l = 0; l < 8; ++l) {
      const double reach = along(d, p[l], p[8 + l], p[16 + l]);
      far[l] = (lanes & 1 << l) != 0 && reach > far[l] ? reach : far[l];
    }
  }
  double farthest = far[0];
  for (int l = 1; l < 8; ++l) farthest = SC_MAX(farthest, far[l]);
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
