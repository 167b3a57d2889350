// Particles that are no spheres at walls of every kind: against spheres, closed forms and conservation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine_cases.h"
#include "scree/analysis/measure.h"
#include "scree/data/forms.h"
#include "scree/physics/touch/body_wall.h"
#include "support/mesh_shapes.h"

namespace scree {
namespace {

using test::advance;
using test::case_of;

/// A wall of every kind around or beside the origin.
std::vector<sc_wall> walls_of_every_kind() {
  const auto v = [](double x, double y, double z) { return sc_make_vec(x, y, z); };
  std::vector<sc_wall> walls{sc_wall_plane(v(0, 0, -1), v(0, 0.6, 0.8)),
                             sc_wall_block(SC_WALL_RECTANGLE, v(-1, 0.4, -1), v(1, 0.4, 1)),
                             sc_wall_block(SC_WALL_SOLID_BOX, v(-0.4, -0.3, -0.2), v(0.3, 0.4, 0.5))};
  sc_wall plate = sc_wall_of(SC_WALL_PLATE), triangle = sc_wall_of(SC_WALL_TRIANGLE);
  plate.a = v(-0.5, 0.1, 0.2);
  plate.b = v(1, 0.5, 0);
  plate.c = v(-0.3, 0.6, 0.4);
  triangle.a = v(0.7, 0, 0);
  triangle.b = v(0, 0.8, 0.1);
  triangle.c = v(-0.5, -0.4, 0.3);
  walls.insert(walls.end(), {plate, triangle});
  const double shapes[][3] = {{1, 0.8, 0.8}, {1, 0.3, 0.9}, {1, 0, 0.7}, {0, 0.9, 0}, {0, 0.9, 0.4}};
  for (const auto& [length, start, end] : shapes) {
    sc_wall round = sc_wall_of(SC_WALL_FRUSTUM);
    round.a = v(-0.2, 0.1, -0.4);
    round.b = v(0.48, 0.6, 0.64);
    round.length = length;
    round.start_radius = start;
    round.end_radius = end;
    walls.push_back(round);
  }
  return walls;
}

TEST(ShapeWall, SphereOfTheFormOfASuperellipsoidIsASphereAtEveryWall) {
  const sc_form sphere = sc_make_form(sc_make_vec(1, 1, 1), 1, 1);
  std::mt19937_64 random(5);
  const auto draw = [&] { return 2.4 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1.2; };
  sc_wall_pose pose = sc_wall_at_home();
  pose.moves = 1;
  pose.turn = sc_quat_mat(sc_quat_of_turn(sc_make_vec(0.3, -0.7, 0.2)));
  pose.pivot = sc_make_vec(0.1, 0, 0);
  pose.place = sc_make_vec(0, 0.2, -0.1);
  const double radius = 0.35;
  for (const sc_wall& wall : walls_of_every_kind()) {
    int touched = 0;
    for (int i = 0; i < 400; ++i) {
      const sc_vec x = sc_make_vec(draw(), draw(), draw());
      const sc_wall_gap expected = sc_gap_to_wall(wall, pose, x);
      if (expected.distance > radius || expected.distance < 0.02) continue;
      const sc_body_shape body{sphere, radius, sc_quat_mat(sc_quat_of_turn(sc_make_vec(draw(), draw(), draw())))};
      sc_body_gap gaps[SC_FRUSTUM_GAPS];
      ASSERT_GE(sc_body_to_wall(wall, pose, body, x, body.radius, gaps), 1);
      ++touched;
      EXPECT_NEAR(gaps[0].overlap, radius - expected.distance, 1e-10) << wall.kind;
      const sc_vec off = sc_sub(gaps[0].normal, expected.normal);
      EXPECT_LT(sc_norm(off), 1e-9) << wall.kind << ' ' << i;
      EXPECT_LT(sc_norm(sc_add_scaled(gaps[0].arm, -expected.distance, expected.normal)), 1e-10) << wall.kind;
    }
    EXPECT_GT(touched, 20) << wall.kind;
  }
}

std::string head(double dt, const std::string& contact = "tangential = \"none\"",
                 const std::string& material = "stiffness = 2e6") {
  return fmt::format(
      "[simulation]\nend = 10\ntime_step = {:.17g}\nmax_overlap = 0.5\n[domain]\nmin = [-2, -2, -2]\nmax = [2, 2, 2]\n"
      "[contact]\n{}\n[[materials]]\nname = \"glass\"\ndensity = 2000\n{}\n",
      dt, contact, material);
}

struct Shape {
  const char *name, *keys;
};
const Shape shapes[] = {
    {"ellipsoid", "shape = \"ellipsoid\"\nhalf_axes = [0.1, 0.07, 0.05]\n"},
    {"fourth powers", "shape = \"superellipsoid\"\nhalf_axes = [0.1, 0.08, 0.06]\nexponents = [0.5, 0.5]\n"},
    {"cylinder", "shape = \"superellipsoid\"\nhalf_axes = [0.06, 0.06, 0.1]\nexponents = [0.3333, 1]\n"},
    {"cube", "shape = \"superellipsoid\"\nhalf_axes = [0.08, 0.08, 0.08]\nexponents = [0.25, 0.25]\n"}};

std::string body_text(const std::string& keys, const sc_vec& place, const std::string& velocity,
                      const std::string& turn) {
  return fmt::format(
      "[[particles]]\nmaterial = \"glass\"\n{}insert = \"positions\"\npositions = [[{:.17g}, {:.17g}, {:.17g}]]\n"
      "velocity = {}\norientation = {}\n",
      keys, place.x, place.y, place.z, velocity, turn);
}

std::string tilted(double degrees, double azimuth) {
  return fmt::format("{{ axis = [{}, {}, 0.3], angle = \"{} deg\" }}", std::cos(azimuth), std::sin(azimuth), degrees);
}

const std::string floor_text =
    "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";

double energy(Simulation& s) {
  const Measured m = measure(s.sample(), Fields{}, 0, {});
  return m.kinetic + m.rotational + s.sample().stored.elastic;
}

std::string walls_text(const test::Triangles& triangles) {
  std::string text = "[[walls]]\nname = \"mesh\"\ntype = \"triangles\"\nmaterial = \"glass\"\nvertices = [\n";
  for (const test::Corners& corners : triangles)
    for (const sc_vec& x : corners) text += fmt::format("[{:.17g}, {:.17g}, {:.17g}],\n", x.x, x.y, x.z);
  return text + "]\n";
}

/// A wall to fall on, and where from.
struct Target {
  const char* name;
  std::string wall;
  sc_vec place;
};

std::vector<Target> targets() {
  const sc_vec above = sc_make_vec(0.01, 0.015, 0.101);
  const auto wall = [](const std::string& keys) { return "[[walls]]\nname = \"wall\"\nmaterial = \"glass\"\n" + keys; };
  const sc_vec a = sc_make_vec(-1, 0, 0), b = sc_make_vec(1, 0, 0), c = sc_make_vec(0, 1, -0.8),
               d = sc_make_vec(0, -1, -0.9);
  return {
      {"plane", floor_text, above},
      {"ridge", walls_text({{a, b, c}, {b, a, d}}), above},
      {"edge of a plate", wall("type = \"plate\"\ncorner = [-1, 0, 0]\nedge_a = [2, 0, 0]\nedge_b = [0, 0, -1]\n"),
       above},
      {"corner",
       walls_text({{sc_make_vec(0, 0, 0), sc_make_vec(1, 0, -1.5), sc_make_vec(0, 1, -1.5)},
                   {sc_make_vec(0, 0, 0), sc_make_vec(0, 1, -1.5), sc_make_vec(-1, -1, -1.5)},
                   {sc_make_vec(0, 0, 0), sc_make_vec(-1, -1, -1.5), sc_make_vec(1, 0, -1.5)}}),
       above},
      {"box", wall("type = \"box\"\nside = \"outside\"\nmin = [0, 0, -1]\nmax = [1, 1, 0]\n"), above},
      {"inside of a pipe", wall("type = \"cylinder\"\nstart = [-1, 0, 0.3]\nend = [1, 0, 0.3]\nradius = 0.3\n"), above},
      {"outside of a pipe", wall("type = \"cylinder\"\nstart = [-1, 0, -0.2]\nend = [1, 0, -0.2]\nradius = 0.2\n"),
       above},
      {"cone", wall("type = \"cone\"\nstart = [0, 0, -0.1]\nend = [0, 0, 0.5]\nstart_radius = 0\nend_radius = 0.6\n"),
       sc_make_vec(0.12, 0.05, 0.23)},
      {"rim", wall("type = \"cylinder\"\nstart = [0.2, 0, -1]\nend = [0.2, 0, 0]\nradius = 0.2\n"), above}};
}

struct Bounce {
  const Target& target;
  const Shape& shape;
  std::string contact, material;
  double degrees = 20;
  double lead = 0;  // how long the body has flown already [s]

  Simulation start(double dt) const {
    const sc_vec place = sc_add_scaled(target.place, -lead, sc_make_vec(0, 0, 1));
    return Simulation(case_of(head(dt, contact, material) + target.wall +
                              body_text(shape.keys, place, "[0, 0, -1]", tilted(degrees, 0.4 + degrees))),
                      Team{1});
  }
};

/// A bounce: how long it lasted [s], how much of the energy the spring held, and by how much the energy changed, both
/// over what it was before.
struct Bounced {
  double duration = 0, held = 0, error = 0;
};

Bounced bounced(const Bounce& bounce, double dt) {
  Simulation s = bounce.start(dt);
  const double before = energy(s);
  Bounced out;
  int touching = 0;
  for (int k = 0; k < 20000 && !(touching > 0 && s.findings().contacts == 0); ++k) {
    s.step();
    touching += s.findings().contacts > 0;
    if (touching % 10 == 1) out.held = std::max(out.held, s.sample().stored.elastic / before);
  }
  out.duration = touching * dt;
  out.error = std::abs(energy(s) / before - 1);
  return out;
}

/// Flies until just before the bounce.
Bounce shortly_before(Bounce bounce) {
  Simulation flight = bounce.start(1e-4);
  int steps = 0;
  for (; flight.findings().contacts == 0 && steps < 2000; ++steps) flight.step();
  EXPECT_LT(steps, 2000) << bounce.target.name << ' ' << bounce.shape.name;
  bounce.lead = std::max(0.0, 1e-4 * (steps - 3));
  return bounce;
}

/// Sums of the squares of the errors with 100 and 400 steps in a bounce, elastic and without friction, of all shapes at
/// some walls. `allowed`: of the energy that the spring held, at 400.
std::array<double, 2> errors_at(const std::vector<Target>& walls, const std::string& contact,
                                const std::string& material, double allowed) {
  std::array<double, 2> sum{};
  for (std::size_t t = 0; t < walls.size(); ++t)
    for (std::size_t k = t % 2; k < 4; k += 2) {
      const double degrees = 20 + 7 * static_cast<double>(k);
      const Bounce bounce = shortly_before({walls[t], shapes[k], contact, material, degrees});
      const double duration = bounced(bounce, 1e-5).duration;
      for (const double phase : {0.0, 0.5}) {
        const double coarse = bounced(bounce, duration / (100 + phase)).error;
        const Bounced fine = bounced(bounce, duration / (400 + phase));
        EXPECT_LT(fine.error, allowed * fine.held) << walls[t].name << ' ' << shapes[k].name;
        sum[0] += coarse * coarse;
        sum[1] += fine.error * fine.error;
      }
    }
  return sum;
}

// Where there is no potential the error does not fall with the time step. A kink of the force at both ends of a contact
// with n steps costs a quarter of (pi/n)^2 of the energy that the spring held at most.
TEST(ShapeWall, ElasticBounceKeepsItsEnergyAtEveryWall) {
  const double kinks = std::pow(std::numbers::pi / 400, 2) / 4;
  const auto [coarse, fine] = errors_at(targets(), "tangential = \"none\"", "stiffness = 2e6", 1.05 * kinks);
  EXPECT_NEAR(std::sqrt(coarse / fine), 17, 5);
}

TEST(ShapeWall, ElasticBounceKeepsItsEnergyWithHertz) {
  const std::vector<Target> all = targets();
  const auto [coarse, fine] = errors_at({all[0], all[1], all[5], all[6]}, "normal = \"hertz\"\ntangential = \"none\"",
                                        "young = 5e8\npoisson = 0.3", 5e-6);
  EXPECT_NEAR(std::sqrt(coarse / fine), 16, 2);
}

/// Frictionless impact in closed form: the impulse j along the normal n at the arm r gives v' = v + j n/m and L' = j r
/// x n with j = -2 v_n / (1/m + (r x n).I^-1 (r x n)). Soft contacts come near it as they get stiff.
TEST(ShapeWall, FrictionlessImpactAtAllTilts) {
  const Axes axes[] = {{0.1, 0.05, 0.05}, {0.06, 0.06, 0.1}};
  const double exponents[][2] = {{1, 1}, {0.3333, 1}};
  for (int kind = 0; kind < 2; ++kind)
    for (int tilt = 3; tilt <= 87; tilt += 12) {
      const std::string keys =
          fmt::format("shape = \"superellipsoid\"\nhalf_axes = [{}, {}, {}]\nexponents = [{}, {}]\n", axes[kind][0],
                      axes[kind][1], axes[kind][2], exponents[kind][0], exponents[kind][1]);
      const std::string turn = fmt::format("{{ axis = [0, 1, 0], angle = \"{} deg\" }}", tilt);
      // Where it just touches.
      const Form form = make_form(axes[kind], exponents[kind][0], exponents[kind][1]);
      const sc_mat m = sc_quat_mat(sc_quat_of_turn(sc_make_vec(0, tilt * std::numbers::pi / 180, 0)));
      const double radius = bounding_radius(axes[kind], exponents[kind][0], exponents[kind][1]);
      const sc_norm_value low = sc_support_in_world({form.shape, radius, m}, sc_make_vec(0, 0, -1));
      // A hundred times as stiff as the others: 50 steps in a collision.
      const std::string text = head(5e-6, "tangential = \"none\"", "stiffness = 2e8") + floor_text +
                               body_text(keys, sc_make_vec(0, 0, low.value + 1e-6), "[0, 0, -1]", turn);
      Simulation s(case_of(text), Team{1});
      bool met = false;
      for (int k = 0; k < 300 && !(met && s.findings().contacts == 0); ++k) {
        s.step();
        met |= s.findings().contacts > 0;
      }
      const Particles& p = s.system().particles;
      const double mass = p.mass[0];
      const Axes inertia = superellipsoid_inertia(axes[kind], exponents[kind][0], exponents[kind][1]);
      const double x = low.gradient.x, j = 2 / (1 / mass + x * x / (mass * inertia[1]));
      EXPECT_NEAR(p.motion.row(0)[lane::vz], -1 + j / mass, 0.01 * j / mass) << kind << ' ' << tilt;
      EXPECT_NEAR(p.angular_momentum.row(0)[1], -x * j, 0.01 * std::abs(x) * j) << kind << ' ' << tilt;
    }
}

const std::string rough = "tangential = \"history\"";
const std::string rough_glass = "stiffness = 1e5\nrestitution = 0.5\nfriction = 0.3";
const std::string weight = "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n";

TEST(ShapeWall, EllipsoidSlidesAndRollsOverTrianglesAsOverAPlane) {
  const std::string body = body_text("shape = \"ellipsoid\"\nhalf_axes = [0.008, 0.006, 0.005]\n",
                                     sc_make_vec(0.05, 0.1, 0.0055), "[0.8, 0.13, 0]", tilted(20, 1));
  test::Triangles triangles = test::plane_triangles(0.4, 60, 7);
  Simulation one(case_of(head(2e-5, rough, rough_glass) + weight + floor_text + body), Team{1});
  Simulation other(case_of(head(2e-5, rough, rough_glass) + weight + walls_text(triangles) + body), Team{1});
  double apart = 0;
  std::int64_t contacts = 0;
  for (int k = 0; k < 10000; ++k) {
    one.step();
    other.step();
    for (int axis = 0; axis < 3; ++axis)
      apart = std::max(
          apart, std::abs(one.system().particles.motion.row(0)[axis] - other.system().particles.motion.row(0)[axis]));
    contacts = std::max(contacts, other.findings().contacts);
  }
  EXPECT_GT(one.system().particles.motion.row(0)[0], 0.12);  // dozens of edges
  EXPECT_LT(apart, 1e-12);
  EXPECT_EQ(contacts, 1);
}

TEST(ShapeWall, EllipsoidSwingingRoundAPipeKeepsItsEnergy) {
  const std::string pipe =
      "[[walls]]\ntype = \"cylinder\"\nmaterial = \"glass\"\nstart = [-1, 0, 0.3]\nend = [1, 0, 0.3]\nradius = 0.3\n";
  // Fast enough to be pressed to the wall all the way round; it rocks, so that it touches at many of its points.
  const std::string text = head(4e-5, "tangential = \"none\"", "stiffness = 2e6") + pipe +
                           body_text("shape = \"ellipsoid\"\nhalf_axes = [0.1, 0.05, 0.04]\n", sc_make_vec(0, 0, 0.045),
                                     "[0, 3, 0]", "{ axis = [1, 0, 0], angle = \"25 deg\" }");
  Simulation s(case_of(text), Team{1});
  const double before = energy(s);
  double worst = 0;
  int touched = 0;
  for (int k = 0; k < 5000; ++k) {
    s.step();
    touched += s.findings().contacts > 0;
    if (k % 250 == 0) worst = std::max(worst, std::abs(energy(s) / before - 1));
  }
  EXPECT_GT(touched, 500);
  EXPECT_LT(worst, 1e-3);
}

// A rod across the bottom of a pipe lies on its two ends; as it turns along the pipe they become one place.
TEST(ShapeWall, PlacesThatHaveBecomeOneKeepOneMemory) {
  const std::string pipe =
      "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -10]\n"
      "[[walls]]\ntype = \"cylinder\"\nmaterial = \"glass\"\nstart = [-1, 0, 0.3]\nend = [1, 0, 0.3]\nradius = 0.3\n";
  const std::string text = head(5e-4, "tangential = \"none\"", "stiffness = 2e4\nrestitution = 0.4") + pipe +
                           body_text("shape = \"ellipsoid\"\nhalf_axes = [0.2, 0.03, 0.03]\n", sc_make_vec(0, 0, 0.1),
                                     "[0, 0, 0]", "{ axis = [0, 0, 1], angle = \"50 deg\" }");
  Simulation s(case_of(text), Team{1});
  int with_one = 0, with_two = 0;
  for (int k = 0; k < 4000; ++k) {
    s.step();
    const auto& active = s.system().wall_contacts.active;
    const auto remembered = static_cast<std::int64_t>(active.size()) - std::count(active.begin(), active.end(), 0);
    ASSERT_EQ(remembered, s.findings().contacts) << k;
    with_one += remembered == 1;
    with_two += remembered == 2;
  }
  EXPECT_GT(with_one, 10);
  EXPECT_GT(with_two, 10);
}

TEST(ShapeWall, MovingWallHitsAsABodyDoes) {
  // The same collision, seen from the wall and from the body.
  const std::vector<Target> all = targets();
  for (const Target& target : {all[1], all[5], all[8]}) {
    const std::string body_falls = head(4e-5, rough, "stiffness = 2e6\nfriction = 0.3\nrestitution = 0.6") +
                                   target.wall + body_text(shapes[0].keys, target.place, "[0, 0.2, -1]", tilted(25, 1));
    const std::string wall_comes = head(4e-5, rough, "stiffness = 2e6\nfriction = 0.3\nrestitution = 0.6") +
                                   target.wall + "motion = { type = \"velocity\", velocity = [0, -0.2, 1] }\n" +
                                   body_text(shapes[0].keys, target.place, "[0, 0, 0]", tilted(25, 1));
    Simulation falls(case_of(body_falls), Team{1}), comes(case_of(wall_comes), Team{1});
    advance(falls, 1700);
    advance(comes, 1700);
    const Particles &p = falls.system().particles, &q = comes.system().particles;
    const double expected[3] = {0, 0.2, -1};
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(p.motion.row(0)[4 + k], q.motion.row(0)[4 + k] + expected[k], 1e-9) << target.name;
      EXPECT_NEAR(p.angular_momentum.row(0)[k], q.angular_momentum.row(0)[k], 1e-9) << target.name;
    }
    EXPECT_GT(std::abs(p.motion.row(0)[lane::vz] + 1), 0.1) << target.name;
  }
}

/// Shapes that lie about in a turning drum of two kinds of walls, each by itself.
std::string drum_text() {
  std::string text = head(4e-5, "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"spring\"",
                          "young = 2e8\npoisson = 0.3\nrestitution = 0.5\nfriction = 0.4\nrolling_friction = 0.02");
  text += weight;
  text +=
      "[[walls]]\nname = \"drum\"\nmaterial = \"glass\"\ntype = \"cylinder\"\nstart = [-1, 0, 0]\nend = [1, 0, 0]\n"
      "radius = 0.25\nclosed = true\nmotion = { type = \"rotation\", axis = [1, 0, 0], angular_velocity = 2 }\n" +
      walls_text(test::plane_triangles(0.1, 4, 3));
  const char* const more[] = {"shape = \"cylinder\"\nhalf_axes = [0.02, 0.02, 0.04]\n",
                              "shape = \"ellipsoid\"\nhalf_axes = [0.04, 0.02, 0.03]\n", shapes[3].keys};
  for (int k = 0; k < 3; ++k)
    text += body_text(k == 2 ? "shape = \"box\"\nhalf_axes = [0.02, 0.03, 0.02]\n" : more[k],
                      sc_make_vec(-0.6 + 0.4 * k, 0.02, -0.18), "[0.3, 0.2, -0.8]", tilted(30 + 20 * k, k));
  return text + body_text(more[1], sc_make_vec(0.05, 0.05, 0.05), "[0, 0.02, -0.3]", tilted(40, 2));
}

TEST(ShapeWall, BitsDoNotDependOnThreadsInstructionsListsOrRestarts) {
  const Case c = case_of(drum_text());
  Simulation whole(c, Team{1});
  advance(whole, 1500);
  const std::string expected = whole.state_hash();
  for (const int threads : {2, 3}) {
    Simulation s(c, Team{threads});
    advance(s, 1500);
    EXPECT_EQ(s.state_hash(), expected) << threads;
  }
  Simulation wide(case_of(drum_text(), {"simulation.skin=0.03"}), Team{1});
  advance(wide, 1500);
  EXPECT_EQ(wide.state_hash(), expected);
  for (const char* set : test::instruction_sets()) {
    const test::InstructionSet use(set);
    Simulation s(c, Team{1});
    advance(s, 1500);
    EXPECT_EQ(s.state_hash(), expected) << set;
  }
  Simulation first(c, Team{2});
  int steps = 900;
  advance(first, steps);
  for (; first.findings().contacts == 0 && steps < 1500; ++steps) first.step();  // until some touch
  EXPECT_LT(steps, 1500);
  const Archive saved = first.save();
  Simulation second(c, Team{1}, &saved);
  second.restore(saved);
  EXPECT_EQ(second.state_hash(), first.state_hash());
  advance(second, 1500 - steps);
  EXPECT_EQ(second.state_hash(), expected);
}

TEST(ShapeWall, BodiesComeToRestOnAPlane) {
  const char* const bodies[] = {"shape = \"ellipsoid\"\nhalf_axes = [0.02, 0.01, 0.01]\n",
                                "shape = \"cylinder\"\nhalf_axes = [0.01, 0.01, 0.02]\n",
                                "shape = \"box\"\nhalf_axes = [0.01, 0.01, 0.01]\n"};
  std::string text = head(1e-4, rough + "\nrolling = \"spring\"",
                          "stiffness = 1e4\nrestitution = 0.3\nfriction = 0.4\nrolling_friction = 0.1") +
                     weight + floor_text;
  for (int k = 0; k < 3; ++k) text += body_text(bodies[k], sc_make_vec(0.3 * k, 0, 0.03), "[0, 0, 0]", tilted(20, 1));
  Simulation s(case_of(text), Team{1});
  advance(s, 15000);
  const Particles& p = s.system().particles;
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i);
    EXPECT_LT(std::hypot(m[lane::vx], m[lane::vy], m[lane::vz]), 1e-4) << i;
    EXPECT_LT(std::hypot(spin[0], spin[1], spin[2]), 1e-3) << i;
    place[i] = m[0];
  }
  advance(s, 5000);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(p.motion.row(i)[0], place[i], 1e-5) << i;
}

TEST(ShapeWall, BoxOfTrianglesIsABoxOfPlanes) {
  std::string bodies;
  for (int k = 0; k < 8; ++k)
    bodies += body_text(shapes[k % 4].keys,
                        sc_make_vec(0.25 + 0.5 * (k & 1), 0.25 + 0.5 * (k >> 1 & 1), 0.25 + 0.5 * (k >> 2)),
                        "[0.4, -0.3, -0.9]", tilted(15 * k, k));
  const std::string box =
      "[[walls]]\nname = \"box\"\ntype = \"box\"\nmaterial = \"glass\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n";
  const std::string mesh = walls_text(test::box_triangles(sc_make_vec(0, 0, 0), sc_make_vec(1, 1, 1)));
  const std::string laws = head(2e-5, rough, "stiffness = 2e6\nrestitution = 0.6\nfriction = 0.3");
  Simulation planes(case_of(laws + box + bodies), Team{1}), triangles(case_of(laws + mesh + bodies), Team{1});
  std::int64_t contacts = 0;
  for (int k = 0; k < 10000; ++k) {
    planes.step();
    triangles.step();
    contacts += planes.findings().contacts;
    ASSERT_EQ(planes.findings().contacts, triangles.findings().contacts) << k;
  }
  EXPECT_GT(contacts, 500);
  const Particles &p = planes.system().particles, &q = triangles.system().particles;
  for (std::size_t i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(p.motion.row(i)[k], q.motion.row(i)[k], 1e-9) << i;
}

}  // namespace
}  // namespace scree
