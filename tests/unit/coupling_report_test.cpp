// What `scree check` says of a coupled case before it is run: too few cells, cells that need what they are not given,
// drag that is too stiff or outside what its law was measured for.
#include "scree/app/coupling_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine_cases.h"
#include "scree/app/build_coupling.h"
#include "scree/app/derived.h"
#include "scree/app/fluid_report.h"

namespace scree {
namespace {

using namespace test;

Case bed(const std::string& cells, const std::string& coupling, const std::string& speed = "0.3") {
  return case_of(
      "[simulation]\nend = 1\ntime_step = 1e-5\n[domain]\nmin = [0, 0, 0]\nmax = [0.04, 0.08, 0.04]\n"
      "[gravity]\ntype = \"uniform\"\nacceleration = [0, -9.81, 0]\n"
      "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\n"
      "[[particles]]\nname = \"beads\"\nmaterial = \"glass\"\ndiameter = 0.002\ninsert = \"random\"\ncount = 9000\n"
      "[fluid]\ntype = \"incompressible\"\ndensity = 1.2\nviscosity = 1.8e-5\ncells = " +
      cells + "\n[[fluid.patches]]\nname = \"in\"\nface = \"y_min\"\ntype = \"inlet\"\nvelocity = [\"0\", \"" + speed +
      "\", \"0\"]\n[[fluid.patches]]\nname = \"out\"\nface = \"y_max\"\ntype = \"outlet\"\n[coupling]\n" + coupling);
}

/// The remedies, one to a line.
std::string remedies(const Case& c) {
  std::string out;
  for (const CouplingNote& note : coupling_notes(c, derive(c)))
    if (!note.remedy.empty()) out += note.remedy + "\n";
  return out;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CouplingReport, SaysNothingAgainstASoundBed) { EXPECT_EQ(remedies(bed("[8, 16, 8]", "subcycles = 10\n")), ""); }

TEST(CouplingReport, NamesTooFewCells) {
  EXPECT_TRUE(has(remedies(bed("[2, 16, 8]", "subcycles = 10\n")), "two cells across"));
  // One is a flow without that direction, and meant.
  EXPECT_EQ(remedies(bed("[1, 16, 8]", "subcycles = 10\n")), "");
}

TEST(CouplingReport, NamesCellsThatNeedDiffusionAndDiffusionThatLeavesNothing) {
  const std::string narrow = "[20, 40, 20]";
  EXPECT_EQ(remedies(bed(narrow, "subcycles = 10\n")), "");
  EXPECT_TRUE(has(remedies(bed(narrow, "subcycles = 10\ndiffusion = 0\n")), "need diffusion"));
  EXPECT_EQ(remedies(bed(narrow, "subcycles = 10\ndiffusion = 0.039\n")), "");
  EXPECT_TRUE(has(remedies(bed(narrow, "subcycles = 10\ndiffusion = 0.041\n")), "as wide as the domain, 0.04 m"));
}

TEST(CouplingReport, NamesDragThatIsStifferThanTheStepIsShort) {
  EXPECT_TRUE(has(remedies(bed("[8, 16, 8]", "subcycles = 1000000\n")), "stiffer than the fluid's step"));
}

TEST(CouplingReport, NamesStepsThatShakeABedInALiquid) {
  Case c = bed("[8, 16, 8]", "subcycles = 30\n", "0.001");
  c.fluid.density = 1000;
  c.fluid.viscosity = 1e-3;
  EXPECT_TRUE(has(remedies(c), "shake"));
  // Half a swing of two spheres of 10.5 mg on a spring of 1000 N/m: 0.23 ms.
  const double contact = std::numbers::pi * std::sqrt(2500 * std::numbers::pi / 6 * 8e-9 / 2 / 1000);
  EXPECT_DOUBLE_EQ(longest_step_in_bed(c, derive(c).kinds, contact), contact / 4);
  c.coupling.subcycles = static_cast<std::uint64_t>(contact / 1e-5);
  EXPECT_EQ(remedies(c), "");
  c.coupling.subcycles = 0;
  EXPECT_EQ(build_coupling_settings(c, derive(c).kinds, derive(c).step).subcycles,
            static_cast<int>(contact / 4 / 1e-5));
  c.fluid.density = 1.2;
  EXPECT_TRUE(std::isinf(longest_step_in_bed(c, derive(c).kinds, contact)));
}

/// An inlet that becomes faster sets the step of the fluid by what it gives in the end.
TEST(CouplingReport, StepsAreShortEnoughForWhatTheInletWillGive) {
  const auto subcycles = [](const std::string& speed) {
    const Case c = bed("[8, 16, 8]", "", speed);
    return build_coupling_settings(c, derive(c).kinds, derive(c).step).subcycles;
  };
  EXPECT_EQ(subcycles("2 * t"), subcycles("2"));
  EXPECT_LT(subcycles("2"), subcycles("0.5"));
}

TEST(CouplingReport, NamesSpeedsThatTheLawWasNotMeasuredAt) {
  // 0.3 m/s over a void fraction of 0.4 make a Reynolds number of 1.2 * 0.3 * 0.002 / 1.8e-5 = 40.
  EXPECT_EQ(remedies(bed("[8, 16, 8]", "subcycles = 10\ndrag = \"beetstra\"\n")), "");
  EXPECT_TRUE(
      has(remedies(bed("[8, 16, 8]", "subcycles = 10\ndrag = \"beetstra\"\n", "10")), "has been measured up to"));
}

TEST(CouplingReport, NamesStepsInWhichTheFlowPassesTooManyCells) {
  // 0.3 m/s, 0.75 m/s between the particles of a bed, past a cell of 5 mm in 6.67 ms.
  EXPECT_FALSE(has(remedies(bed("[8, 16, 8]", "subcycles = 660\n")), "cells in a step"));
  EXPECT_TRUE(has(remedies(bed("[8, 16, 8]", "subcycles = 675\n")), "cells in a step"));
  Case c = bed("[8, 16, 8]", "");
  EXPECT_FALSE(has(remedies(c), "cells in a step")) << "of steps that the program has chosen";
  c.fluid.time_step = 0.02;
  EXPECT_TRUE(has(remedies(c), "a smaller fluid.time_step"));
  for (const auto& [scheme, safe] : {std::pair{"van_leer", 0.5}, {"central", 1.0}}) {
    c.fluid.convection = scheme;
    EXPECT_EQ(long_step(c, safe), "");
    EXPECT_TRUE(has(long_step(c, 1.01 * safe), "grow without bound"));
  }
}

TEST(CouplingReport, SaysWhenAStepOfTheFluidIsShorterThanAskedFor) {
  Case c = bed("[8, 16, 8]", "");
  const auto step_of_fluid = [&] {
    for (const CouplingNote& note : coupling_notes(c, derive(c)))
      if (note.label == "time step of the fluid") return note.value;
    return std::string();
  };
  c.fluid.time_step = 1e-4;
  EXPECT_FALSE(has(step_of_fluid(), "asks for"));
  c.fluid.time_step = 1.05e-4;
  EXPECT_TRUE(has(step_of_fluid(), "fluid.time_step asks for 0.000105 s"));
}

/// Roots of the formula of two steps for a wave in a uniform stream leave the unit circle at 13.7 of a cell with
/// Courant numbers of 0.5 and at 2220 with 0.1.
TEST(CouplingReport, NamesWavesThatCentralDifferencesLetGrow) {
  Case c = bed("[8, 16, 8]", "subcycles = 10\n");
  for (const char* scheme : {"central", "symmetric", "van_leer"}) {
    c.fluid.convection = scheme;
    const bool grows = scheme != std::string("van_leer");
    EXPECT_EQ(growing_waves(c, 0.5, 13), "");
    EXPECT_EQ(has(growing_waves(c, 0.5, 15), "grow"), grows);
    EXPECT_EQ(growing_waves(c, 0.1, 1600), "");
    EXPECT_EQ(has(growing_waves(c, 0.1, 2500), "grow"), grows);
  }
  c = bed("[2, 4, 2]", "subcycles = 40\n", "3");
  EXPECT_TRUE(has(remedies(c), "grow"));
  c.fluid.convection = "van_leer";
  EXPECT_FALSE(has(remedies(c), "grow"));
}

}  // namespace
}  // namespace scree
