// Capsules: closed forms, growth distances by the distance of segments, rest, piles, restarts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "engine_cases.h"
#include "scree/app/frame_fields.h"
#include "scree/data/form_mesh.h"
#include "scree/data/form_surface.h"
#include "scree/input/mesh_file.h"
#include "scree/input/mesh_report.h"
#include "scree/output/shape_file.h"
#include "scree/particles/shapes.h"
#include "scree/physics/shape/closest.h"
#include "scree/physics/touch/contact_radius.h"
#include "support/temporary_directory.h"
#include "unit/shape_pairs.h"

namespace scree {
namespace {

using namespace pairs;

/// Integrals over the height of the body of revolution that the points near a segment make: volume, moments, area.
struct Revolved {
  double volume = 0, along = 0, across = 0, area = 0;
};

Revolved revolved(double radius, double half) {
  const double length = half - radius, pi = std::numbers::pi;
  Revolved out;
  constexpr int steps = 2000;
  // Over the angle of the normal at an end, and over the height of the side: middles of equal steps.
  const auto slice = [&](double rho, double z, double thickness, double slant) {
    const double square = rho * rho;
    out.volume += 2 * pi * square * thickness;
    out.along += pi * square * square * thickness;
    out.across += 2 * pi * (0.25 * square * square + square * z * z) * thickness;
    out.area += 4 * pi * rho * slant;
  };
  for (int i = 0; i < steps; ++i) {
    const double t = 0.5 * pi * (i + 0.5) / steps, step = 0.5 * pi * radius / steps;
    slice(radius * std::cos(t), length + radius * std::sin(t), step * std::cos(t), step);
    slice(radius, length * (i + 0.5) / steps, length / steps, length / steps);
  }
  out.along /= out.volume;
  out.across /= out.volume;
  return out;
}

TEST(Capsule, VolumeInertiaAreaAndRadii) {
  for (const double half : {1.0, 1.001, 1.5, 4.0, 20.0}) {
    const Form form = make_form("capsule", {2, 2, 2 * half}, 1, 1);
    const double radius = bounding_radius("capsule", {2, 2, 2 * half}, 1, 1);
    EXPECT_EQ(radius, 2 * half);
    const Revolved truth = revolved(1 / half, 1);
    EXPECT_NEAR(form.volume / truth.volume, 1, 1e-6) << half;
    EXPECT_NEAR(form.inertia[2] / truth.along, 1, 1e-6) << half;
    EXPECT_NEAR(form.inertia[0] / truth.across, 1, 1e-6) << half;
    EXPECT_EQ(form.inertia[0], form.inertia[1]);
    EXPECT_NEAR(surface_of(form) / truth.area, 1, 1e-6) << half;
    EXPECT_NEAR(form.shape.inscribed, 1 / half, 1e-15);
    EXPECT_NEAR(4 * std::numbers::pi / 3 * std::pow(form.equivalent_radius, 3), form.volume, 1e-14);
    EXPECT_LE(sphericity(form.volume, surface_of(form)), 1 + 1e-15);
  }
  // A sphere is one without a side.
  const Form sphere = make_form("capsule", {1, 1, 1}, 1, 1);
  EXPECT_TRUE(sphere.shape.is_sphere);
  EXPECT_NEAR(sphere.volume, 4 * std::numbers::pi / 3, 1e-14);
  EXPECT_NEAR(sphere.inertia[0], 0.4, 1e-15);
  EXPECT_NEAR(sphere.inertia[2], 0.4, 1e-15);
}

/// Gradient and Hessian against differences of value and gradient.
template <class Norm>
void check_derivatives(Norm norm, const Vec& at, const char* what) {
  const sc_vec x = narrow(at);
  const sc_norm_value here = norm(x);
  const double h = 1e-6 * sc_norm(x);
  EXPECT_NEAR(sc_dot(here.gradient, x), here.value, 1e-13 * here.value) << what;
  for (int k = 0; k < 3; ++k) {
    const sc_vec d = sc_make_vec(k == 0 ? h : 0, k == 1 ? h : 0, k == 2 ? h : 0);
    const sc_norm_value up = norm(sc_add(x, d)), down = norm(sc_sub(x, d));
    const double slope = k == 0 ? here.gradient.x : k == 1 ? here.gradient.y : here.gradient.z;
    EXPECT_NEAR((up.value - down.value) / (2 * h), slope, 1e-8 * sc_norm(here.gradient)) << what;
    const sc_vec bend = sc_scale(1 / (2 * h), sc_sub(up.gradient, down.gradient));
    const auto dyad = [&](double factor, sc_vec v) {
      return sc_scale(factor * (k == 0 ? v.x : k == 1 ? v.y : v.z), v);
    };
    const sc_vec expected = sc_add(dyad(here.inner_bend, here.inner), dyad(here.outer_bend, here.outer));
    EXPECT_LT(sc_norm(sc_sub(bend, expected)), 1e-7 * sc_norm(here.gradient) / sc_norm(x)) << what;
  }
}

TEST(Capsule, GaugeAndSupportWithTheirDerivatives) {
  std::mt19937_64 random(1);
  for (const double half : {1.0, 1.2, 3.0, 20.0}) {
    const Body b = capsule(0.5, 0.5 * half, 0.7);
    const sc_form& f = b.form.shape;
    for (int i = 0; i < 200; ++i) {
      const Vec d = any_direction(random), n = any_direction(random);
      const Real edge = std::abs(d.z) - (half - 1) * std::sqrt(d.x * d.x + d.y * d.y);  // of the side, along d
      const sc_norm_value g = sc_gauge(f, 0.7, narrow(d)), h = sc_support(f, 0.7, narrow(n));
      EXPECT_NEAR(g.value / static_cast<double>(b.gauge(d)), 1, 1e-14);
      EXPECT_NEAR(h.value / static_cast<double>(b.support(n)), 1, 1e-14);
      EXPECT_NEAR(sc_support(f, 0.7, g.gradient).value, 1, 1e-14);
      EXPECT_NEAR(sc_gauge(f, 0.7, h.gradient).value, 1, 1e-14);
      if (std::abs(edge) > 1e-3) check_derivatives([&](sc_vec x) { return sc_gauge(f, 0.7, x); }, d, "gauge");
      if (std::abs(n.z) > 1e-3) check_derivatives([&](sc_vec x) { return sc_support(f, 0.7, x); }, n, "support");
    }
    for (const sc_vec& x : {sc_make_vec(0, 0, 0), sc_make_vec(0, 0, 1), sc_make_vec(0, 0, -1), sc_make_vec(1, 0, 0)}) {
      const sc_norm_value g = sc_gauge(f, 0.7, x);
      EXPECT_TRUE(std::isfinite(g.value + sc_norm(g.gradient) + g.inner_bend * sc_norm(g.inner))) << half;
      EXPECT_GT(sc_norm(g.gradient), 0);
    }
  }
}

TEST(Capsule, TheClosestPointAndTheCurvatures) {
  std::mt19937_64 random(2);
  const Body b = capsule(1, 3);  // of radius 1/3 at bounding radius 1
  for (int i = 0; i < 300; ++i) {
    const Vec x = static_cast<Real>(1.1 + uniform_draw(random)) * any_direction(random);
    const sc_closest c = sc_closest_point(b.form.shape, 3, narrow(3 * x));
    EXPECT_NEAR(c.low, c.high, 1e-13);
    EXPECT_NEAR(sc_gauge(b.form.shape, 3, c.point).value, 1, 1e-14);
  }
  // At an end both radii of curvature are that of the capsule, on the side one is infinite.
  const sc_body_shape body{b.form.shape, 3, sc_unit_mat()};
  const sc_vec end = sc_make_vec(0.6, 0, 0.8), side = sc_make_vec(0, 1, 1e-9), along = sc_make_vec(0, 0, 1);
  const sc_plane_matrix at_end = sc_tangent_radii(body, end, sc_perpendicular(end), 1e-3, 1e3);
  EXPECT_NEAR(at_end.xx, 1, 1e-12);
  EXPECT_NEAR(at_end.yy, 1, 1e-12);
  EXPECT_NEAR(at_end.xy, 0, 1e-12);
  const sc_plane_matrix at_side = sc_tangent_radii(body, side, along, 1e-3, 1e3);
  EXPECT_NEAR(at_side.xx, 1e3, 1e-6);
  EXPECT_NEAR(at_side.yy, 1, 1e-6);
}

/// Distance of two segments of half lengths l and m along unit vectors u and v whose middles are w apart.
Real distance_of_segments(Vec w, Vec u, Real l, Vec v, Real m) {
  const auto clamped = [](Real t, Real limit) { return std::max(-limit, std::min(limit, t)); };
  const auto at = [&](Real s, Real t) {
    const Vec d = w + t * v - s * u;
    return std::sqrt(dot(d, d));
  };
  const Real uv = dot(u, v), det = 1 - uv * uv;
  Real best = 1e30L;
  for (const Real s : {-l, l}) best = std::min(best, at(s, clamped(dot(s * u - w, v), m)));
  for (const Real t : {-m, m}) best = std::min(best, at(clamped(dot(w + t * v, u), l), t));
  if (det > 1e-18L) {
    const Real s = (dot(w, u) - uv * dot(w, v)) / det, t = s * uv - dot(w, v);
    if (std::abs(s) <= l && std::abs(t) <= m) best = std::min(best, at(s, t));
  }
  return best;
}

/// The factor by which both have to grow: where the distance of the grown segments is the sum of the grown radii.
Real growth_by_segments(const Body& a, const Body& b, const sc_mat& turn_b, Vec d) {
  const Vec u{0, 0, 1}, v = turn(turn_b, u), of_a = a.axes(), of_b = b.axes();
  Real low = 0, high = std::sqrt(dot(d, d)) / (of_a.x + of_b.x);
  for (int i = 0; i < 90; ++i) {
    const Real s = (low + high) / 2;
    const Real gap =
        distance_of_segments(d, u, s * (of_a.z - of_a.x), v, s * (of_b.z - of_b.x)) - s * (of_a.x + of_b.x);
    (gap > 0 ? low : high) = s;
  }
  return (low + high) / 2;
}

/// A turn as it comes, or one that leaves the axes nearly or exactly parallel, or square.
sc_mat turn_of_kind(int kind, std::mt19937_64& random) {
  if (kind == 0) return any_turn(random);
  if (kind == 1) return turn_of(1, 0, 0, normal_draw(random));
  if (kind == 2) return turn_of(1, std::pow(10, -9 * uniform_draw(random)), 0, 0);
  return turn_of(1, 1, 0, 0);
}

TEST(Capsule, GrowthDistanceAsThatOfSegments) {
  std::mt19937_64 random(3);
  std::int64_t wrong = 0, uneven = 0;
  for (int i = 0; i < 6000; ++i) {
    const Body a = capsule(1, std::pow(20, uniform_draw(random)));
    const Body b = capsule(1, std::pow(20, uniform_draw(random)), i % 3 ? 1 : std::pow(0.1, uniform_draw(random)));
    const sc_mat turn_b = turn_of_kind(i % 4, random);
    Vec d = any_direction(random);
    if (i % 5 == 0) d.z = 0;
    const double near = std::pow(10, -11 + 11 * uniform_draw(random)) * 0.9;
    const Real wanted = random() & 1 ? 1 - near : 1 + near;
    const sc_vec branch = narrow((wanted / growth_by_segments(a, b, turn_b, d)) * d);
    const double truth = static_cast<double>(growth_by_segments(a, b, turn_b, wide(branch)));
    const sc_body_shape first{a.form.shape, a.radius, sc_unit_mat()}, second{b.form.shape, b.radius, turn_b};
    const sc_shape_touch there = touch_shapes(first, second, branch, false, sc_growth_point{});
    const sc_shape_touch back = touch_shapes(second, first, sc_scale(-1, branch), false, sc_growth_point{});
    wrong += there.verdict != (wanted < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
    wrong += back.verdict != there.verdict;
    const double rounding = 1e-13;
    EXPECT_LE(there.low, truth + rounding);
    EXPECT_GE(there.high, truth - rounding);
    if (there.verdict == SC_GROWTH_TOUCHING) {
      EXPECT_NEAR(1 - there.overlap / there.support, truth, 1e-12) << i;
      EXPECT_NEAR(1 - back.overlap / back.support, truth, 1e-12) << i;
    }
    if (a.radius == b.radius) continue;
    uneven += there.overlap != back.overlap || there.normal.x != -back.normal.x || there.arm.x != back.arm_second.x;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(uneven, 0);
}

std::string head_text(const std::string& contact) {
  return "[simulation]\nend = 100\nmax_overlap = 0.5\n[domain]\nmin = [-0.05, -0.05, -0.01]\nmax = [0.05, 0.05, 0.2]\n"
         "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n[[materials]]\nname = \"wood\"\ndensity = 700\n"
         "restitution = 0.3\nfriction = 0.5\n[[walls]]\nname = \"box\"\ntype = \"box\"\nmaterial = \"wood\"\n"
         "min = [-0.02, -0.02, 0]\nmax = [0.02, 0.02, 0.2]\n" +
         contact;
}

/// The keys that differ, set one by one.
Case bed_of(bool hard, int count) {
  std::string text = head_text("");
  const auto put = [&](const std::string& after, const std::string& what) {
    text.insert(text.find(after) + after.size(), what);
  };
  put("max_overlap = 0.5\n", hard ? "time_step = 5e-4\n" : "time_step = 2e-5\n");
  if (!hard) put("density = 700\n", "stiffness = 2000\nrolling_friction = 0.02\n");
  text += hard ? "[contact]\ncollision = \"hard\"\n"
               : "[contact]\nnormal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\n";
  text += fmt::format(
      "[[particles]]\nname = \"rods\"\nmaterial = \"wood\"\nshape = \"capsule\"\nhalf_axes = [3e-3, 3e-3, 8e-3]\n"
      "orientation = \"random\"\ninsert = \"random\"\ncount = {}\nregion_min = [-0.02, -0.02, 0]\n"
      "region_max = [0.02, 0.02, 0.1]\n",
      count);
  return test::case_of(text);
}

double kinetic(Simulation& s) {
  return measure(s.sample(), s.fields(), s.clock().now(), s.exchange().passage()).kinetic;
}

// 12 capsules fall 50 mm on the average: what is left of their energy of motion.
TEST(Capsule, APileComesToRestSoftAndHard) {
  for (const bool hard : {false, true}) {
    Simulation s(bed_of(hard, 12), Team{1});
    test::advance(s, hard ? 1200 : 60000);
    const double mass = 700 * 12 * make_form("capsule", {3, 3, 8}, 1, 1).volume * std::pow(8e-3, 3);
    EXPECT_LT(kinetic(s), 1e-5 * mass * 9.81 * 0.05) << hard;
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_GT(s.system().particles.motion.row(i)[lane::z], 2.9e-3);
      EXPECT_LT(s.system().particles.motion.row(i)[lane::z], 0.05);
    }
  }
}

TEST(Capsule, BitsAreThoseOfAnyThreadsSetsAndRestarts) {
  for (const bool hard : {false, true}) {
    const Case c = bed_of(hard, 20);
    const int steps = hard ? 300 : 2000;
    const test::Outcome one = test::outcome(c, Team{1}, steps);
    EXPECT_EQ(test::outcome(c, Team{3}, steps), one);
    for (const char* set : test::instruction_sets()) {
      const test::InstructionSet chosen(set);
      EXPECT_EQ(test::outcome(c, Team{2}, steps, 2e-3), one) << set;
    }
    Simulation first(c, Team{1});
    test::advance(first, steps / 2);
    const Archive archive = first.save();
    Simulation second(c, Team{2});
    second.restore(archive);
    test::advance(second, steps - steps / 2);
    EXPECT_EQ(second.state_hash(), one.hash);
  }
}

// What frames and the file beside them say of a capsule among boxes.
TEST(Capsule, FramesAndTheFileOfItsSurface) {
  const Case c = test::case_of(
      "[simulation]\nend = 1\ntime_step = 1e-4\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n[[materials]]\n"
      "name = \"m\"\ndensity = 1000\nstiffness = 1e4\n[[particles]]\nmaterial = \"m\"\nshape = \"box\"\n"
      "half_axes = [0.01, 0.01, 0.02]\ninsert = \"positions\"\npositions = [[0.5, 0, 0]]\n[[particles]]\n"
      "material = \"m\"\nshape = \"capsule\"\nhalf_axes = [\"1 cm\", \"1 cm\", \"3 cm\"]\ninsert = \"positions\"\n"
      "positions = [[-0.5, 0, 0]]\n");
  Simulation s(c, Team{1});
  const FrameData frame = frame_data(s.sample(), false);
  ASSERT_EQ(frame.shape_file, (std::vector<std::int32_t>{-1, 2}));
  EXPECT_NEAR(frame.half_axes[3], 0.01, 1e-15);
  EXPECT_NEAR(frame.half_axes[5], 0.03, 1e-15);
  // Closed, and of the volume of a capsule whose half axes have been pressed to 1.
  const test::TemporaryDirectory space;
  const std::filesystem::path path = shape_file(space / "", 2);
  EXPECT_EQ(path.filename(), "shape_2.obj");
  write_shape_file(path, s.system().forms[2]);
  const MeshReport report = report_mesh(read_mesh(path));
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.flipped_edges, 0);
  EXPECT_NEAR(report.volume, std::numbers::pi * (4.0 / 3 + 4) / 3, 0.04);
  EXPECT_NEAR(report.high.x, 1, 1e-6);
  EXPECT_NEAR(report.high.z, 1, 1e-6);
}

}  // namespace
}  // namespace scree
