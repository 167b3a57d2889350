// The vertex method: what its search finds against plain loops, its limit of many vertices against the certified
// contact, and what it misses.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/particles/vertex_search.h"
#include "scree/particles/vertex_views.h"
#include "unit/shape_pairs.h"

namespace scree {
namespace {

using pairs::any_turn;
using pairs::uniform_draw;

/// A form with its vertices.
struct Surface {
  Form form;
  std::vector<SurfaceVertex> vertices;
  VertexBlocks blocks;

  Surface(const Form& f, int side, VertexSpacing spacing = VertexSpacing::linear)
      : form(f), vertices(surface_vertices(f, side, spacing)), blocks(blocks_of(vertices)) {}
};

struct Body {
  const Surface& surface;
  sc_body_shape shape;

  Body(const Surface& s, double radius, const sc_mat& turn) : surface(s), shape{s.form.shape, radius, turn} {}
  VertexView view() const { return view_of(surface.blocks); }
  const std::vector<SurfaceVertex>& vertices() const { return surface.vertices; }
  sc_vec place(const SurfaceVertex& v) const { return sc_turn(shape.turn, sc_scale(shape.radius, v.point)); }
};

sc_shape_touch touch(const Body& a, const Body& b, const sc_vec& branch, const sc_vec& parting = sc_zero_vec()) {
  return touch_by_vertices(a.view(), a.shape, b.view(), b.shape, branch, parting);
}

/// The branch that makes two bodies overlap by `depth` along a random direction, and that direction.
struct Placed {
  sc_vec branch, normal;
};
Placed placed(const Body& a, const Body& b, double depth, std::mt19937_64& random) {
  const sc_vec n = pairs::narrow(pairs::any_direction(random));
  const sc_vec far_a = sc_support_in_world(a.shape, n).gradient;
  const sc_vec far_b = sc_support_in_world(b.shape, sc_scale(-1, n)).gradient;
  return {sc_add_scaled(sc_sub(far_a, far_b), -depth, n), n};
}

/// The same by plain loops over all vertices.
struct Plain {
  int count = 0;
  sc_vec place = sc_zero_vec(), normal = sc_zero_vec();
  std::vector<sc_vec> points;
};
Plain plain(const Body& of, const Body& in, const sc_vec& branch) {
  Plain out;
  for (const SurfaceVertex& v : of.vertices()) {
    const sc_vec x = of.place(v);
    if (sc_gauge_in_world(in.shape, sc_sub(x, branch)).value > 1) continue;
    ++out.count;
    out.place = sc_add(out.place, x);
    out.normal = sc_add(out.normal, sc_turn(of.shape.turn, v.normal));
    out.points.push_back(x);
  }
  out.place = sc_scale(1.0 / std::max(out.count, 1), out.place);
  out.normal = sc_scale(1.0 / std::max(out.count, 1), out.normal);
  return out;
}

std::vector<Form> all_forms() {
  return {sphere_form(),
          make_form({4, 1, 1}, 1, 1),
          make_form({1, 1, 2}, .25, 1),
          make_form({1, .8, .6}, .25, .25),
          make_form({1, 1, 1}, .5, .5),
          make_form({1.3, .9, .7}, .6, .8),
          make_form({1, .5, .5}, 1.5, .3),
          make_form({1, 1, 1}, .1, .1),
          make_form("capsule", {1, 1, 2.5}, 1, 1)};
}

TEST(VertexContact, FindsWhatPlainLoopsFind) {
  std::mt19937_64 random(1);
  int touching = 0;
  for (const Form& fa : all_forms())
    for (const Form& fb : all_forms())
      for (int i = 0; i < 4; ++i) {
        const Surface sa(fa, 14), sb(fb, 15, VertexSpacing::mixed);
        const Body a(sa, 1, any_turn(random)), b(sb, i % 2 ? .4 : 1.3, any_turn(random));
        const Placed p = placed(a, b, .1 * i, random);
        const Plain pa = plain(a, b, p.branch), pb = plain(b, a, sc_scale(-1, p.branch));
        const sc_vec parting = i == 3 ? pairs::narrow(pairs::any_direction(random)) : p.normal;
        const sc_shape_touch found = touch(a, b, p.branch), fresh = touch(a, b, p.branch, parting);
        // The direction along which they are looked at first changes nothing.
        EXPECT_EQ(found.verdict == SC_GROWTH_TOUCHING, fresh.verdict == SC_GROWTH_TOUCHING);
        if (found.verdict == SC_GROWTH_TOUCHING) {
          EXPECT_EQ(found.overlap, fresh.overlap);
        }
        if (pa.count == 0 || pb.count == 0) {
          EXPECT_NE(found.verdict, SC_GROWTH_TOUCHING);
          continue;
        }
        const sc_vec difference = sc_sub(pa.normal, pb.normal), n = sc_scale(1 / sc_norm(difference), difference);
        double overlap = -1e9;
        for (const sc_vec& xa : pa.points)
          for (const sc_vec& xb : pb.points) overlap = std::max(overlap, sc_dot(n, sc_sub(xa, sc_add(p.branch, xb))));
        touching += found.verdict == SC_GROWTH_TOUCHING;
        EXPECT_NEAR(found.overlap, overlap, 1e-13);
        EXPECT_LT(sc_norm(sc_sub(found.normal, n)), 1e-12);
        const sc_vec middle = sc_scale(.5, sc_add(pa.place, sc_add(p.branch, pb.place)));
        EXPECT_LT(sc_norm(sc_sub(found.arm, middle)), 1e-13);
        EXPECT_LT(sc_norm(sc_sub(found.arm_second, sc_sub(middle, p.branch))), 1e-13);
      }
  EXPECT_GT(touching, 100);
}

TEST(VertexContact, ExchangeOfTheBodiesChangesNoBits) {
  std::mt19937_64 random(2);
  for (const Form& fa : all_forms())
    for (const Form& fb : all_forms()) {
      const Surface sa(fa, 20), sb(fb, 20);
      const Body a(sa, 1, any_turn(random)), b(sb, .7, any_turn(random));
      const Placed p = placed(a, b, .1, random);
      const sc_shape_touch one = touch(a, b, p.branch), two = touch(b, a, sc_scale(-1, p.branch));
      EXPECT_EQ(one.verdict, two.verdict);
      EXPECT_EQ(one.overlap, two.overlap);
      for (const auto& [x, y] : {std::pair(one.normal, sc_scale(-1, two.normal)), std::pair(one.arm, two.arm_second),
                                 std::pair(one.arm_second, two.arm)}) {
        EXPECT_EQ(x.x, y.x);
        EXPECT_EQ(x.y, y.y);
        EXPECT_EQ(x.z, y.z);
      }
    }
}

/// The body turned by an angle about a random axis.
sc_mat turned(const sc_mat& m, double angle, std::mt19937_64& random) {
  const sc_vec n = pairs::narrow(pairs::any_direction(random));
  const sc_mat r = sc_rotation(n, std::cos(angle), std::sin(angle));
  return {sc_turn_back(m, r.x), sc_turn_back(m, r.y), sc_turn_back(m, r.z)};
}

// Bodies that are apart, and such as overlap where they have no vertices. Surfaces go the way that is said to be free:
// the centres come together, or anywhere, and both bodies turn.
TEST(VertexContact, NoneBeforeTheSurfacesHaveGoneTheFreeWay) {
  std::mt19937_64 random(3);
  int free_ways = 0, all = 0, met = 0;
  for (const Form& fa : all_forms())
    for (const Form& fb : all_forms())
      for (int i = 0; i < 24; ++i) {
        const Surface sa(fa, 12), sb(fb, 13);
        Body a(sa, 1, any_turn(random)), b(sb, i % 2 ? .4 : 1.3, any_turn(random));
        const double depth = i < 4 ? -.1 : .002 * i;
        const Placed p = placed(a, b, depth, random);
        const sc_shape_touch found = touch(a, b, p.branch);
        if (found.verdict == SC_GROWTH_TOUCHING) continue;
        ++all;
        free_ways += -found.overlap > 1e-4;
        for (const double share : {.999, 20.0}) {
          const double way = -share * found.overlap, turn = i % 3 ? way / 3 : 0;
          const sc_vec to = i % 4 ? sc_scale(-1, p.normal) : pairs::narrow(pairs::any_direction(random));
          const Body near_a(sa, 1, turned(a.shape.turn, turn, random)),
              near_b(sb, b.shape.radius, turned(b.shape.turn, turn / b.shape.radius, random));
          const sc_vec branch = sc_add_scaled(p.branch, way - 2 * turn, to);
          const bool touches =
              plain(near_a, near_b, branch).count > 0 && plain(near_b, near_a, sc_scale(-1, branch)).count > 0;
          if (share < 1) {
            EXPECT_FALSE(touches);
          }
          met += touches;
        }
      }
  EXPECT_GT(free_ways, .9 * all);
  EXPECT_GT(met, all / 20);
}

/// Errors of depth (over the true one), of the normal [rad] and of the place along it (over the depth), as root mean
/// squares over random pairs that overlap by `depth`, which is small beside the radii.
struct Errors {
  double depth = 0, normal = 0, place = 0;
  int missed = 0;
};
Errors errors(const Form& form, int side, double depth, int count, unsigned seed) {
  std::mt19937_64 random(seed);
  const Surface surface(form, side, VertexSpacing::radial);
  Errors out;
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const Body a(surface, 1, any_turn(random)), b(surface, 1, any_turn(random));
    const Placed p = placed(a, b, depth, random);
    const sc_shape_touch t = touch(a, b, p.branch);
    if (t.verdict != SC_GROWTH_TOUCHING) {
      ++out.missed;
      continue;
    }
    ++found;
    const sc_vec far = sc_support_in_world(a.shape, p.normal).gradient;
    const double place = sc_dot(p.normal, t.arm) - (sc_dot(p.normal, far) - .5 * depth);
    out.depth += std::pow(t.overlap / depth - 1, 2);
    out.normal += std::pow(sc_norm(sc_cross(t.normal, p.normal)), 2);
    out.place += std::pow(place / depth, 2);
  }
  for (double* e : {&out.depth, &out.normal, &out.place}) *e = std::sqrt(*e / found);
  return out;
}

TEST(VertexContact, ConvergesToTheExactContact) {
  for (const Form& form : {sphere_form(), make_form({1.3, .9, .7}, 1, 1), make_form({1.3, .9, .7}, .8, .9)}) {
    const Errors few = errors(form, 25, .03, 200, 5), more = errors(form, 50, .03, 200, 5),
                 most = errors(form, 100, .03, 200, 5);
    EXPECT_EQ(most.missed, 0);
    EXPECT_LT(most.depth, .06);
    EXPECT_LT(most.normal, .03);
    // The part of the depth that vertices cannot see goes with the square of their distance.
    EXPECT_LT(more.depth, .75 * few.depth);
    EXPECT_LT(most.depth, .75 * more.depth);
    EXPECT_LT(most.normal, .75 * few.normal);
  }
}

TEST(VertexContact, MissesWhatWasFoundToBeMissed) {
  // Spheres that overlap by 1 % of the radius, 400 vertices by angles: 54 % without force (another program).
  std::mt19937_64 random(6);
  const Surface sphere(sphere_form(), 20);
  int missed = 0, unseen = 0;
  constexpr int all = 400;
  for (int i = 0; i < all; ++i) {
    const Body a(sphere, 1, any_turn(random)), b(sphere, 1, any_turn(random));
    const Placed p = placed(a, b, .01, random);
    missed += touch(a, b, p.branch).verdict != SC_GROWTH_TOUCHING;
    unseen += plain(a, b, p.branch).count + plain(b, a, sc_scale(-1, p.branch)).count == 0;
  }
  EXPECT_NEAR(missed / double{all}, .54, .09);
  EXPECT_NEAR(unseen / double{all}, .11, .06);
}

TEST(VertexContact, PlaneByTheVerticesBehindIt) {
  std::mt19937_64 random(7);
  for (const Form& form : all_forms())
    for (const double depth : {-.1, .003, .1, .5}) {
      const Surface surface(form, 16);
      const Body body(surface, 2, any_turn(random));
      const sc_vec n = pairs::narrow(pairs::any_direction(random));
      const sc_body_gap exact = sc_body_plane(body.shape, n, sc_support_in_world(body.shape, n).value - depth);
      const sc_body_gap gap = gap_by_vertices(body.view(), body.shape, exact);
      double deepest = 0;
      int count = 0;
      sc_vec place = sc_zero_vec();
      for (const SurfaceVertex& v : body.vertices()) {
        const double beyond = sc_dot(n, body.place(v)) - (exact.support - exact.overlap);
        if (beyond <= 0) continue;
        ++count;
        deepest = std::max(deepest, beyond);
        place = sc_add(place, body.place(v));
      }
      EXPECT_LE(gap.overlap, exact.overlap + 1e-14);
      if (count == 0) {
        EXPECT_LE(gap.overlap, 0);
        continue;
      }
      EXPECT_NEAR(gap.overlap, deepest, 1e-13);
      EXPECT_LT(sc_norm(sc_sub(gap.arm, sc_scale(1.0 / count, place))), 1e-13);
      EXPECT_NEAR(gap.support - gap.overlap, exact.support - exact.overlap, 1e-14);
    }
}

}  // namespace
}  // namespace scree
