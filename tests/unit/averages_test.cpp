// Coarse graining: the kernel loses nothing, and the fields are those of known states.
#include "scree/analysis/averages.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numeric>
#include <random>

#include "engine_cases.h"
#include "sample_by_hand.h"
#include "scree/particles/contact_forces.h"

namespace scree {
namespace {

using namespace test;

using Point = std::array<double, 3>;

const CellGrid3 grid{{-1, 0, 2}, {2, 1, 4}, {6, 4, 5}, {false, false, false}};

double sum(const Spread& s) { return std::accumulate(s.share.begin(), s.share.end(), 0.0); }

std::vector<double> in_cells(const CoarseGrain& grain, const CellGrid3& g, const std::vector<Spread>& all) {
  std::vector<double> out(g.size());
  for (const Spread& s : all)
    grain.deliver(s, 0, std::int64_t{g.cells[1]} * g.cells[2], [&](std::int64_t c, double share) { out[c] += share; });
  return out;
}

TEST(CoarseGrain, SharesOfAPointAddUpToOneAndHaveItsPlaceAsTheirMean) {
  const CoarseGrain grain(grid);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  for (int n = 0; n < 200; ++n) {
    const Point x{-1 + 3 * u(random), u(random), 2 + 2 * u(random)};
    const Spread s = grain.point(x);
    EXPECT_NEAR(sum(s), 1, 1e-14);
    Point mean{};
    for (int i = 0; i < 27; ++i) {
      EXPECT_GE(s.share[i], 0);
      const int place[3] = {i % 3, i / 3 % 3, i / 9};
      for (int k = 0; k < 3; ++k)
        mean[k] += s.share[i] * (grid.min[k] + (s.corner[k] + place[k] + 0.5) * grid.spacing(k));
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], x[k], 1e-13);
  }
}

TEST(CoarseGrain, SpreadsALineAsItsPointsAre) {
  for (const bool around : {false, true}) {
    CellGrid3 g = grid;
    g.periodic = {around, false, around};
    const CoarseGrain grain(g);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> u(-0.3, 1.3);
    std::vector<Spread> pieces;
    for (int n = 0; n < 30; ++n) {
      const Point a{-1 + 3 * u(random), u(random), 2 + 2 * u(random)},
          b{-1 + 3 * u(random), u(random), 2 + 2 * u(random)};
      const Point d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      grain.line(a, d, pieces);
      const std::vector<double> exact = in_cells(grain, g, pieces);
      std::vector<Spread> points;
      const int parts = 4000;
      int inside = 0;
      for (int k = 0; k < parts; ++k) {
        const double t = (k + 0.5) / parts;
        const Point x{a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
        if (!grain.contains(x)) continue;
        ++inside;
        points.push_back(grain.point(x));
      }
      const std::vector<double> brute = in_cells(grain, g, points);
      for (std::size_t c = 0; c < g.size(); ++c) EXPECT_NEAR(exact[c], brute[c] / parts, 3e-4);
      // The shares add up to the length inside, which the brute force knows to one part in thousands.
      EXPECT_NEAR(std::accumulate(exact.begin(), exact.end(), 0.0), static_cast<double>(inside) / parts, 2.0 / parts);
    }
  }
}

TEST(CoarseGrain, LosesNothingOfALineInside) {
  const CoarseGrain grain(grid);
  std::vector<Spread> pieces;
  // Along faces of cells, from corner to corner, and of no length along an axis.
  for (const auto& [a, d] : std::vector<std::pair<Point, Point>>{{{-1, 0, 2}, {3, 1, 2}},
                                                                 {{-0.5, 0.25, 2.4}, {1, 0, 0}},
                                                                 {{0.1, 0.2, 3.3}, {1e-9, 0.5, -0.4}},
                                                                 {{0, 0.5, 2.8}, {0, 0, 0.4}}}) {
    grain.line(a, d, pieces);
    double total = 0;
    for (const Spread& s : pieces) total += sum(s);
    EXPECT_NEAR(total, 1, 1e-14);
  }
}

/// n^3 particles on a lattice of spacing 1 that fills a periodic box.
std::vector<Grain> lattice(int n, double radius) {
  std::vector<Grain> out;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) out.push_back({{i + 0.3, j + 0.3, k + 0.3}, {}, radius});
  return out;
}

const Domain box{{0, 0, 0}, {6, 6, 6}, {true, true, true}};

const AverageField& field(const std::vector<AverageField>& all, const std::string& name) {
  for (const AverageField& f : all)
    if (f.name == name) return f;
  throw std::logic_error("no field " + name);
}

Averages average_of(const CellGrid3& g, const Sample& sample) {
  Averages a = start_averages(g);
  add_sample(a, sample);
  return a;
}

TEST(Averages, OfALatticeAreExactInEveryCell) {
  const double volume = sphere_volume(1);
  for (const bool periodic : {true, false}) {
    const CellGrid3 g{{0, 0, 0}, {6, 6, 6}, {6, 3, 2}, {periodic, periodic, periodic}};
    const auto fields = fields_of(average_of(g, sample_of(box, lattice(6, 0.5))));
    for (std::size_t c = 0; c < g.size(); ++c) {
      if (!periodic) break;  // at the ends shares are folded, and the lattice is not symmetric about them
      EXPECT_NEAR(field(fields, "solid_fraction").values[c], volume, 1e-12);
      EXPECT_NEAR(field(fields, "number_density").values[c], 1, 1e-12);
      EXPECT_NEAR(field(fields, "density").values[c], 1000 * volume, 1e-9);
    }
    const auto& number = field(fields, "number_density").values;
    EXPECT_NEAR(std::accumulate(number.begin(), number.end(), 0.0) * g.cell_volume(), 216, 1e-10);
  }
}

TEST(Averages, HaveTheVelocityOfAShearFlowAndTheTemperatureOfAGas) {
  std::vector<Grain> grains = lattice(6, 0.3);
  const double u[3] = {0.5, 0.2, 0.1};
  for (std::size_t i = 0; i < grains.size(); ++i) {
    // Neighbours move against each other, so that a cell of two by two by two has no mean; the shear is along z.
    const Point& x = grains[i].x;
    const double sign = (static_cast<int>(x[0]) + static_cast<int>(x[1])) % 2 ? 1 : -1;
    grains[i].v = {3 * x[2] + sign * u[0], sign * u[1], sign * u[2]};
  }
  const CellGrid3 g{{0, 0, 0}, {6, 6, 6}, {3, 3, 6}, {true, true, false}};
  const auto fields = fields_of(average_of(g, sample_of(box, grains)));
  const double rho = 1000 * sphere_volume(0.6);
  for (std::size_t c = 0; c < g.size(); ++c) {
    const double layer = std::floor(static_cast<double>(c) / 9);
    if (layer == 0 || layer == 5) continue;
    EXPECT_NEAR(field(fields, "velocity").values[3 * c], 3 * (layer + 0.5), 1e-12);
    EXPECT_NEAR(field(fields, "velocity").values[3 * c + 1], 0, 1e-12);
    EXPECT_NEAR(field(fields, "solid_flux").values[3 * c], 3 * (layer + 0.5) * rho, 1e-9);
    // v' v' of the to and fro, and of the shear within the kernel, whose variance on this lattice is 1/4.
    const double within = 9 * 0.25;
    const double* stress = &field(fields, "kinetic_stress").values[9 * c];
    EXPECT_NEAR(stress[0], rho * (u[0] * u[0] + within), 1e-9);
    EXPECT_NEAR(stress[1], rho * u[0] * u[1], 1e-10);
    EXPECT_NEAR(stress[3], rho * u[0] * u[1], 1e-10);
    EXPECT_NEAR(stress[8], rho * u[2] * u[2], 1e-10);
    EXPECT_NEAR(field(fields, "temperature").values[c], (0.25 + 0.04 + 0.01 + within) / 3, 1e-12);
  }
}

TEST(Averages, LeaveOutWhatIsOutsideOrFixed) {
  std::vector<Grain> grains = {{{1, 1, 1}}, {{5, 5, 5}}, {{2.5, 2.5, 2.5}}};
  Sample s = sample_of(box, grains);
  s.system.particles.motion.row(2)[lane::inverse_mass] = 0;
  const Averages a = average_of({{0, 0, 0}, {3, 3, 3}, {3, 3, 3}, {}}, s);
  double number = 0;
  for (std::size_t c = 0; c < 27; ++c) number += a.sums[sum_of::count * c];
  EXPECT_NEAR(number, 1, 1e-14);
  const auto fields = fields_of(average_of({{2.9, 0, 0}, {6, 2, 2}, {1, 1, 1}, {}}, s));
  EXPECT_EQ(field(fields, "density").values[0], 0);
  EXPECT_TRUE(std::isnan(field(fields, "velocity").values[0]));
  EXPECT_TRUE(std::isnan(field(fields, "temperature").values[0]));
}

const LawChoice plain = {"plain", "normal = \"linear\"\ntangential = \"history\"\n", "friction = 0.5\n"};

/// Sum over all cells of the contact stress: that of minus force times branch over all contacts.
TEST(Averages, HoldTheStressOfEveryContact) {
  Simulation s(case_of(crowd_text(plain, 120, 0.03), {"output.contacts=true"}), 1);
  advance(s, 600);
  const Sample& sample = s.sample();
  std::array<double, 9> expected{};
  for (const ContactForce& c : contact_forces(sample)) {
    const double f[3] = {c.force.x, c.force.y, c.force.z}, l[3] = {c.branch.x, c.branch.y, c.branch.z};
    for (int n = 0; n < 9; ++n) expected[n] -= f[n / 3] * l[n % 3];
  }
  const Averages a = average_of({{0, 0, 0}, {0.03, 0.03, 0.03}, {5, 4, 6}, {}}, sample);
  std::array<double, 9> found{};
  std::array<double, 3> wall{};
  for (std::size_t c = 0; c < a.grid.size(); ++c) {
    for (int n = 0; n < 9; ++n) found[n] += a.sums[sum_of::count * c + sum_of::contact + n];
    for (int k = 0; k < 3; ++k) wall[k] += a.sums[sum_of::count * c + sum_of::wall_force + k];
  }
  for (int n = 0; n < 9; ++n) EXPECT_NEAR(found[n], expected[n], 1e-11 * expected[8]);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(wall[k], -sample.wall_loads[0].force[k], 1e-11);
}

TEST(CoarseGrain, HasThePointsOfItsBorderUpToRounding) {
  const CoarseGrain grain(grid);
  const double up = std::nextafter(2.0, 3.0), down = std::nextafter(-1.0, -2.0);
  for (const Point& x : {Point{up, 0.3, 3}, Point{down, 1, 2}, Point{2, std::nextafter(1.0, 2.0), 4}}) {
    EXPECT_FALSE(grain.contains(x));
    EXPECT_TRUE(grain.contains(grain.at_border(x)));
    EXPECT_NEAR(sum(grain.point(grain.at_border(x))), 1, 1e-14);
  }
  // Beyond rounding it is outside, and inside nothing changes.
  EXPECT_FALSE(grain.contains(grain.at_border({2 + 1e-6, 0.3, 3})));
  EXPECT_EQ(grain.at_border({0.1, 0.2, 2.3}), (Point{0.1, 0.2, 2.3}));
}

/// A grid that ends where the walls do has all their force, wherever rounding puts the contact points of a drum that
/// turns.
TEST(Averages, OfAFullContainerHoldTheForceOfItsWalls) {
  Simulation s(case_of("[simulation]\nend = 1\ntime_step = 5e-6\nmax_overlap = 0.9\n[domain]\n"
                       "min = [-0.001, -0.02, -0.02]\nmax = [0.021, 0.02, 0.02]\n[gravity]\ntype = "
                       "\"uniform\"\nacceleration = [50, 0, 0]\n[contact]\nnormal = \"linear\"\n"
                       "[[materials]]\nname = \"a\"\ndensity = 2000\nstiffness = 2000\nfriction = 0.5\n"
                       "[[particles]]\nmaterial = \"a\"\ninsert = \"random\"\ncount = 250\ndiameter = 0.0021\n"
                       "region_min = [0.0001, -0.012, -0.012]\nregion_max = [0.0199, 0.012, 0.012]\n"
                       "velocity = { type = \"random\", deviation = 2 }\n[[walls]]\nname = \"drum\"\n"
                       "type = \"cylinder\"\nmaterial = \"a\"\nstart = [0, 0, 0]\nend = [0.02, 0, 0]\n"
                       "radius = 0.0171\nclosed = true\n"
                       "motion = { type = \"rotation\", axis = [1, 0, 0], angular_velocity = 300 }\n",
                       {"output.contacts=true"}),
               1);
  int contacts = 0;
  for (int round = 0; round < 40; ++round) {
    advance(s, 80);
    const Sample& sample = s.sample();
    const Averages a = average_of({{0, -0.0171, -0.0171}, {0.02, 0.0171, 0.0171}, {3, 4, 4}, {}}, sample);
    std::array<double, 3> found{};
    for (std::size_t c = 0; c < a.grid.size(); ++c)
      for (int k = 0; k < 3; ++k) found[k] += a.sums[sum_of::count * c + sum_of::wall_force + k];
    double size = 0;
    for (const ContactForce& c : contact_forces(sample))
      if (c.at_wall()) {
        size += sc_norm(c.force);
        ++contacts;
      }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], -sample.wall_loads[0].force[k], 1e-12 * size);
  }
  EXPECT_GT(contacts, 50);
}

TEST(Averages, DoNotDependOnThreads) {
  std::vector<std::vector<double>> sums;
  for (const int threads : {1, 3}) {
    Simulation s(case_of(crowd_text(plain, 120, 0.03), {"output.contacts=true"}), threads);
    advance(s, 300);
    omp_set_num_threads(threads);
    sums.push_back(average_of({{0, 0, 0}, {0.03, 0.02, 0.03}, {3, 4, 5}, {}}, s.sample()).sums);
  }
  omp_set_num_threads(1);
  EXPECT_TRUE(sums[0] == sums[1]);
}

/// Columns of eight spheres that settle onto a floor, across periodic sides: each height carries the weight above it.
TEST(Averages, OfASettledColumnCarryTheWeightAbove) {
  Simulation s(case_of("[simulation]\nend = 1\ntime_step = 5e-5\n[domain]\nmin = [0, 0, 0]\nmax = [0.04, 0.04, 0.1]\n"
                       "periodic = [true, true, false]\n[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -10]\n"
                       "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 2000\nrestitution = 0.05\n"
                       "[[particles]]\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"lattice\"\n"
                       "region_min = [0, 0, 0]\nregion_max = [0.04, 0.04, 0.08]\nspacing = 0.01\ncount = 128\n"
                       "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\n"
                       "normal = [0, 0, 1]\n[output]\ncontacts = true\n"),
               1);
  advance(s, 12000);
  const CellGrid3 g{{0, 0, 0}, {0.04, 0.04, 0.1}, {2, 2, 10}, {true, true, false}};
  const auto fields = fields_of(average_of(g, s.sample()));
  const auto& density = field(fields, "density").values;
  const auto& stress = field(fields, "contact_stress").values;
  const auto& wall = field(fields, "wall_force").values;
  const double layer = g.spacing(2), floor = 128 * 2500 * sphere_volume(0.01) * 10 / (0.04 * 0.04);
  double weight = 0;
  for (int k = 9; k >= 0; --k) {
    // The columns lean on each other, so that only a whole layer carries what is above it.
    double own = 0, carried = 0;
    for (int column = 0; column < 4; ++column) {
      const std::size_t c = static_cast<std::size_t>(column + 4 * k);
      own += 0.25 * density[c] * 10 * layer;
      carried += 0.25 * stress[9 * c + 8];
    }
    if (k >= 1 && k < 7) {
      EXPECT_NEAR(carried, weight + 0.5 * own, 0.01 * floor) << k;
      EXPECT_NEAR(carried, (8 - (k + 0.5)) / 8 * floor, 0.01 * floor) << k;
    }
    weight += own;
  }
  EXPECT_NEAR(weight, floor, 1e-9 * floor);
  double pushed = 0;
  for (std::size_t c = 0; c < g.size(); ++c) pushed += wall[3 * c + 2] * g.cell_volume();
  EXPECT_NEAR(pushed, floor * 0.04 * 0.04, 1e-5 * pushed);
  // The floor's force is spread over the lowest cells only.
  for (std::size_t c = 8; c < g.size(); ++c) EXPECT_EQ(wall[3 * c + 2], 0);
}

}  // namespace
}  // namespace scree
