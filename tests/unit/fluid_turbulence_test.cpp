// Models of the eddies that the cells cannot show, on fields where their viscosity is known.
#include <gtest/gtest.h>

#include <random>

#include "scree/fluid/fields.h"
#include "scree/fluid/turbulence.h"
#include "support/flows.h"
#include "support/foreign_leaks.h"

namespace scree::test {
namespace {

using Place = std::array<double, 3>;
using Model = TurbulenceSettings::Model;

/// A box whose whole boundary has the velocity that it also begins with.
std::unique_ptr<FluidSolver> box_with(const std::array<PlaceFormula, 3>& velocity, TurbulenceSettings turbulence,
                                      double ratio, double density = 1) {
  FluidRegion region = box_region({6, 6, 6}, {6, 6, 6}, {false, false, false});
  region.grid.faces[1] = graded_faces(0, {{6, 6, ratio}});
  FluidSettings k;
  k.density = density;
  k.viscosity = 1e-3;
  k.turbulence = turbulence;
  for (int a = 0; a < 3; ++a)
    for (const bool upper : {false, true}) {
      add_patch(region, PatchKind::inlet, a, upper);
      k.patches.push_back({velocity, {}});
    }
  auto s = std::make_unique<FluidSolver>(region, k, Ranks());
  set_velocity(*s, velocity);
  return s;
}

double eddies_at(const FluidSolver& s, int i, int j, int k) { return s.work.eddies[s.mesh.index(i, j, k)]; }

TEST(Turbulence, ShearOfSmagorinskyIsExactAndRotationHasNone) {
  TurbulenceSettings k;
  k.model = Model::smagorinsky;
  k.constant = 0.2;
  for (const double drift : {0.0, 7.0}) {
    const auto shear = box_with(
        {[=](const Place& x, double) { return 3 * x[1] + drift; }, constant(drift), constant(-drift)}, k, 2, 1.5);
    for_each_cell(shear->mesh, [&](std::int64_t c, const Place& x) {
      int j = 0;
      while (shear->region.grid.faces[1][j + 1] < x[1]) ++j;
      const double size = std::cbrt(shear->region.grid.width(1, j));
      EXPECT_NEAR(shear->work.eddies[c], 1.5 * 0.2 * 0.2 * size * size * 3, 1e-12 * (1 + drift));
    });
  }
  const auto rotation = box_with(
      {[](const Place& x, double) { return -2 * x[1]; }, [](const Place& x, double) { return 2 * x[0]; }, {}}, k, 2);
  for_each_cell(rotation->mesh, [&](std::int64_t c, const Place&) { EXPECT_LT(rotation->work.eddies[c], 1e-13); });
}

TEST(Turbulence, EddiesSpreadHeatByTheirPrandtlNumber) {
  const FluidRegion region = box_region({1, 4, 1}, {1, 4, 1}, {true, true, true});
  FluidSettings k;
  k.density = 2;
  k.viscosity = 0.1;
  k.turbulence.model = Model::smagorinsky;
  k.scalars.resize(1);
  k.scalars[0].capacity = 6;
  k.scalars[0].conductivity = 0.5;
  k.scalars[0].turbulent_prandtl = 0.75;
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {[](const Place& x, double) { return std::sin(pi / 2 * x[1]); }, {}, {}});
  advance(s, 0.01);
  int stirred = 0;
  for_each_cell(s.mesh, [&](std::int64_t c, const Place&) {
    EXPECT_NEAR(s.work.scalars[0].conductivity[c], 0.5 + 6 / (2 * 0.75) * s.work.eddies[c], 1e-14);
    EXPECT_NEAR(s.work.viscosity[c], 0.1 + s.work.eddies[c], 1e-15);
    stirred += s.work.eddies[c] > 1e-3;
  });
  EXPECT_GT(stirred, 1);
}

TEST(Turbulence, TheConstantOfAStrainIsFound) {
  // u = (x, y, -2 z) on cells of width 1: L = diag(1, 1, 4) / 2, |S| = sqrt(12), M = -6 |S| S, so that
  // C = -(1 + 1 - 8) / (12 |S| 6) = 1 / (12 |S|), and C |S| = 1 / 12.
  TurbulenceSettings k;
  k.model = Model::dynamic;
  for (const double drift : {0.0, 5.0}) {
    const std::array<PlaceFormula, 3> strain = {[=](const Place& x, double) { return x[0] + drift; },
                                                [](const Place& x, double) { return x[1]; },
                                                [](const Place& x, double) { return -2 * x[2]; }};
    EXPECT_NEAR(eddies_at(*box_with(strain, k, 1, 1.5), 2, 3, 2), 1.5 / 12, 1e-12);
  }
  // In a laminar shear flow it is 0.
  const auto shear = box_with({[](const Place& x, double) { return 3 * x[1]; }, {}, {}}, k, 1);
  EXPECT_NEAR(eddies_at(*shear, 2, 3, 2), 0, 1e-12);
}

/// A periodic box with a random flow; `fraction` for a void fraction that varies.
std::unique_ptr<FluidSolver> random_box(TurbulenceSettings turbulence, bool fraction, double viscosity = 100) {
  const FluidRegion region = box_region({5, 4, 6}, {5, 4, 6}, {true, true, true});
  FluidSettings k;
  k.turbulence = turbulence;
  k.viscosity = viscosity;  // with much of it eddies that give energy back are not cut off
  if (fraction) k.void_fraction = [](const Place& x, double) { return 0.5 + 0.07 * x[0]; };
  auto s = std::make_unique<FluidSolver>(region, k, Ranks());
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> some(-1, 1);
  std::array<PlaceFormula, 3> u;
  for (PlaceFormula& f : u) f = [&](const Place&, double) { return some(draw); };
  set_velocity(*s, u);
  return s;
}

/// C |S| of every cell by the formulas as they are written, with sums over 27 cells.
class ByHand {
 public:
  explicit ByHand(const FluidSolver& s) : s_(s), size_(s.mesh.n) {}

  using Cell = std::array<int, 3>;
  using Value = std::function<double(const Cell&)>;

  std::int64_t place(Cell at) const {
    for (int a = 0; a < 3; ++a) at[a] = (at[a] + size_[a]) % size_[a];
    return s_.mesh.index(at[0], at[1], at[2]);
  }
  double velocity(int a, const Cell& at) const { return s_.state.velocity[a][place(at)]; }
  double strain(int a, int b, const Cell& at) const {
    const auto slope = [&](int component, int axis) {
      Cell low = at, high = at;
      --low[axis];
      ++high[axis];
      return 0.5 * (velocity(component, high) - velocity(component, low));
    };
    double out = 0.5 * (slope(a, b) + slope(b, a));
    if (a == b) out -= (slope(0, 0) + slope(1, 1) + slope(2, 2)) / 3;
    return out;
  }
  double magnitude(const std::function<double(int, int)>& of) const {
    double sum = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) sum += of(a, b) * of(a, b);
    return std::sqrt(2 * sum);
  }
  double mean(const Value& value, const Cell& at) const {
    double sum = 0, weights = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const Cell c = {at[0] + i, at[1] + j, at[2] + k};
          const double weight = (i ? 0.5 : 1) * (j ? 0.5 : 1) * (k ? 0.5 : 1) * s_.state.fraction[place(c)];
          sum += weight * value(c);
          weights += weight;
        }
    return sum / weights;
  }
  /// L:M and M:M.
  std::array<double, 2> scales(const Cell& at) const {
    const auto wide = [&](int a, int b) { return mean([&](const Cell& c) { return strain(a, b, c); }, at); };
    std::array<double, 2> out{};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const double l = mean([&](const Cell& c) { return velocity(a, c) * velocity(b, c); }, at) -
                         mean([&](const Cell& c) { return velocity(a, c); }, at) *
                             mean([&](const Cell& c) { return velocity(b, c); }, at);
        const double m =
            2 * (mean([&](const Cell& c) { return size(c) * strain(a, b, c); }, at) - 4 * magnitude(wide) * wide(a, b));
        out[0] += l * m;
        out[1] += m * m;
      }
    return out;
  }
  /// |S| of a cell of width 1.
  double size(const Cell& c) const {
    return magnitude([&](int a, int b) { return strain(a, b, c); });
  }

 private:
  const FluidSolver& s_;
  Cell size_;
};

TEST(Turbulence, TheDynamicModelIsWhatItsFormulasSay) {
  for (const bool fraction : {false, true})
    for (const bool whole : {false, true}) {
      TurbulenceSettings k;
      k.model = Model::dynamic;
      k.along = {whole, true, whole};
      const auto s = random_box(k, fraction);
      const ByHand by_hand(*s);
      const int i = 3, z = 2;
      std::array<double, 2> sum{};
      for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 4; ++y)
          for (int w = 0; w < 6; ++w) {
            if (!whole && (x != i || w != z)) continue;
            const auto one = by_hand.scales({x, y, w});
            for (int q = 0; q < 2; ++q) sum[q] += one[q];
          }
      for (int y = 0; y < 4; ++y)
        EXPECT_NEAR(eddies_at(*s, i, y, z), sum[0] / sum[1] * by_hand.size({i, y, z}), 1e-11) << fraction << whole;
    }
}

TEST(Turbulence, TheViscosityIsNeverNegative) {
  TurbulenceSettings k;
  k.model = Model::dynamic;
  const auto free = random_box(k, false), thin = random_box(k, false, 0.01);
  int cut = 0;
  for_each_cell(thin->mesh, [&](std::int64_t c, const Place&) {
    EXPECT_NEAR(thin->work.viscosity[c], std::max(0.0, 0.01 + free->work.eddies[c]), 1e-13);
    cut += free->work.eddies[c] < -0.01;
  });
  EXPECT_GT(cut, 0);
}

TEST(Turbulence, PathsBeginWithTheCellsAroundAndForgetThem) {
  TurbulenceSettings k;
  k.model = Model::dynamic;
  const auto around = random_box(k, false);
  k.lagrangian = true;
  const auto s = random_box(k, false);
  const ByHand by_hand(*s);
  const auto mean = [&](int q) { return by_hand.mean([&](const auto& c) { return by_hand.scales(c)[q]; }, {1, 2, 3}); };
  EXPECT_NEAR(eddies_at(*around, 1, 2, 3), mean(0) / mean(1) * by_hand.size({1, 2, 3}), 1e-11);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(eddies_at(*s, i, 2, 3), std::max(0.0, eddies_at(*around, i, 2, 3)), 1e-12);
  // After a long time only what is there counts.
  find_eddies(*s, 1e12);
  int cut = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j) {
      const auto scales = by_hand.scales({i, j, 3});
      EXPECT_NEAR(eddies_at(*s, i, j, 3), std::max(0.0, scales[0] / scales[1]) * by_hand.size({i, j, 3}), 1e-9);
      cut += scales[0] < 0;
    }
  EXPECT_GT(cut, 0);
  EXPECT_LT(cut, 20);
}

TEST(Turbulence, EddiesTakeEnergyAndKeepMomentum) {
  const auto energy_after = [](Model model) {
    const FluidRegion region = box_region({2 * pi, 2 * pi, 2 * pi}, {12, 12, 12}, {true, true, true});
    FluidSettings k;
    k.viscosity = 1e-3;
    k.convection = SC_SYMMETRIC;
    k.turbulence.model = model;
    k.turbulence.lagrangian = true;
    FluidSolver s(region, k, Ranks());
    set_velocity(s, {[](const Place& x, double) { return std::sin(x[0]) * std::cos(x[1]) * std::cos(x[2]) + 0.3; },
                     [](const Place& x, double) { return -std::cos(x[0]) * std::sin(x[1]) * std::cos(x[2]); },
                     {}});
    const FluidMeasured before = measure(s);
    run(s, 6, 0.1);
    const FluidMeasured after = measure(s);
    EXPECT_NEAR(after.momentum[0], before.momentum[0], 1e-9 * before.mass);
    EXPECT_LT(std::abs(s.state.books.error[0]), 1e-9 * before.mass);
    return after.kinetic / before.kinetic;
  };
  const double without = energy_after(Model::none), constant = energy_after(Model::smagorinsky),
               dynamic = energy_after(Model::dynamic);
  EXPECT_LT(constant, without - 0.05);
  EXPECT_LT(dynamic, without - 0.05);
}

}  // namespace
}  // namespace scree::test
