// What `scree check` finds in a case that is well written but cannot be meant: things where nobody gets, walls that
// jump, more particles than the memory holds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "engine_cases.h"
#include "run_files.h"
#include "scree/app/build_walls.h"
#include "scree/app/derived.h"
#include "scree/app/idle_keys.h"
#include "scree/app/memory_need.h"
#include "scree/app/outside.h"
#include "scree/app/wall_jumps.h"
#include "scree/base/memory.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;

/// A sphere of radius 5 mm in a domain of 20 cm.
std::string domain_text(const std::string& more) {
  return "[simulation]\nend = 1\ntime_step = 1e-4\n[domain]\nmin = [-0.1, -0.1, -0.1]\nmax = [0.1, 0.1, 0.1]\n"
         "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\n"
         "[[particles]]\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"positions\"\npositions = [[0, 0, 0.05]]\n" +
         more;
}

std::string wall(const std::string& keys) { return "[[walls]]\nname = \"wall\"\nmaterial = \"glass\"\n" + keys + "\n"; }

std::vector<std::string> labels(const std::string& more) {
  std::vector<std::string> out;
  const Case c = case_of(domain_text(more));
  for (const Remark& remark : remarks_on_places(c, build_walls(c), 0.005)) out.push_back(remark.label);
  return out;
}

const std::vector<std::string> none, found = {"wall 'wall'"};

TEST(Places, WallsThatNobodyCanTouchAreNamed) {
  EXPECT_EQ(labels(wall("type = \"plane\"\npoint = [0, 0, -0.1]\nnormal = [0, 0, 1]")), none);
  // A particle's centre is in the domain, its surface reaches 5 mm further.
  EXPECT_EQ(labels(wall("type = \"plane\"\npoint = [0, 0, -0.104]\nnormal = [0, 0, 1]")), none);
  EXPECT_EQ(labels(wall("type = \"plane\"\npoint = [0, 0, -0.106]\nnormal = [0, 0, 1]")), found);
  EXPECT_EQ(labels(wall("type = \"rectangle\"\nmin = [-9, -9, 0]\nmax = [9, 9, 0]")), none);
  EXPECT_EQ(labels(wall("type = \"rectangle\"\nmin = [0.2, 0, 0]\nmax = [0.3, 1, 0]")), found);
  // A room far around the domain: its box contains the domain, its faces do not come near.
  EXPECT_EQ(labels(wall("type = \"box\"\nmin = [-1, -1, -1]\nmax = [1, 1, 1]")), found);
  EXPECT_EQ(labels(wall("type = \"cylinder\"\nstart = [0, 0, -1]\nend = [0, 0, 1]\nradius = 0.12")), none);
  EXPECT_EQ(labels(wall("type = \"cylinder\"\nstart = [0, 0, -1]\nend = [0, 0, 1]\nradius = 0.2")), found);
  // A slanted plate whose box overlaps the domain and which passes its corner.
  EXPECT_EQ(labels(wall("type = \"triangles\"\nvertices = [[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.9]]")), found);
}

TEST(Places, AWallThatComesInLaterIsNotNamed) {
  const std::string far = "type = \"rectangle\"\nmin = [0.2, 0, 0]\nmax = [0.3, 1, 0]\n";
  EXPECT_EQ(labels(wall(far + "motion = { type = \"velocity\", velocity = [-0.2, 0, 0] }")), none);
  EXPECT_EQ(labels(wall(far + "motion = { type = \"velocity\", velocity = [0.2, 0, 0] }")), found);
  EXPECT_EQ(labels(wall("type = \"plane\"\npoint = [0, 0, -0.3]\nnormal = [0, 0, 1]\n"
                        "motion = { type = \"oscillation\", amplitude = [0, 0, 0.25], frequency = 1 }")),
            none);
}

TEST(Places, AMeshInMillimetresIsTold) {
  const TemporaryDirectory space;
  // A hopper of four slanted sides, 24 to 60 mm wide.
  std::string stl = "solid hopper\n";
  const auto facet = [&](const std::array<std::array<double, 3>, 3>& corners) {
    stl += "facet normal 0 0 0\nouter loop\n";
    for (const auto& x : corners) stl += fmt::format("vertex {} {} {}\n", x[0], x[1], x[2]);
    stl += "endloop\nendfacet\n";
  };
  const double x[5] = {-1, 1, 1, -1, -1}, y[5] = {-1, -1, 1, 1, -1};
  for (int k = 0; k < 4; ++k) {
    facet({{{12 * x[k], 12 * y[k], 0}, {12 * x[k + 1], 12 * y[k + 1], 0}, {30 * x[k + 1], 30 * y[k + 1], 60}}});
    facet({{{12 * x[k], 12 * y[k], 0}, {30 * x[k + 1], 30 * y[k + 1], 60}, {30 * x[k], 30 * y[k], 60}}});
  }
  write_text_file(space / "hopper.stl", stl + "endsolid hopper\n");
  const std::string mesh = "type = \"mesh\"\nfile = \"" + (space / "hopper.stl").string() + "\"\n";
  EXPECT_EQ(labels(wall(mesh + "scale = \"1 mm\"")), none);
  EXPECT_EQ(labels(wall(mesh)), found);
  const Case c = case_of(domain_text(wall(mesh)));
  const std::string report = check_report(c, derive(c));
  EXPECT_NE(report.find("if the file is in millimetres, give scale = \"1 mm\""), std::string::npos) << report;
  EXPECT_NE(check_warnings(c, derive(c)).find("wall 'wall': no face of it"), std::string::npos);
  write_text_file(space / "hopper.stl", "no mesh");
  try {
    case_of(domain_text(wall(mesh)));
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("error[E172]"), std::string::npos) << error.what();
  }
  write_text_file(space / "hopper.stl", stl + "endsolid hopper\n");
  // Too small by as much.
  EXPECT_EQ(labels(wall(mesh + "scale = 1e-6")), found);
}

TEST(Places, OutletsPlanesAndGridsOutsideAreNamed) {
  const std::string region = "[[outlets]]\nname = \"out\"\ntype = \"region\"\n";
  EXPECT_EQ(labels(region + "min = [0, 0, -1]\nmax = [1, 1, 0]\n"), none);
  EXPECT_EQ(labels(region + "min = [1, 1, 1]\nmax = [2, 2, 2]\n"), (std::vector<std::string>{"outlet 'out'"}));
  const std::string plane = "[[analysis.planes]]\nname = \"mouth\"\nnormal = [1, 0, 1]\n";
  EXPECT_EQ(labels(plane + "point = [0, 0, 0.19]\n"), none);
  EXPECT_EQ(labels(plane + "point = [0, 0, 0.21]\n"), (std::vector<std::string>{"plane 'mouth'"}));
  EXPECT_EQ(
      labels("[[analysis.averages]]\nname = \"a\"\ncells = [1, 1, 1]\nevery = 0.1\nmin = [0.1, 0, 0]\nmax = [1, 1, 1]\n"
             "[[analysis.surfaces]]\nname = \"s\"\ncells = [1, 1, 1]\nmin = [0, 0, -3]\nmax = [1, 1, -2]\n"
             "[[analysis.regions]]\nname = \"r\"\nmin = [0, 3, 0]\nmax = [1, 4, 2]\n"),
      (std::vector<std::string>{"averages 'a'", "surface 's'", "region 'r'"}));
}

TEST(Jumps, AWallThatGoesFartherThanARadiusInAStepIsNamed) {
  const auto jumps = [](const std::string& motion) {
    const Case c =
        case_of(domain_text(wall("type = \"plate\"\ncorner = [-0.1, -0.1, 0]\nedge_a = [0, 0.2, 0]\n"
                                 "edge_b = [0, 0, 0.02]\nmotion = " +
                                 motion)));
    return remarks_on_jumps(c, build_walls(c), 1e-4, 0.005);
  };
  EXPECT_TRUE(jumps("{ type = \"velocity\", velocity = [49, 0, 0] }").empty());
  EXPECT_EQ(jumps("{ type = \"velocity\", velocity = [51, 0, 0] }").size(), 1u);
  // 10 m/s for long is no jump; 0.3 m at once is one, wherever it lies between the samples.
  EXPECT_TRUE(jumps("{ type = \"expression\", displacement = [\"10*t\", 0, 0] }").empty());
  const auto sudden = jumps("{ type = \"expression\", displacement = [\"t > 0.12345 ? 0.3 : 0\", 0, 0] }");
  ASSERT_EQ(sudden.size(), 1u);
  EXPECT_NE(sudden[0].finding.find("goes 0.3 m in one step at t = 0.123"), std::string::npos) << sudden[0].finding;
}

TEST(Encounters, OfWallsAlikeTheFastestHitsHardest) {
  const std::string still =
      "[[walls]]\nname = \"floor\"\nmaterial = \"glass\"\ntype = \"plane\"\npoint = [0, 0, 0]\n"
      "normal = [0, 0, 1]\n";
  const Case c = case_of(domain_text(still + wall("type = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, -1]\n"
                                                  "motion = { type = \"velocity\", velocity = [0, 0, -0.1] }")));
  const Derived d = derive(c);
  EXPECT_NE(d.step.deepest.find("wall 'wall'"), std::string::npos) << d.step.deepest;
}

TEST(Memory, MoreParticlesThanFitAreRefusedBeforeTheyAreMade) {
  const std::string text =
      "[simulation]\nend = 1\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[[materials]]\nname = \"a\"\n"
      "density = 2500\nstiffness = 1e5\n[[particles]]\nmaterial = \"a\"\ninsert = \"random\"\ndiameter = 1e-4\n";
  const Case many = case_of(text + "count = 2_000_000_000\n");
  const std::string refusal = memory_refusal(many, 16e9);
  EXPECT_EQ(refusal.find("test.toml:14:9: error[E133]: 2e+09 particles need 544 GB"), 0u) << refusal;
  EXPECT_EQ(memory_refusal(many, 545e9), "");
  EXPECT_EQ(memory_refusal(many, {}), "");
  const Derived d = derive(many);
  EXPECT_EQ(d.cost.particles, 2000000000u);
  EXPECT_NEAR(d.cost.solid_fraction, 2e9 * std::numbers::pi / 6 * 1e-12, 1e-12);
  // By a solid fraction, which is met to a part of a particle.
  const Case filled = case_of(text + "solid_fraction = 0.1\n");
  EXPECT_NEAR(static_cast<double>(derive(filled).cost.particles), 0.1 / (std::numbers::pi / 6 * 1e-12), 1);
  EXPECT_NE(memory_refusal(filled, 16e9), "");
  EXPECT_EQ(memory_refusal(case_of(text + "count = 1000\n"), 1e6), "");
}

TEST(Memory, OfTheMachineIsKnown) {
  const auto available = available_memory();
  ASSERT_TRUE(available);
  EXPECT_GT(*available, 1e7);
  EXPECT_LT(*available, 1e15);
}

TEST(Idle, WhatBelongsToSomethingThatTheCaseDoesNotHaveIsNamed) {
  const auto idle = [](const std::string& more) {
    std::string out;
    for (const IdleTable& table : idle_tables(case_of(domain_text(more)))) out += table.keys + " ";
    return out;
  };
  EXPECT_EQ(idle(""), "");
  EXPECT_EQ(idle("[coupling]\ndrag = \"gidaspow_blend\"\n"), "");
  EXPECT_EQ(idle("[coupling]\ndrag = \"di_felice\"\n"), "coupling ");
  EXPECT_EQ(idle("[coupling]\nmagnus = true\n"), "coupling ");
  const std::string fluid = "[fluid]\ntype = \"incompressible\"\ndensity = 1\nviscosity = 1e-5\ncells = [4, 4, 4]\n";
  EXPECT_EQ(idle("[coupling]\ndrag = \"di_felice\"\n" + fluid), "");
  Case warm = case_of(domain_text(fluid + wall("type = \"box\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]")));
  warm.heat.type = "solved";
  EXPECT_TRUE(idle_tables(warm).empty());
  warm.heat.exchange = "ranz_marshall";
  ASSERT_EQ(idle_tables(warm).size(), 1u);
  EXPECT_EQ(idle_tables(warm)[0].keys, "heat.exchange");
  warm.fluid.heat.type = "solved";
  EXPECT_TRUE(idle_tables(warm).empty());
  warm.walls[0].temperature = 300;
  EXPECT_TRUE(idle_tables(warm).empty());
  warm.heat.conduction = false;
  ASSERT_EQ(idle_tables(warm).size(), 1u);
  EXPECT_EQ(idle_tables(warm)[0].keys, "walls.temperature");
  warm.fluid.heat.type = "none";
  const std::string report = check_report(warm, derive(warm));
  EXPECT_NE(report.find("walls.temperature, without heat.conduction"), std::string::npos) << report;
}

}  // namespace
}  // namespace scree
