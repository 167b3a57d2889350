// What contacts by vertices miss and get wrong, beside certified ones: the tables of docs/vertices.md.
//
//   scree_vertices [pairs]     how many random pairs of each kind (400)
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "scree/analysis/measure.h"
#include "scree/app/simulation.h"
#include "scree/input/load.h"
#include "scree/particles/vertex_search.h"
#include "scree/particles/vertex_views.h"

namespace {

using namespace scree;

using Random = std::mt19937_64;

sc_vec any_vec(Random& r) {
  std::normal_distribution<double> draw;
  const double x = draw(r), y = draw(r), z = draw(r);
  return sc_make_vec(x, y, z);
}

sc_mat any_turn(Random& r) {
  std::normal_distribution<double> draw;
  const double w = draw(r), x = draw(r), y = draw(r), z = draw(r);
  return sc_quat_mat(sc_quat_of_length_one(sc_make_quat(w, x, y, z)));
}

struct Shape {
  const char* name;
  Axes half_axes;
  double e1, e2;
  double least() const { return std::min({half_axes[0], half_axes[1], half_axes[2]}); }
};

const Shape shapes[] = {{"sphere", {1, 1, 1}, 1, 1},
                        {"ellipsoid 4:1:1", {4, 1, 1}, 1, 1},
                        {"cylinder 1:1:2", {1, 1, 2}, .25, 1},
                        {"box 1:0.8:0.6", {1, .8, .6}, .25, .25}};

/// Two equal bodies that overlap by a known depth along a known normal.
struct Pair {
  sc_body_shape a, b;
  sc_vec branch, normal;
};

std::vector<Pair> make_pairs(const Shape& s, double depth, int count) {
  const sc_form form = make_form(s.half_axes, s.e1, s.e2).shape;
  const double radius = bounding_radius(s.half_axes, s.e1, s.e2);
  Random random(7);
  std::vector<Pair> out;
  for (int i = 0; i < count; ++i) {
    Pair p;
    p.a = {form, radius, any_turn(random)};
    p.b = {form, radius, any_turn(random)};
    const sc_vec d = any_vec(random);
    p.normal = sc_scale(1 / sc_norm(d), d);
    const sc_vec far_a = sc_support_in_world(p.a, p.normal).gradient;
    const sc_vec far_b = sc_support_in_world(p.b, sc_scale(-1, p.normal)).gradient;
    p.branch = sc_add_scaled(sc_sub(far_a, far_b), -depth * s.least(), p.normal);
    out.push_back(p);
  }
  return out;
}

double part_of(std::vector<double>& v, double share) {
  if (v.empty()) return 0;
  std::sort(v.begin(), v.end());
  return v[static_cast<std::size_t>(share * static_cast<double>(v.size() - 1) + 0.5)];
}

/// A row of the table: what `touch` finds of the pairs, and its time on one thread.
template <class Touch>
void print_row(const std::string& name, const std::vector<Pair>& pairs, double depth, Touch touch) {
  std::vector<double> depths, angles;
  int missed = 0;
  for (const Pair& p : pairs) {
    const sc_shape_touch t = touch(p);
    if (t.verdict != SC_GROWTH_TOUCHING) {
      ++missed;
      continue;
    }
    depths.push_back(t.overlap / depth);
    angles.push_back(std::asin(std::min(1.0, sc_norm(sc_cross(t.normal, p.normal)))) * 180 / M_PI);
  }
  double fastest = 1e9;
  volatile double sink = 0;
  for (int round = 0; round < 9; ++round) {
    const std::clock_t start = std::clock();
    for (int k = 0; k < 5; ++k)
      for (const Pair& p : pairs) sink = sink + touch(p).overlap;
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    fastest = std::min(fastest, seconds / (5 * static_cast<double>(pairs.size())));
  }
  fmt::print("| {} | {:.1f} % | {:.2f} / {:.2f} / {:.2f} | {:.2f} / {:.2f} | {:.2f} |\n", name,
             100.0 * missed / static_cast<double>(pairs.size()), part_of(depths, .05), part_of(depths, .5),
             part_of(depths, .95), part_of(angles, .5), part_of(angles, .95), 1e6 * fastest);
}

void print_geometry(const Shape& s, double depth, int count) {
  const std::vector<Pair> pairs = make_pairs(s, depth, count);
  const Form form = make_form(s.half_axes, s.e1, s.e2);
  const double size = depth * s.least();
  for (const int side : {20, 40, 80})
    for (const auto& [word, spacing] : {std::pair("linear", VertexSpacing::linear), {"mixed", VertexSpacing::mixed}}) {
      const VertexBlocks blocks = blocks_of(surface_vertices(form, side, spacing));
      const VertexView view = view_of(blocks);
      print_row(fmt::format("{} | {} x {} {}", s.name, side, side, word), pairs, size,
                [&](const Pair& p) { return touch_by_vertices(view, p.a, view, p.b, p.branch, sc_zero_vec()); });
    }
  print_row(fmt::format("{} | certified", s.name), pairs, size,
            [&](const Pair& p) { return sc_touch_shapes(p.a, p.b, p.branch, 0, {}); });
}

std::string vector_text(const sc_vec& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// Two bodies of 1000 kg/m3, lengths in cm, that meet obliquely at 1 m/s; 400 steps in the shortest contact of these
/// bodies. The overlap of two spheres of as much volume would be about 0.5 % of their radius.
std::string collision_text(const Shape& s, int number, const std::string& contact) {
  Random random(static_cast<unsigned>(number) + 1);
  const double centimetre = 0.01;
  const double volume = superellipsoid_volume(s.half_axes, s.e1, s.e2) * std::pow(centimetre, 3);
  const double mass = 0.5 * 1000 * volume, radius = std::cbrt(volume / (4 * M_PI / 3));
  const double stiffness = mass / std::pow(0.005 * radius, 2);
  std::uniform_real_distribution<double> draw(-0.25, 0.25);
  std::string text = fmt::format(
      "[simulation]\nend = 10\nsteps_per_contact = 400\ntop_speed = 1\nmax_overlap = 0.9\n[domain]\nmin = [-1, -1, "
      "-1]\nmax = [1, 1, 1]\n"
      "[contact]\ntangential = \"none\"\n{}[[materials]]\nname = \"m\"\ndensity = 1000\nstiffness = {}\n"
      "restitution = 1\n",
      contact, stiffness);
  const sc_vec half_axes = sc_scale(centimetre, sc_make_vec(s.half_axes[0], s.half_axes[1], s.half_axes[2]));
  const Form form = make_form(s.half_axes, s.e1, s.e2);
  for (const double side : {-1.0, 1.0}) {
    const sc_vec turn = any_vec(random);
    const sc_body_shape body{form.shape, bounding_radius(s.half_axes, s.e1, s.e2), sc_quat_mat(sc_quat_of_turn(turn))};
    const double y = draw(random), z = draw(random);
    const sc_vec at =
        sc_scale(centimetre, sc_make_vec(side * (0.01 + sc_support_in_world(body, sc_make_vec(1, 0, 0)).value), y, z));
    text += fmt::format(
        "[[particles]]\nmaterial = \"m\"\nshape = \"superellipsoid\"\nhalf_axes = {}\nexponents = [{}, {}]\n"
        "insert = \"positions\"\npositions = [{}]\nvelocity = [{}, 0, 0]\norientation = {{ axis = {}, angle = {} }}\n",
        vector_text(half_axes), s.e1, s.e2, vector_text(at), -0.5 * side, vector_text(turn), sc_norm(turn));
  }
  return text;
}

double motion_energy(Simulation& s) {
  const Measured m = measure(s.sample(), Fields{}, 0, {});
  return m.kinetic + m.rotational;
}

/// By how much the energy of motion has changed after the collision, over what it was; negative if they miss.
double energy_error(const std::string& text) {
  Simulation s(parse_case(text, "collision.toml"), Team{1});
  const double before = motion_energy(s);
  int touching = 0, since = 0;
  for (int step = 0; step < 200000 && since < 800; ++step) {
    s.step();
    const bool acts = s.findings().contacts > 0;
    touching += acts;
    since = acts || touching == 0 ? 0 : since + 1;
  }
  return touching == 0 ? -1 : std::abs(motion_energy(s) / before - 1);
}

void print_energy(const Shape& s, int count) {
  const auto row = [&](const std::string& name, const std::string& contact) {
    std::vector<double> errors;
    int missed = 0;
    for (int k = 0; k < count; ++k) {
      const double error = energy_error(collision_text(s, k, contact));
      if (error < 0)
        ++missed;
      else
        errors.push_back(error);
    }
    fmt::print("| {} | {} | {} | {:.1e} | {:.1e} |\n", s.name, name, missed, part_of(errors, .5), part_of(errors, 1));
  };
  for (const int side : {20, 40, 80})
    row(fmt::format("{} x {} mixed", side, side),
        fmt::format("detection = \"vertices\"\nvertices = {}\nspacing = \"mixed\"\n", side));
  row("certified", "");
}

}  // namespace

int main(int argc, char** argv) {
  const int pairs = argc > 1 ? std::max(10, std::atoi(argv[1])) : 400;
  for (const double depth : {0.005, 0.02}) {
    fmt::print("\nOverlap {:g} % of the least half axis:\n\n", 100 * depth);
    fmt::print(
        "| shape | vertices | missed | depth over the true one, 5 / 50 / 95 % | normal off by [deg], 50 / 95 % | us "
        "|\n");
    fmt::print("|---|---|---|---|---|---|\n");
    for (const Shape& s : shapes) print_geometry(s, depth, pairs);
  }
  fmt::print(
      "\n{} elastic collisions each:\n\n| shape | vertices | passed through | median | largest "
      "|\n|---|---|---|---|---|\n",
      std::max(3, pairs / 20));
  for (const Shape& s : shapes) print_energy(s, std::max(3, pairs / 20));
}
