// Particles in a fluid that is solved for: what is conserved, and closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/coupled_cloud.h"
#include "support/fine_dust.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

TEST(FluidCoupling, MomentumOfFluidAndParticlesIsConstantWhateverTheSubcycling) {
  EXPECT_LT(drift_of({.subcycles = 1}, 300), 1e-12);
  EXPECT_LT(drift_of({.subcycles = 7}, 10000), 1e-12);
  EXPECT_LT(drift_of({.density = 200, .viscosity = 0.1, .stiffness = 24, .subcycles = 10}, 1000),
            1e-12);                                                                    // light, strongly dragged
  EXPECT_LT(drift_of({.density = 5, .stiffness = 0.7, .subcycles = 3}, 1000), 1e-12);  // the fluid lags behind
}

/// Each part of the exchange matters: without it momentum is lost by far more than rounding.
TEST(FluidCoupling, MomentumIsLostWithAnyPartOfTheExchange) {
  const Cloud cloud = {.subcycles = 7};
  Cloud one_sided = cloud;
  one_sided.coupling += "\npressure_force = false";  // the fluid pushes particles aside, they do not feel it
  EXPECT_GT(drift_of(one_sided, 300), 1e-6);
  const auto forget_promise = [](Particles& p) {  // so that all of what they receive is handed back once more
    for (std::size_t i = 0; i < p.size(); ++i) std::fill_n(p.expected.row(i), 3, 0.0);
  };
  EXPECT_GT(drift_of(cloud, 300, forget_promise), 1e-6);
  const auto forgive = [](Particles& p) {  // what they have received beyond the promise
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int a = 0; a < 3; ++a)
        p.expected.row(i)[a] = p.drag_impulse.row(i)[a] + p.mass[i] * p.drag_impulse.row(i)[3] * p.pull.row(i)[a];
  };
  EXPECT_GT(drift_of(cloud, 300, forgive), 1e-8);
}

TEST(FluidCoupling, VolumeIsConserved) {
  for (const Cloud& cloud : {Cloud{.subcycles = 5}, Cloud{.density = 5, .stiffness = 0.7, .subcycles = 5}}) {
    Simulation s(case_of(cloud.text()), 1);
    for (int n = 0; n < (cloud.density > 5 ? 10000 : 500); ++n) s.step();
    const FluidSolver& f = s.coupling()->fluid;
    const double solids = 150 * std::numbers::pi / 6 * std::pow(0.002, 3);
    EXPECT_NEAR(f.state.books.content[3], std::pow(0.02, 3) - solids, 1e-13 * std::pow(0.02, 3));
    EXPECT_LT(std::abs(f.state.books.error[3]), 1e-12 * std::pow(0.02, 3));
    EXPECT_LT(s.coupling()->report.divergence, 1e-8);
    EXPECT_EQ(s.coupling()->way.part < 1, cloud.density == 5);
  }
}

/// Fluid and particles relax towards each other as two bodies, without growth, for any ratio of masses and any drag.
TEST(FluidCoupling, DragOfARestingCloudRelaxesAsTwoBodiesDo) {
  for (const double density : {10.0, 288.0, 2e4, 5.8e5})
    for (const double drag : {1e-4, 1e-3, 0.1, 1.0, 50.0}) {
      SCOPED_TRACE(fmt::format("density {} drag {}", density, drag));
      const double d = 0.002, dt = 1e-4, volume = std::pow(0.02, 3);
      const double mass = density * std::numbers::pi / 6 * d * d * d;
      const double viscosity = drag * mass / dt / (3 * std::numbers::pi * d);
      std::string text = fmt::format(R"toml(
[simulation]
end = 1
time_step = 1e-4
[domain]
min = [0, 0, 0]
max = [0.02, 0.02, 0.02]
periodic = [true, true, true]
[contact]
normal = "linear"
[[materials]]
name = "grain"
density = {}
stiffness = {}
restitution = 0.8
[[particles]]
name = "cloud"
material = "grain"
diameter = 0.002
insert = "lattice"
spacing = 0.005
velocity = [0.1, 0, 0]
region_min = [0, 0, 0]
region_max = [0.02, 0.02, 0.02]
[fluid]
type = "incompressible"
density = 10
viscosity = {}
cells = [4, 4, 4]
correctors = 3
divergence_tolerance = 1e-13
[coupling]
drag = "stokes"
subcycles = 1
)toml",
                                     density, 1e-4 * density, viscosity);
      Simulation s(case_of(text), 1);
      const double count = double(s.system().particles.size());
      const double solids = count * mass, fluid = 10 * (volume - count * mass / density);
      const auto stream = [&] {
        return s.coupling()->fluid.state.velocity[0][s.coupling()->fluid.mesh.index(1, 1, 1)];
      };
      const auto speed = [&] { return s.system().particles.motion.row(0)[lane::vx]; };
      double all = 0;  // with the formula of two steps, which does not know the first
      double largest = 0, early = 0, late = 0, drift = 0;
      for (int n = 0; n < 60; ++n) {
        s.step();
        for (std::size_t i = 0; i < s.system().particles.size(); ++i)
          largest = std::max(largest, std::abs(s.system().particles.motion.row(i)[lane::vx]));
        double& slip = n < 30 ? early : late;
        slip = std::max(slip, std::abs(speed() - stream()));
        if (n == 0) all = momentum(s)[0];
        drift = std::max(drift, std::abs(momentum(s)[0] - all) / all);
      }
      EXPECT_LT(largest, 0.1 * (1 + 1e-9));
      EXPECT_LE(late, early + 1e-12 * 0.1);
      EXPECT_LT(drift, 1e-12);
      // Slip dies with the rate of both masses.
      const double u = stream(), v = speed();
      const double rate = drag / dt * (1 + solids / fluid), slip = 0.1 * std::exp(-rate * 60 * dt);
      if (rate * dt < 0.05) {
        EXPECT_NEAR((v - u) / 0.1, slip / 0.1, 0.03);
      } else {
        EXPECT_LT(std::abs(v - u) / 0.1, std::pow(1 + 0.05, -60) * 1.01);  // slower than this is no implicit rule
      }
      // Nothing else acts on them: they receive what the fluid has counted on.
      EXPECT_LT(std::abs(under_way(*s.coupling(), s.system().particles)[0]), 1e-12 * solids * 0.1);
    }
}

/// One sphere sinks in a closed box of water: what it has against the water around it is Stokes' velocity, for cells
/// from four diameters to one; and it gets there as an exponential does.
TEST(FluidCoupling, ASphereSinksWithStokesVelocity) {
  const double d = 1e-4, terminal = (2000.0 - 1000) * 9.81 * d * d / (18 * 1e-3);
  for (const int cells : {3, 6, 12}) {
    SCOPED_TRACE(cells);
    const std::string text = cube(cells, 2000, 1e-3, "diameter = 1e-4", "drag = \"stokes\"\nsubcycles = 4");
    Simulation s(case_of(text), 1);
    const auto slip = [&] {
      const Particles& p = s.system().particles;
      return p.stream.row(0)[2] - p.motion.row(0)[lane::vz];
    };
    const double mass_ratio = 2000.0 / 1000;
    const double time = mass_ratio * 1000 * d * d / (18 * 1e-3);
    for (int n = 0; n < 60; ++n) s.step();
    // Velocities belong to the middle of the step; the stream to the fluid's last step.
    EXPECT_NEAR(slip() / terminal, 1 - std::exp(-59.5 * 2e-5 / time), 0.03);
    for (int n = 0; n < 600; ++n) s.step();
    EXPECT_NEAR(slip() / terminal, 1, 0.01);
  }
}

/// Particles that follow the fluid make it heavier and leave it its viscosity, though they meet only means over cells:
/// a wave of shear, 16 cells long, fades as one of that fluid does.
TEST(FluidCoupling, FineParticlesLeaveAShearWaveItsViscosity) {
  Simulation s(
      case_of(dust::column("", "", R"x(velocity = ["1e-3 * sin(125 * pi * z)", "0", "0"])x", "drag = \"stokes\"")), 1);
  const double found = dust::fading(s, [&]() -> const Field& { return s.coupling()->fluid.state.velocity[0]; });
  const double phi = dust::solids, k = dust::wave_number;
  const double rate = (1 - phi) * 1e-3 * k * k / (1000 * (1 - phi) + 2500 * phi);
  // The cells and what the weights see only after two smoothings leave a tenth.
  EXPECT_NEAR(found / rate, 1, 0.15);
}

/// A particle that crosses cells pushes the fluid about, no more for shorter steps: largest pressure against the step.
double spike(const std::string& cells, double dt) {
  Simulation s(case_of(fmt::format(R"toml(
[simulation]
end = 100
time_step = {}
[domain]
min = [0, 0, 0]
max = [1, 12, 1]
periodic = [true, false, true]
[contact]
normal = "linear"
[[materials]]
name = "ball"
density = 1000
stiffness = 1e5
restitution = 0.8
[[particles]]
name = "ball"
material = "ball"
diameter = 0.49
insert = "positions"
positions = [[0.3, 3, 0.5]]
velocity = [0, 1, 0]
[fluid]
type = "incompressible"
density = 1
viscosity = 0
{}
divergence_tolerance = 1e-12
velocity = ["0", "0.2", "0"]
[[fluid.patches]]
name = "in"
face = "y_min"
type = "inlet"
velocity = ["0", "0.2", "0"]
[[fluid.patches]]
name = "out"
face = "y_max"
type = "outlet"
[coupling]
drag = "none"
subcycles = 1
diffusion = 0
pressure_force = false
)toml",
                                   dt, cells)),
               1);
  const int steps = static_cast<int>(std::lround(3 / dt));
  double largest = 0;
  for (int n = 0; n < steps; ++n) {
    s.step();
    if (n * dt < 0.5) continue;
    const FluidSolver& f = s.coupling()->fluid;
    for (int j = 0; j < f.mesh.n[1]; ++j)
      largest = std::max(largest, std::abs(f.state.pressure[f.mesh.index(0, j, 0)]));
  }
  return largest;
}

TEST(FluidCoupling, ThePressureOfACrossingParticleDoesNotGrowWithShorterSteps) {
  for (const char* cells : {"cells = [1, 12, 1]", "cells = [1, 12, 1]\ny = [{ to = 12, cells = 12, ratio = 3 }]"}) {
    SCOPED_TRACE(cells);
    const double coarse = spike(cells, 0.02), middle = spike(cells, 0.01), fine = spike(cells, 0.005);
    EXPECT_LT(middle / coarse, 1.3);
    EXPECT_LT(fine / middle, 1.3);
    EXPECT_GT(fine, 1e-3);
  }
}

}  // namespace
}  // namespace scree
