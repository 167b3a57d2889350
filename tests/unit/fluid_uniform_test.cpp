// Particles that go with a uniform flow leave it uniform, whatever the void fraction is.
#include <gtest/gtest.h>

#include "support/coupled_cloud.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

constexpr std::array<double, 3> stream = {0.3, -0.2, 0.1};
constexpr const char* particles_alike = "[0.3, -0.2, 0.1]";
constexpr const char* stream_alike = R"(["0.3", "-0.2", "0.1"])";

struct Found {
  double worst = 0;            // difference of the velocity from the stream, over its size
  double least = 1, most = 0;  // void fractions
  double pressure = 0;         // largest, over density * speed^2
  double part = 1;             // of what moves, that the fluid makes way for in the last step
};

Found run(Cloud cloud, int steps, std::array<double, 3> expected = stream) {
  Simulation s(case_of(cloud.text()), 1);
  Found out;
  const double speed = std::hypot(expected[0], expected[1], expected[2]);
  for (int n = 0; n < steps; ++n) {
    s.step();
    const FluidSolver& f = s.coupling()->fluid;
    for (int k = 0; k < f.mesh.n[2]; ++k)
      for (int j = 0; j < f.mesh.n[1]; ++j)
        for (int i = 0; i < f.mesh.n[0]; ++i) {
          const std::int64_t c = f.mesh.index(i, j, k);
          for (int a = 0; a < 3; ++a)
            out.worst = std::max(out.worst, std::abs(f.state.velocity[a][c] - expected[a]) / speed);
          out.least = std::min(out.least, f.state.fraction[c]);
          out.most = std::max(out.most, f.state.fraction[c]);
          out.pressure = std::max(out.pressure, std::abs(f.state.pressure[c]) / (10 * speed * speed));
        }
  }
  out.part = s.coupling()->way.part;
  return out;
}

Cloud uniform() {
  return {
      .subcycles = 4, .velocity = particles_alike, .stream = stream_alike, .accuracy = "divergence_tolerance = 1e-12"};
}

Found expect_uniform(const Cloud& cloud, int steps) {
  const Found found = run(cloud, steps);
  EXPECT_LT(found.worst, 1e-10);
  EXPECT_LT(found.pressure, 1e-8);
  EXPECT_GT(found.most - found.least, 0.02);
  return found;
}

TEST(FluidUniform, InEvenCells) { expect_uniform(uniform(), 200); }

TEST(FluidUniform, InGradedCells) {
  Cloud cloud = uniform();
  cloud.cells = R"(cells = [5, 4, 6]
x = [{ to = 0.02, cells = 5, ratio = 2 }]
z = [{ to = 0.01, cells = 3, ratio = 2 }, { to = 0.02, cells = 3, ratio = 0.5 }])";
  expect_uniform(cloud, 200);
}

/// The fluid follows light particles with a lag, uniformly too.
TEST(FluidUniform, WithParticlesLighterThanTheFluid) {
  Cloud cloud = uniform();
  cloud.density = 5;
  cloud.stiffness = 0.7;
  EXPECT_LT(expect_uniform(cloud, 200).part, 0.9);
}

TEST(FluidUniform, WithoutDragAndWithAnotherLaw) {
  Cloud cloud = uniform();
  for (const char* law : {R"(drag = "none")", R"(drag = "di_felice")"}) {
    cloud.coupling = law;
    expect_uniform(cloud, 100);
  }
}

/// Cells narrower than a diameter: what is shared out is spread further.
TEST(FluidUniform, InCellsOfHalfADiameter) {
  Cloud cloud = uniform();
  cloud.shape = "diameter = 0.004\ncount = 20";
  cloud.cells = "cells = [10, 10, 10]";
  expect_uniform(cloud, 40);
}

/// Bodies that tumble carry parts of their volume on ways of their own.
TEST(FluidUniform, WithBodiesThatTumble) {
  Cloud cloud = uniform();
  cloud.shape = R"(shape = "superellipsoid"
half_axes = [0.002, 0.001, 0.0008]
exponents = [0.8, 0.6]
orientation = "random"
angular_velocity = [40, -30, 20]
count = 30)";
  expect_uniform(cloud, 100);
}

/// Walls that let the fluid slip: the splines are folded there.
TEST(FluidUniform, BetweenWallsThatSlip) {
  Cloud cloud = uniform();
  cloud.periodic = "[true, false, false]";
  cloud.velocity = "[0.3, 0, 0]";
  cloud.stream = R"(["0.3", "0", "0"])";
  cloud.cells = "cells = [6, 5, 4]";
  for (const char* face : {"y_min", "y_max", "z_min", "z_max"})
    cloud.accuracy += fmt::format("\n[[fluid.patches]]\nname = \"{0}\"\nface = \"{0}\"\ntype = \"slip\"", face);
  const Found found = run(cloud, 200, {0.3, 0, 0});
  EXPECT_LT(found.worst, 1e-10);
  EXPECT_GT(found.most - found.least, 0.02);
}

/// Ten thousand particles of two kinds.
TEST(FluidUniform, WithTenThousandParticles) {
  Cloud cloud = uniform();
  cloud.subcycles = 10;
  cloud.stiffness = 0.3;
  cloud.shape = "diameter = { distribution = \"uniform\", min = 0.0003, max = 0.0005 }\ncount = 10000";
  cloud.cells = "cells = [10, 10, 10]";
  expect_uniform(cloud, 30);
}

}  // namespace
}  // namespace scree
