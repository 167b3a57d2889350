// The language of [[expect]], the judge, and what they make of made-up results.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scree/app/verify_formula.h"
#include "scree/app/verify_judge.h"
#include "scree/app/verify_plot.h"
#include "scree/app/verify_report.h"
#include "scree/base/error.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

class TemporaryDirectory {
 public:
  TemporaryDirectory() : path_(fs::temp_directory_path() / ("scree_verify_" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~TemporaryDirectory() { fs::remove_all(path_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

// Time 0, 0.1 ... 1 with a parabola and a line.
ResultTable parabola() {
  ResultTable table;
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.1 * i;
    table.columns["time"].push_back(t);
    table.columns["p0.x"].push_back(t * t);
    table.columns["p0.vx"].push_back(2 * t);
  }
  return table;
}

// Runs whose error falls with the given power of the parameter.
std::vector<VariantRun> converging(double power) {
  std::vector<VariantRun> runs;
  for (const double h : {0.1, 0.05, 0.025}) {
    VariantRun run;
    run.keys.name = "h" + std::to_string(h);
    run.keys.parameter = h;
    run.results = parabola();
    for (double& x : run.results.columns["p0.x"]) x += 3 * std::pow(h, power);
    runs.push_back(run);
  }
  return runs;
}

ExpectKeys expectation(const std::string& value, const std::string& equals, double tolerance) {
  ExpectKeys keys;
  keys.what = "made up";
  keys.value = value;
  keys.equals = equals;
  keys.tolerance = tolerance;
  return keys;
}

TEST(VerifyResults, TracksBecomeColumnsOfTheirParticles) {
  const TemporaryDirectory directory;
  directory.write("series.csv", "time,step,energy_error\n0,0,nan\n0.5,5,1e-3\n");
  directory.write("tracks.csv", "time,id,x,vx\n0,0,1,2\n0,7,3,4\n0.5,0,5,6\n0.5,7,7,-8.5e-1\n");
  const ResultTable table = load_results(directory.path());
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.columns.at("p0.x"), (std::vector<double>{1, 5}));
  EXPECT_EQ(table.columns.at("p7.vx"), (std::vector<double>{4, -0.85}));
  EXPECT_TRUE(std::isnan(table.columns.at("energy_error")[0]));
}

TEST(VerifyResults, BrokenFilesAreRefusedWithTheirPlace) {
  const TemporaryDirectory directory;
  EXPECT_THROW(load_results(directory.path()), InputError);
  directory.write("series.csv", "time,step\n0,0\n1,x\n");
  try {
    load_results(directory.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("series.csv:3: 'x' is not a number"), std::string::npos) << error.what();
  }
  directory.write("series.csv", "time,step\n0,0\n1\n");
  EXPECT_THROW(load_results(directory.path()), InputError);
  directory.write("series.csv", "time,step\n0,0\n1,1\n");
  directory.write("tracks.csv", "time,id,x\n0,0,1\n");
  EXPECT_THROW(load_results(directory.path()), InputError);
}

TEST(VerifyFormula, FunctionsOfRowsGiveTheirValues) {
  Formulas formulas(parabola());
  formulas.set_parameter(0.25);
  EXPECT_DOUBLE_EQ(formulas.value("first(\"p0.x\")"), 0);
  EXPECT_DOUBLE_EQ(formulas.value("last(\"p0.x + 1\")"), 2);
  EXPECT_DOUBLE_EQ(formulas.value("minimum(\"p0.x - p0.vx\")"), -1);
  EXPECT_DOUBLE_EQ(formulas.value("maximum(\"p0.vx\")"), 2);
  EXPECT_NEAR(formulas.value("mean(\"p0.vx\")"), 1, 1e-15);
  EXPECT_DOUBLE_EQ(formulas.value("max_abs(\"p0.x - p0.vx\")"), 1);
  EXPECT_NEAR(formulas.value("rms(\"p0.vx\")"), std::sqrt(4 * 3.85 / 11), 1e-15);  // sum of squares 1..10 is 385
  EXPECT_NEAR(formulas.value("integral(\"p0.vx\")"), 1, 1e-15);
  EXPECT_NEAR(formulas.value("at(\"p0.vx\", 0.33)"), 0.66, 1e-15);
  EXPECT_NEAR(formulas.value("when(\"p0.vx - 0.5\", 1)"), 0.25, 1e-15);
  EXPECT_NEAR(formulas.value("when(\"cos(2.5 * pi * time)\", 2)"), 0.6, 1e-12);
  EXPECT_DOUBLE_EQ(formulas.value("4 * parameter + max(1, 2) + 2.5e-3*2. - .005"), 3);
  EXPECT_DOUBLE_EQ(formulas.value("maximum(\"time > 0.45 && time < 0.75 ? p0.x : 0\")"), 0.7 * 0.7);
}

TEST(VerifyFormula, WhatIsNotThereIsNotANumber) {
  Formulas formulas(parabola());
  EXPECT_TRUE(std::isnan(formulas.value("at(\"p0.x\", 1.5)")));
  EXPECT_TRUE(std::isnan(formulas.value("when(\"p0.vx - 5\", 1)")));
  EXPECT_TRUE(std::isnan(formulas.value("max_abs(\"p0.x / 0 * 0\")")));
}

TEST(VerifyFormula, DefinitionsAreNumbersOrColumns) {
  Formulas formulas(parabola());
  formulas.define("a = 2");
  formulas.define("exact = a * time");
  formulas.define("end = last(\"exact\")");
  EXPECT_DOUBLE_EQ(formulas.value("max_abs(\"p0.vx - exact\")"), 0);
  EXPECT_DOUBLE_EQ(formulas.value("end"), 2);
  EXPECT_EQ(formulas.rows("exact").size(), 11u);
  EXPECT_THROW(formulas.define("a = 3"), InputError);
  EXPECT_THROW(formulas.define("p0.x = 3"), InputError);
  EXPECT_THROW(formulas.define("no formula"), InputError);
}

TEST(VerifyFormula, MistakesAreNamed) {
  Formulas formulas(parabola());
  EXPECT_THROW(formulas.value("last(\"p1.x\")"), InputError);
  EXPECT_THROW(formulas.value("p0.x + 1"), InputError);
  EXPECT_THROW(formulas.value("last(\"p0.x\""), InputError);
  EXPECT_THROW(formulas.value("order(\"p0.x\")"), InputError);
}

TEST(VerifyJudge, OrderIsTheSlopeOverTheVariantsAndOneNumber) {
  VerifyKeys keys;
  keys.expect = {expectation("order(\"p0.x - time^2\")", "1.7", 1e-6)};
  const Judgement judgement = judge(keys, converging(1.7));
  ASSERT_EQ(judgement.checks.size(), 1u);
  EXPECT_NEAR(judgement.checks[0].value, 1.7, 1e-9);
  EXPECT_EQ(judgement.checks[0].variant, "");
  EXPECT_TRUE(judgement.passed);
  EXPECT_FALSE(judge(keys, converging(1.6)).passed);
}

TEST(VerifyJudge, ToleranceAndBoundsDecide) {
  VerifyKeys keys;
  keys.define = {"scale = 10"};
  std::vector<VariantRun> runs = converging(1);
  runs.resize(1);
  const auto passes = [&](const ExpectKeys& expect) {
    keys.expect = {expect};
    return judge(keys, runs).passed;
  };
  EXPECT_TRUE(passes(expectation("last(\"p0.vx\") + 0.09", "2", 0.1)));
  EXPECT_FALSE(passes(expectation("last(\"p0.vx\") + 0.11", "2", 0.1)));
  ExpectKeys relative = expectation("scale * 1.009", "scale", 0);
  relative.relative = 0.01;
  EXPECT_TRUE(passes(relative));
  relative.value = "scale * 0.989";
  EXPECT_FALSE(passes(relative));
  ExpectKeys bounds = expectation("last(\"p0.vx\")", "", 0);
  bounds.at_most = 2.0;
  EXPECT_TRUE(passes(bounds));
  bounds.at_most = 1.99;
  EXPECT_FALSE(passes(bounds));
  bounds.at_most.reset();
  bounds.at_least = 2.01;
  EXPECT_FALSE(passes(bounds));
  EXPECT_FALSE(passes(expectation("when(\"p0.vx - 9\", 1)", "0", 1e9)));
  bounds.value = "1 / 0";
  EXPECT_FALSE(passes(bounds));
}

TEST(VerifyJudge, AWrongVariantMustBeCaught) {
  VerifyKeys keys;
  keys.expect = {expectation("max_abs(\"p0.x - time^2\")", "0", 1e-3)};
  std::vector<VariantRun> runs = converging(5);
  runs[0].keys.wrong = true;
  runs[0].results = parabola();
  runs[1].results = parabola();
  runs[2].results = parabola();
  EXPECT_FALSE(judge(keys, runs).passed);
  runs[0].results.columns["p0.x"][3] += 0.01;
  const Judgement caught = judge(keys, runs);
  EXPECT_TRUE(caught.passed);
  EXPECT_EQ(caught.checks.size(), 3u);
  runs[0].results = parabola();
  runs[0].stopped = "the books do not close";
  EXPECT_TRUE(judge(keys, runs).passed);
  runs[1].stopped = "lost a particle";
  EXPECT_FALSE(judge(keys, runs).passed);
}

TEST(VerifyJudge, ExpectationsCanNameTheirVariants) {
  VerifyKeys keys;
  keys.source = "the case";
  keys.expect = {expectation("parameter", "mine", 0)};
  std::vector<VariantRun> runs = converging(1);
  for (VariantRun& run : runs) run.keys.define = {"mine = " + std::to_string(run.keys.parameter)};
  keys.define = {"mine = 17", "twice = 2 * mine"};  // a variant's own definition replaces the case's
  EXPECT_TRUE(judge(keys, runs).passed);
  keys.expect[0].variants = {runs[1].keys.name};
  const Judgement one = judge(keys, runs);
  ASSERT_EQ(one.checks.size(), 1u);
  EXPECT_EQ(one.checks[0].variant, runs[1].keys.name);
  EXPECT_EQ(one.checks[0].source, "the case");
  keys.expect[0].variants = {"nobody"};
  EXPECT_THROW(judge(keys, runs), InputError);
}

TEST(VerifyReport, TextAndJsonCarryValueExpectationAndVerdict) {
  VerifyKeys keys;
  keys.source = "Somebody 1900";
  keys.expect = {expectation("last(\"p0.vx\")", "2", 0.1), expectation("last(\"p0.x\")", "7", 0.1)};
  CaseReport report{
      .name = "01_made_up", .title = "Made up", .source = keys.source, .seconds = 1, .runs = {}, .judgement = {}};
  report.runs = converging(1);
  report.judgement = judge(keys, report.runs);
  const std::string text = report_text(report);
  EXPECT_NE(text.find("FAILED  01_made_up"), std::string::npos) << text;
  EXPECT_NE(text.find("Somebody 1900"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(report_json({report}));
  EXPECT_FALSE(json["passed"]);
  EXPECT_EQ(json["cases"][0]["checks"].size(), 6u);
  EXPECT_EQ(json["cases"][0]["checks"][0]["verdict"], "ok");
  EXPECT_EQ(json["cases"][0]["checks"][3]["verdict"], "FAILED");
  EXPECT_EQ(json["cases"][0]["checks"][3]["expected"], 7);
  EXPECT_NE(closing_text({report}).find("failed: 01_made_up"), std::string::npos);
}

TEST(VerifyPlot, CurvesLieOverTheirReference) {
  VerifyKeys keys;
  VerifyPlotKeys rows, points;
  rows.y = "p0.x";
  rows.reference = "time^2";
  points.x = "parameter";
  points.y = "max_abs(\"p0.x - time^2\")";
  points.per_variant = true;
  keys.plots = {rows, points};
  const nlohmann::json json = nlohmann::json::parse(plot_json("Made up", keys, converging(1)));
  ASSERT_EQ(json["plots"].size(), 2u);
  EXPECT_EQ(json["plots"][0]["curves"].size(), 3u);
  EXPECT_DOUBLE_EQ(json["plots"][0]["curves"][0]["reference"][5], 0.25);
  EXPECT_NEAR(json["plots"][0]["curves"][0]["y"][5], 0.25 + 0.3, 1e-15);
  ASSERT_EQ(json["plots"][1]["curves"].size(), 1u);
  EXPECT_EQ(json["plots"][1]["curves"][0]["x"].size(), 3u);
  EXPECT_NEAR(json["plots"][1]["curves"][0]["y"][2], 0.075, 1e-15);
}

}  // namespace
}  // namespace scree
