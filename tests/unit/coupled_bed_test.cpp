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

// The steps of the fluid that are chosen for it are short enough; twenty times as long, its pressure answers the swing
// of the packed beads too late and drives it on until they burst apart.
TEST(CoupledBed, ComesToRestUnderALiquidAtTheStepsChosenForIt) {
  Simulation chosen(case_of(bed(0)), 1);
  EXPECT_EQ(chosen.coupling()->settings.subcycles, 2);
  while (chosen.clock().now() < 0.3) chosen.step();
  // At the speed they fall with it would be 1e-7 J.
  EXPECT_LT(kinetic_energy(chosen), 1e-9);
  Simulation late(case_of(bed(40)), 1);
  EXPECT_THROW(while (late.clock().now() < 0.3) late.step(), PhysicsError);
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
