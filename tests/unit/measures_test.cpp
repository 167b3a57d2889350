// Planes, surfaces, averages and contacts of a run: columns, files, and the same bits after a restart.
#include "scree/app/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "engine_cases.h"
#include "run_files.h"
#include "scree/app/contact_fields.h"
#include "scree/output/hdf5_file.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

const LawChoice plain = {"plain", "normal = \"linear\"\ntangential = \"history\"\n", "friction = 0.5\n"};

const std::string measured =
    "[output]\nseries = 1e-3\nframes = 2e-3\ncheckpoints = 2e-3\ncontacts = true\n"
    "[[analysis.planes]]\nname = \"middle\"\npoint = [0, 0, 0.015]\nnormal = [0, 0, -2]\n"
    "[[analysis.planes]]\nname = \"disc\"\npoint = [0.012, 0.012, 0.01]\nnormal = [1, 0, 1]\nradius = 0.005\n"
    "[[analysis.averages]]\nname = \"all\"\ncells = [3, 4, 5]\nevery = 3e-4\n"
    "[[analysis.averages]]\nname = \"late\"\ncells = [2, 2, 2]\nfrom = 2.5e-3\nevery = 2e-4\nwindow = 1.3e-3\n"
    "min = [0, 0, 0]\nmax = [0.03, 0.03, 0.015]\n"
    "[[analysis.surfaces]]\nname = \"top\"\ncells = [2, 2, 4]\nsolid_fraction = 0.1\n"
    "[[analysis.regions]]\nname = \"whole\"\n";

Case measuring_case(const Overrides& more = {}) {
  Overrides all = {"simulation.end=6e-3"};
  all.insert(all.end(), more.begin(), more.end());
  return case_of(crowd_text(plain, 100, 0.03) + measured, all);
}

/// Rows of a table by the names of the columns.
std::map<std::string, std::vector<double>> table(const fs::path& path) {
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
  std::map<std::string, std::vector<double>> out;
  while (std::getline(file, line)) {
    std::istringstream row(line);
    for (const std::string& name : names) {
      std::getline(row, cell, ',');
      out[name].push_back(std::stod(cell));
    }
  }
  return out;
}

std::vector<double> numbers(const fs::path& path, const std::string& dataset) {
  const Hdf5File file = Hdf5File::open(path);
  const Shape shape = file.shape(dataset);
  std::vector<double> out(shape.rows * shape.columns);
  file.read(dataset, shape, out.data());
  return out;
}

double attribute(const fs::path& path, const std::string& name) {
  double out = 0;
  Hdf5File::open(path).read_attribute("/", name, Element::float64, 1, &out);
  return out;
}

TEST(Measures, OfARunAreInItsFiles) {
  const TemporaryDirectory space;
  run_case(measuring_case(), into(space / "run"));
  const auto rows = table(space / "run/series.csv");
  // The middle plane counts what its rate sums up to, and mass goes with numbers.
  const auto &mass = rows.at("middle_mass"), &rate = rows.at("middle_rate"), &time = rows.at("time");
  EXPECT_EQ(rows.at("middle_count")[0], 0);
  EXPECT_GT(rows.at("middle_against").back(), 0);
  double sum = 0;
  for (std::size_t k = 1; k < mass.size(); ++k) sum += rate[k] * (time[k] - time[k - 1]);
  EXPECT_NEAR(sum, mass.back(), 1e-12);
  EXPECT_TRUE(rows.contains("disc_count") && rows.contains("top_level") && rows.contains("top_angle"));
  EXPECT_GT(rows.at("top_level").back(), 0);
  EXPECT_LT(rows.at("top_level").back(), 0.031);
  // All contacts between particles count for two of them.
  EXPECT_GT(rows.at("whole_coordination").back(), 0);
  EXPECT_LE(rows.at("whole_coordination").back(), 2 * rows.at("contacts").back() / rows.at("particles").back());
  EXPECT_FALSE(rows.contains("whole_nematic_order"));  // spheres
  // The averages hold all particles of the box at every sample.
  const fs::path all = space / "run/averages/all_000000.h5";
  double number = 0;
  const double cell = 0.032 * 0.032 * 0.032 / 60;
  for (const double n : numbers(all, "/fields/number_density")) number += n * cell;
  EXPECT_NEAR(number, 133, 1e-9);
  EXPECT_EQ(attribute(all, "begin"), 0);
  EXPECT_NEAR(attribute(all, "time"), 6e-3, 1e-12);
  // Windows of 1.3 ms from 2.5 ms on: two whole ones and the rest.
  EXPECT_NEAR(attribute(space / "run/averages/late_000000.h5", "begin"), 2.5e-3, 1e-12);
  EXPECT_NEAR(attribute(space / "run/averages/late_000000.h5", "time"), 3.7e-3, 1e-12);
  EXPECT_NEAR(attribute(space / "run/averages/late_000001.h5", "begin"), 3.9e-3, 1e-12);
  EXPECT_NEAR(attribute(space / "run/averages/late_000002.h5", "time"), 5.9e-3, 1e-12);
  EXPECT_FALSE(fs::exists(space / "run/averages/late_000003.h5"));
  const std::string film = read_text_file(space / "run/averages/late.xdmf");
  EXPECT_NE(film.find("late_000002.h5:/fields/contact_stress"), std::string::npos) << film;
  // Contacts: as many as the series says.
  const fs::path contacts = space / "run/contacts/contacts_000003.h5";
  EXPECT_EQ(static_cast<double>(numbers(contacts, "/contacts/normal_force").size()), rows.at("contacts").back());
  EXPECT_NE(read_text_file(space / "run/contacts.xdmf").find("contacts/contacts_000003.h5:/contacts/force"),
            std::string::npos);
}

/// Rods that float: two along z, one along x. What the region says is by their number, and spheres do not count.
TEST(Measures, OfARegionSayHowBodiesAreTurned) {
  const TemporaryDirectory space;
  const std::string rods = "material = \"glass\"\nshape = \"ellipsoid\"\ninsert = \"positions\"\n";
  run_case(case_of("[simulation]\nend = 1e-4\ntime_step = 1e-5\n[domain]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n"
                   "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\n[[particles]]\n" +
                       rods + "half_axes = [1e-3, 1e-3, 4e-3]\npositions = [[0.02, 0.02, 0.02], [0.06, 0.02, 0.02]]\n" +
                       "[[particles]]\n" + rods + "half_axes = [4e-3, 1e-3, 1e-3]\npositions = [[0.02, 0.06, 0.02]]\n" +
                       "[[particles]]\nmaterial = \"glass\"\ndiameter = 1e-3\ninsert = \"positions\"\n"
                       "positions = [[0.08, 0.08, 0.08]]\n[[analysis.regions]]\nname = \"all\"\n",
                   {"output.series=1e-4"}),
           into(space / "run"));
  const auto rows = table(space / "run/series.csv");
  EXPECT_NEAR(rows.at("all_cos2_x").back(), 1.0 / 3, 1e-14);
  EXPECT_NEAR(rows.at("all_cos2_y").back(), 0, 1e-14);
  EXPECT_NEAR(rows.at("all_cos2_z").back(), 2.0 / 3, 1e-14);
  EXPECT_NEAR(rows.at("all_nematic_order").back(), 0.5, 1e-14);
}

/// The sign of a zero would tell from which partner a contact was computed, which lists decide.
TEST(Measures, ContactsHoldNoMinusZero) {
  for (const char* positions :
       {"[[0.01, 0.05, 0.05], [0.0199, 0.05, 0.05]]", "[[0.0199, 0.05, 0.05], [0.01, 0.05, 0.05]]"}) {
    Simulation s(case_of("[simulation]\nend = 1\ntime_step = 1e-5\n[domain]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n"
                         "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\nfriction = 0.5\n"
                         "[[particles]]\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"positions\"\npositions = " +
                             std::string(positions) + "\n",
                         {"output.contacts=true"}),
                 1);
    s.step();
    int zeros = 0;
    for (const FrameColumn& column : contact_columns(s.sample())) {
      if (column.values.element != Element::float64) continue;
      const double* values = static_cast<const double*>(column.values.data);
      for (std::uint64_t k = 0; k < column.values.rows * column.values.columns; ++k) {
        EXPECT_FALSE(values[k] == 0 && std::signbit(values[k])) << column.name;
        zeros += values[k] == 0;
      }
    }
    EXPECT_GT(zeros, 0);
  }
}

TEST(Measures, GoOnAfterARestartToTheSameBits) {
  const TemporaryDirectory space;
  run_case(measuring_case(), into(space / "whole"));
  // Stopped within a window, and away from its samples.
  RunOptions o = into(space / "run");
  o.until = 4e-3;
  run_case(measuring_case(), o);
  o = into(space / "run", 2);
  o.restart = "latest";
  run_case(measuring_case(), o);
  const auto expected = results(space / "whole"), found = results(space / "run");
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [name, text] : expected) EXPECT_TRUE(found.at(name) == text) << name;
  EXPECT_TRUE(expected.contains("averages/late_000001.h5"));
}

TEST(Measures, AForcedRunTakesTheOldFilesAway) {
  const TemporaryDirectory space;
  run_case(measuring_case(), into(space / "run"));
  std::ofstream(space / "run/averages/notes.txt") << "mine";
  RunOptions o = into(space / "run");
  o.force = true;
  run_case(case_of(crowd_text(plain, 10), {"simulation.end=1e-4"}), o);
  EXPECT_FALSE(fs::exists(space / "run/averages/all.xdmf"));
  EXPECT_FALSE(fs::exists(space / "run/averages/all_000000.h5"));
  EXPECT_FALSE(fs::exists(space / "run/contacts.xdmf"));
  EXPECT_TRUE(fs::exists(space / "run/averages/notes.txt"));
}

TEST(Measures, AnotherGridIsRefusedAtARestart) {
  const TemporaryDirectory space;
  RunOptions o = into(space / "run");
  o.until = 2e-3;
  run_case(measuring_case(), o);
  o.until.reset();
  o.restart = "latest";
  EXPECT_NE(refusal(measuring_case({"analysis.averages.all.cells=[3, 4, 6]"}), o).find("another grid"),
            std::string::npos);
}

}  // namespace
}  // namespace scree
