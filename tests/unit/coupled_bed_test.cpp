// A bed of beads under a liquid that rises too slowly to carry it: it settles and comes to rest.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scree/app/coupling_columns.h"
#include "scree/app/measures.h"
#include "scree/base/error.h"
#include "support/coupled_cloud.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

std::string bed(int subcycles, int count = 100, double inflow = 0.003) {
  return fmt::format(R"toml(
[simulation]
end = 0.3
time_step = "auto"
top_speed = 0.05
max_overlap = 0.5
[domain]
min = [0, 0, 0]
max = [0.003, 0.03, 0.003]
periodic = [true, false, true]
[gravity]
type = "uniform"
acceleration = [0, -9.81, 0]
[contact]
normal = "linear"
tangential = "history"
[[materials]]
name = "glass"
density = 2500
stiffness = 2.5
restitution = 0.8
friction = 0.3
[[particles]]
material = "glass"
diameter = 0.001
insert = "random"
count = {}
region_min = [0, 0, 0]
region_max = [0.003, 0.018, 0.003]
[[walls]]
material = "glass"
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
[fluid]
type = "incompressible"
density = 1000
viscosity = 1e-3
cells = [1, 15, 1]
[[fluid.patches]]
face = "y_min"
type = "inlet"
velocity = ["0", "{}", "0"]
[[fluid.patches]]
face = "y_max"
type = "outlet"
[coupling]
subcycles = {}
)toml",
                     count, inflow, subcycles);
}

double kinetic_energy(Simulation& s) {
  return measure(s.sample(), s.fields(), s.clock().now(), s.exchange().passage()).kinetic;
}

// Without the lag of the fluid that makes way, its pressure answers the swing of the packed beads too late with 40
// subcycles and drives it on until they burst apart.
TEST(CoupledBed, ComesToRestUnderALiquid) {
  for (const int subcycles : {0, 40}) {
    SCOPED_TRACE(subcycles);
    Simulation s(case_of(bed(subcycles)), 1);
    EXPECT_EQ(s.coupling()->settings.subcycles, subcycles == 0 ? 6 : 40);
    while (s.clock().now() < 0.3) s.step();
    // At the speed they fall with it would be 1e-7 J.
    EXPECT_LT(kinetic_energy(s), 1e-9);
  }
}

/// Four by four columns of grains that nearly fill a periodic box, thrown about.
std::string loose_grains(double diameter, double density, double stiffness, double fluid_density, double viscosity,
                         const std::string& coupling) {
  return fmt::format(R"toml(
[simulation]
end = 1
time_step = "auto"
top_speed = 0.05
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [{0}, {0}, {1}]
periodic = [true, true, false]
[gravity]
type = "uniform"
acceleration = [0, 0, -9.81]
[contact]
normal = "linear"
[[materials]]
name = "grain"
density = {2}
stiffness = {3}
restitution = 0.5
friction = 0.3
[[particles]]
material = "grain"
diameter = {4}
insert = "lattice"
spacing = {4}
region_min = [0, 0, 0]
region_max = [{0}, {0}, {5}]
velocity = {{ type = "random", deviation = 1e-3 }}
[[walls]]
material = "grain"
type = "box"
min = [-1, -1, 0]
max = [1, 1, {1}]
[fluid]
type = "incompressible"
density = {6}
viscosity = {7}
cells = [2, 2, 5]
[coupling]
{8}
)toml",
                     4 * diameter, 10 * diameter, density, stiffness, diameter, 8 * diameter, fluid_density, viscosity,
                     coupling);
}

// Answered at once, by fluid that has more inertia than they have, they burst apart.
TEST(CoupledBed, GrainsHardlyHeavierThanTheLiquidComeToRest) {
  Simulation s(case_of(loose_grains(1.5e-3, 1200, 2.5, 1000, 1e-3, "")), 1);
  while (s.clock().now() < 1.0) s.step();
  EXPECT_LT(s.coupling()->way.part, 0.4);
  EXPECT_LT(kinetic_energy(s), 1e-4 * 0.5 * 128 * 1200 * 1.767e-9 * 0.01 * 0.01);
}

// Drag slows a grain down within two steps of the fluid; where they lie close, what they press out holds them ten times
// as much.
TEST(CoupledBed, GrainsThatDragHoldsWithinTwoStepsComeToRest) {
  Simulation s(case_of(loose_grains(1e-4, 520, 0.05, 20, 5e-4, "drag = 'stokes'\nsubcycles = 40")), 1);
  while (s.clock().now() < 0.19) s.step();
  EXPECT_LT(s.coupling()->way.part, 0.9);
  EXPECT_LT(kinetic_energy(s), 1e-4 * 0.5 * 128 * 520 * 5.24e-13 * 0.005 * 0.005);
}

// The plate carries a bead that has come to rest, so that the liquid has its own weight to carry, from the inlet to the
// outlet.
TEST(CoupledBed, PressureDropIsThatOfTheWholeColumn) {
  Simulation s(case_of(bed(0, 1, 0)), 1);
  while (s.clock().now() < 0.25) s.step();
  EXPECT_NEAR(pressure_drop(s.coupling()->fluid), 1000 * 9.81 * 0.03, 1e-3);
}

}  // namespace
}  // namespace scree
