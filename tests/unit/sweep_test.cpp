// The pass over contacts, with its tiles, slots, vectors and threads, against a plain evaluation of all pairs: equal to
// the last bit, for every kind of law, number of threads and instruction set.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/touch/sphere_sphere.h"
#include "scree/physics/touch/wall.h"

namespace scree {
namespace {

using namespace test;
using Key = std::pair<std::int64_t, std::int64_t>;

/// What a particle feels: forces, turns (lever times normal cross force), couples and losses, summed one by one.
struct Feels {
  double force[3]{}, turn[3]{}, couple[3]{}, loss[3]{};

  void add(const sc_contact_result& r, double lever, const sc_vec& normal, double sign, double share) {
    const sc_vec f = sc_add(r.action.normal_force, r.action.tangential_force);
    const sc_vec t = sc_scale(lever, sc_cross(normal, r.action.tangential_force));
    const double on_force[3] = {f.x, f.y, f.z}, on_turn[3] = {t.x, t.y, t.z};
    const double on_couple[3] = {r.action.couple.x, r.action.couple.y, r.action.couple.z};
    const double lost[3] = {r.action.loss_normal, r.action.loss_sliding, r.action.loss_rolling};
    for (int k = 0; k < 3; ++k) {
      force[k] += sign * on_force[k];
      turn[k] += on_turn[k];
      couple[k] += sign * on_couple[k];
      loss[k] += share * lost[k];
    }
  }
  void add(const Feels& walls) {
    for (int k = 0; k < 3; ++k) {
      force[k] += walls.force[k];
      turn[k] += walls.turn[k];
      couple[k] += walls.couple[k];
      loss[k] += walls.loss[k];
    }
  }
};

struct Body {
  double x[3], v[3], rim[3], radius, inverse_mass, inverse_radius, excess;
  double loss[3];
  int material;
};

/// The same physics as the engine's, by the most plain loops: all pairs by id, then all walls, then everybody moves.
/// Uniform gravity only.
struct Plain {
  Domain domain;
  sc_laws laws;
  Materials materials;
  Walls walls;
  sc_vec gravity{};
  double dt;
  std::int64_t step = 0;
  std::vector<Body> body;
  std::map<Key, sc_contact_state> pairs, on_walls;
  std::int64_t acting = 0;

  explicit Plain(const Simulation& s)
      : domain(s.system().domain),
        laws(s.system().laws),
        materials(s.system().materials),
        walls(s.system().walls),
        gravity(s.fields().uniform),
        dt(s.clock().dt) {
    const Particles& p = s.system().particles;
    for (const std::size_t i : test::rows_by_id(p)) {
      const double *m = p.motion.row(i), *w = p.spin.row(i);
      Body b{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {w[0], w[1], w[2]}, m[3], m[7], w[3], p.effect_excess[i], {}, 0};
      b.material = p.material[i];
      body.push_back(b);
    }
  }

  sc_sphere_touch touch(const Body& a, const Body& b) const {
    double d[3];
    for (int k = 0; k < 3; ++k) {
      d[k] = b.x[k] - a.x[k];
      if (!domain.periodic[k]) continue;
      const double length = domain.max[k] - domain.min[k];
      if (d[k] > length / 2) d[k] -= length;
      if (d[k] < -length / 2) d[k] += length;
    }
    sc_sphere_pair p;
    p.branch = sc_make_vec(d[0], d[1], d[2]);
    p.radii = a.radius + b.radius;
    p.velocity = sc_make_vec(a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]);
    p.inverse_mass = a.inverse_mass + b.inverse_mass;
    p.rim_speed = sc_make_vec(a.rim[0] + b.rim[0], a.rim[1] + b.rim[1], a.rim[2] + b.rim[2]);
    p.inverse_radius = a.inverse_radius + b.inverse_radius;
    p.excess = laws.cohesion == SC_COHESION_NONE ? 0 : a.excess + b.excess;
    double spin[3];
    for (int k = 0; k < 3; ++k) spin[k] = a.rim[k] * a.inverse_radius - b.rim[k] * b.inverse_radius;
    p.spin = sc_make_vec(spin[0], spin[1], spin[2]);
    return sc_touch_spheres(p);
  }

  sc_sphere_touch touch(const Body& b, std::size_t face) const {
    sc_sphere_wall s;
    s.position = sc_make_vec(b.x[0], b.x[1], b.x[2]);
    s.velocity = sc_make_vec(b.v[0], b.v[1], b.v[2]);
    s.rim_speed = sc_make_vec(b.rim[0], b.rim[1], b.rim[2]);
    s.spin = sc_scale(b.inverse_radius, s.rim_speed);
    s.radius = b.radius;
    s.inverse_mass = b.inverse_mass;
    s.excess = b.excess;
    return sc_touch_wall(s, walls.faces[face], walls.pose_of(face));
  }

  /// Evaluates a contact that acts, or acted; keeps or forgets its memory.
  bool act(std::map<Key, sc_contact_state>& memory, Key key, const sc_sphere_touch& t, const sc_pair_law& law,
           sc_contact_result& r) {
    const auto found = memory.find(key);
    if (t.touch.reach <= 0 && found == memory.end()) return false;
    const double lead = step == 0 ? 0 : dt / 2, kick = step == 0 ? dt / 2 : dt;
    sc_contact_state before{};
    if (found != memory.end()) before = found->second;
    r = sc_contact_act(laws, law, t.touch, {step == 0 ? 0 : dt, lead, kick}, before);
    memory.erase(key);
    if (r.action.touching) memory[key] = r.state;
    acting += r.action.touching;
    return true;
  }

  void advance() {
    const std::int64_t n = static_cast<std::int64_t>(body.size());
    acting = 0;
    std::vector<Feels> all(body.size());
    // In this order every particle meets its partners by rising id.
    for (std::int64_t i = 0; i < n; ++i)
      for (std::int64_t j = i + 1; j < n; ++j) {
        if (body[i].inverse_mass == 0 && body[j].inverse_mass == 0) continue;
        const sc_sphere_touch t = touch(body[i], body[j]);
        sc_contact_result r;
        if (!act(pairs, {i, j}, t, materials.pair(body[i].material, body[j].material), r)) continue;
        all[i].add(r, t.lever, t.touch.normal, 1, 0.5);
        all[j].add(r, t.lever, t.touch.normal, -1, 0.5);
      }
    for (std::int64_t i = 0; i < n; ++i) {
      if (body[i].inverse_mass == 0) continue;
      Feels on_wall;
      for (std::size_t f = 0; f < walls.size(); ++f) {
        const sc_sphere_touch t = touch(body[i], f);
        sc_contact_result r;
        if (act(on_walls, {i, static_cast<std::int64_t>(f)}, t,
                materials.pair(body[i].material, walls.faces[f].material), r))
          on_wall.add(r, t.lever, t.touch.normal, 1, 1);
      }
      all[i].add(on_wall);
    }
    for (std::int64_t i = 0; i < n; ++i) move(body[i], all[i]);
    ++step;
  }

  void move(Body& b, const Feels& f) const {
    const double kick = step == 0 ? dt / 2 : dt;
    const double g[3] = {gravity.x, gravity.y, gravity.z};
    for (int k = 0; k < 3; ++k) {
      b.loss[k] += f.loss[k];
      if (b.inverse_mass > 0) {
        b.v[k] += kick * (b.inverse_mass * f.force[k] + g[k]);
        b.rim[k] += 2.5 * kick * b.inverse_mass * (f.turn[k] + b.inverse_radius * f.couple[k]);
      }
      b.x[k] += dt * b.v[k];
      if (!domain.periodic[k]) continue;
      if (b.x[k] < domain.min[k]) b.x[k] += domain.max[k] - domain.min[k];
      if (b.x[k] >= domain.max[k]) b.x[k] -= domain.max[k] - domain.min[k];
    }
  }
};

/// Springs: slide x y z, roll x y z, twist; only those that the laws have.
Springs springs_of(const sc_laws& laws, const sc_contact_state& s) {
  Springs out{};
  if (laws.tangential >= SC_TANGENTIAL_HISTORY) out = {s.slide.x, s.slide.y, s.slide.z};
  if (laws.rolling != SC_ROLLING_NONE || laws.twisting != SC_TWISTING_NONE) {
    out[3] = s.roll.x;
    out[4] = s.roll.y;
    out[5] = s.roll.z;
    out[6] = s.twist;
  }
  return out;
}

void expect_equal(const std::map<Key, sc_contact_state>& plain, const std::map<Key, Springs>& engine,
                  const sc_laws& laws, const char* what) {
  ASSERT_EQ(plain.size(), engine.size()) << what;
  for (const auto& [key, state] : plain) {
    const auto found = engine.find(key);
    ASSERT_NE(found, engine.end()) << what << " " << key.first << "-" << key.second;
    const Springs expected = springs_of(laws, state);
    for (std::size_t k = 0; k < expected.size(); ++k)
      ASSERT_EQ(expected[k], found->second[k]) << what << " " << key.first << "-" << key.second << ", spring " << k;
  }
}

void expect_equal(const Plain& plain, const Simulation& s) {
  const Particles& p = s.system().particles;
  const std::vector<std::size_t> row = test::rows_by_id(p);
  ASSERT_EQ(s.findings().contacts, plain.acting);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Body& b = plain.body[i];
    const double *m = p.motion.row(row[i]), *w = p.spin.row(row[i]), *loss = p.loss.row(row[i]);
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(b.x[k], m[k]) << "position of " << i;
      ASSERT_EQ(b.v[k], m[4 + k]) << "velocity of " << i;
      ASSERT_EQ(b.rim[k], w[k]) << "spin of " << i;
      ASSERT_EQ(b.loss[k], loss[k]) << "loss of " << i;
    }
  }
  expect_equal(plain.pairs, pair_springs(s.system()), plain.laws, "pair");
  expect_equal(plain.on_walls, wall_springs(s.system()), plain.laws, "wall");
}

const std::vector<LawChoice>& law_choices() {
  static const std::string friction = "friction = 0.5\nfriction_sliding = 0.3\n";
  static const std::string turning = friction + "rolling_friction = 0.2\ntwisting_friction = 0.1\n";
  static const std::vector<LawChoice> choices = {
      {"linear_none", "normal = \"linear\"\ntangential = \"none\"\n", ""},
      {"plain_sliding", "normal = \"linear_plain\"\ntangential = \"sliding\"\n", friction},
      {"linear_step_spring", "normal = \"linear\"\ntangential = \"step_spring\"\n", friction},
      {"linear_collision_spring", "normal = \"linear\"\ntangential = \"collision_spring\"\n", friction},
      {"plain_collision_spring_damped", "normal = \"linear_plain\"\ntangential = \"collision_spring_damped\"\n",
       friction},
      {"linear_history", "normal = \"linear\"\ntangential = \"history\"\n", friction},
      {"linear_history_turning",
       "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\ntwisting = \"spring\"\n", turning},
      {"linear_cohesive", "normal = \"linear\"\ntangential = \"history\"\ncohesion = \"linear\"\n",
       friction + "cohesion_stiffness = 200\n"},
      {"hertz_mindlin", "normal = \"hertz\"\ntangential = \"mindlin\"\n", friction, true},
      {"hertz_mindlin_turning",
       "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"spring\"\ntwisting = \"spring\"\n", turning, true},
      {"jkr_mindlin_turning",
       "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"spring\"\ntwisting = \"spring\"\ncohesion = "
       "\"jkr\"\n",
       turning + "adhesion = 2\n", true},
      {"plain_cohesive_rolling",
       "normal = \"linear_plain\"\ntangential = \"history\"\nrolling = \"spring\"\ncohesion = \"linear\"\n",
       friction + "rolling_friction = 0.2\ncohesion_stiffness = 200\n"},
      {"hertz_stretch_twisting", "normal = \"hertz\"\ntangential = \"mindlin_stretch\"\ntwisting = \"spring\"\n",
       friction + "twisting_friction = 0.1\n", true},
      {"jkr_none", "normal = \"hertz\"\ntangential = \"none\"\ncohesion = \"jkr\"\n", "adhesion = 2\n", true}};
  return choices;
}

/// Runs the case plainly once, and by the engine in every way; compares on the way.
void expect_equal_in_every_way(const Case& c, int steps, int checks) {
  std::vector<Plain> plain;
  for (const char* isa : instruction_sets())
    for (const int threads : {1, 2, 3}) {
      SCOPED_TRACE(std::string(isa) + ", threads: " + std::to_string(threads));
      const InstructionSet chosen(isa);
      Simulation engine(c, {threads, 1});
      ASSERT_STREQ(engine.instruction_set(), isa);
      if (plain.empty())
        for (int k = 0; k < checks; ++k) {
          plain.push_back(k == 0 ? Plain(engine) : plain.back());
          for (int step = 0; step < steps / checks; ++step) plain.back().advance();
        }
      const std::vector<std::size_t> order = test::rows_by_id(engine.system().particles);
      for (const Plain& truth : plain) {
        advance(engine, steps / checks);
        expect_equal(truth, engine);
        if (testing::Test::HasFatalFailure()) return;
      }
      EXPECT_GT(plain.back().pairs.size(), 10u) << "the test tests little";
      EXPECT_NE(test::rows_by_id(engine.system().particles), order) << "the lists were never made again";
    }
}

class SweepOfLaw : public testing::TestWithParam<LawChoice> {};

TEST_P(SweepOfLaw, GivesTheBitsOfPlainLoops) {
  Case c = case_of(crowd_text(GetParam(), 90, 0.026));
  c.simulation.skin = 3e-4;
  expect_equal_in_every_way(c, 300, 3);
}

INSTANTIATE_TEST_SUITE_P(All, SweepOfLaw, testing::ValuesIn(law_choices()),
                         [](const auto& law) { return law.param.name; });

/// One big sphere in the midst of `count` small ones that stick to it, in a periodic box whose face cuts it.
std::string urchin_text(const LawChoice& laws, double ratio, int count) {
  const double small = 1e-3, big = ratio * small, side = 3 * big;
  std::string places;
  for (int i = 0; i < count; ++i) {  // evenly over the sphere, by the golden angle
    const double z = 1 - (2 * i + 1.0) / count, angle = 2.399963229728653 * i, ring = std::sqrt(1 - z * z);
    const double distance = 0.5 * (big + small) * 0.998;
    const double x[3] = {distance * ring * std::cos(angle), side / 2 + distance * ring * std::sin(angle),
                         side / 2 + distance * z};
    places += (i ? ", [" : "[") + std::to_string(x[0] < 0 ? x[0] + side : x[0]) + ", " + std::to_string(x[1]) + ", " +
              std::to_string(x[2]) + "]";
  }
  const std::string s = std::to_string(side), middle = std::to_string(side / 2);
  return "[simulation]\nend = 1\ntime_step = 5e-6\nmax_overlap = 0.9\nskin = 1e-5\n[domain]\nmin = [0, 0, 0]\nmax = [" +
         s + ", " + s + ", " + s + "]\nperiodic = [true, true, true]\n[contact]\n" + laws.contact +
         material_text(laws, "glass", 50, 0.8) +
         "[[particles]]\nname = \"small\"\nmaterial = \"glass\"\ndiameter = 1e-3\neffect_gap = 5e-5\ninsert = "
         "\"positions\"\n"
         "angular_velocity = [50, 10, -20]\nvelocity = { type = \"random\", deviation = 0.02 }\npositions = [" +
         places + "]\n[[particles]]\nname = \"big\"\nmaterial = \"glass\"\ndiameter = " + std::to_string(big) +
         "\ninsert = \"positions\"\npositions = [[0, " + middle + ", " + middle + "]]\n";
}

TEST(Sweep, TakesMoreContactsOfOneBodyThanATileHolds) {
  const LawChoice laws = {"", "cohesion = \"linear\"\nrolling = \"spring\"\ntwisting = \"spring\"\n",
                          "friction = 0.5\nrolling_friction = 0.1\ntwisting_friction = 0.1\ncohesion_stiffness = 10\n"};
  for (const auto& [ratio, count] : {std::pair{10.0, 300}, std::pair{30.0, 600}}) {
    SCOPED_TRACE(ratio);
    const Case c = case_of(urchin_text(laws, ratio, count));
    Simulation engine(c, 1);
    advance(engine, 45);
    std::vector<int> contacts(static_cast<std::size_t>(count) + 1);
    for (const auto& [ids, springs] : pair_springs(engine.system())) ++contacts[static_cast<std::size_t>(ids.second)];
    EXPECT_GT(contacts.back(), tile_size);
    expect_equal_in_every_way(c, 60, 2);
  }
}

TEST(Sweep, KeepsNecksThatAreLongerThanTheSkin) {
  // The pellets have effect surfaces, which JKR does not read; the grains have none.
  const LawChoice jkr = {"", "normal = \"hertz\"\ntangential = \"mindlin\"\ncohesion = \"jkr\"\n",
                         "friction = 0.5\nadhesion = 30\n", true};
  Case c = case_of(crowd_text(jkr, 60, 0.024), {"particles.grains.effect_gap=0", "particles.pellets.effect_gap=3e-4"});
  c.simulation.skin = 1e-6;
  expect_equal_in_every_way(c, 400, 2);
}

TEST(Sweep, MissesNoContactAfterAStepWhoseSpeedIsGoneAtItsEnd) {
  // Syrup stops the sphere within its first step, but the trapezoidal rule has carried it by half a step of its speed.
  const std::string text = R"(
[simulation]
end = 1
time_step = 1e-5
integrator = "implicit"
skin = 1e-7
[domain]
min = [0, 0, 0]
max = [1, 1, 1]
[flow]
type = "still"
drag = "stokes"
density = 1
viscosity = 1e7
[[materials]]
name = "glass"
density = 2500
stiffness = 1000
[[particles]]
material = "glass"
diameter = 0.01
insert = "positions"
positions = [[0.5, 0.5, 0.5]]
[[particles]]
material = "glass"
diameter = 0.01
insert = "positions"
positions = [[0.510001, 0.5, 0.5]]
velocity = [-1, 0, 0]
)";
  Simulation s(case_of(text), 1);
  s.step();
  EXPECT_EQ(s.findings().contacts, 0);
  EXPECT_LT(std::sqrt(s.findings().fastest2) * s.clock().dt, 1e-8);
  s.step();
  EXPECT_EQ(s.findings().contacts, 1);
}

}  // namespace
}  // namespace scree
