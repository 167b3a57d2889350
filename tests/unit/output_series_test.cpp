// Growing CSV tables: exact numbers, and a clean cut at the time of a restart.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/series.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

const std::vector<std::string> names = {"time", "step", "energy"};

std::string message(const std::filesystem::path& path, double last_time) {
  try {
    SeriesWriter::resume(path, names, last_time);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(not refused)";
}

TEST(Series, NumbersAreShortAndComeBackExactly) {
  const test::TemporaryDirectory directory;
  std::mt19937_64 random(7);
  std::vector<double> values = {0.1, 0, 1e-300, 1.0 / 3, 3, std::numeric_limits<double>::max()};
  for (int i = 0; i < 300; ++i)
    values.push_back(std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 900) - 500));
  SeriesWriter writer = SeriesWriter::create(directory / "series.csv", names);
  writer.append(values);
  std::istringstream text(read_text_file(directory / "series.csv"));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "time,step,energy");
  std::getline(text, line);
  EXPECT_EQ(line, "0.1,0,1e-300");
  text.seekg(17);
  std::string number;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::getline(text, number, i % 3 == 2 ? '\n' : ',');
    EXPECT_EQ(std::strtod(number.c_str(), nullptr), values[i]) << number;
  }
}

TEST(Series, RowsAreInTheFileAtOnce) {
  const test::TemporaryDirectory directory;
  SeriesWriter writer = SeriesWriter::create(directory / "series.csv", names);
  EXPECT_EQ(read_text_file(directory / "series.csv"), "time,step,energy\n");
  writer.append(std::vector<double>{0, 0, 1.5});
  EXPECT_EQ(read_text_file(directory / "series.csv"), "time,step,energy\n0,0,1.5\n");
  EXPECT_THROW(writer.append(std::vector<double>{1, 2}), std::logic_error);
}

TEST(Series, ARestartDropsLaterRowsAndATornOne) {
  const test::TemporaryDirectory directory;
  const auto path = directory / "series.csv";
  const double at = 0.1 + 0.2;  // not the double nearest to 0.3
  {
    SeriesWriter writer = SeriesWriter::create(path, names);
    writer.append(std::vector<double>{0, 0, 1, at, 1, 2, 0.5, 2, 3});
  }
  std::ofstream(path, std::ios::app) << "0.2,9";
  SeriesWriter writer = SeriesWriter::resume(path, names, at);
  EXPECT_EQ(read_text_file(path), "time,step,energy\n0,0,1\n0.30000000000000004,1,2\n");
  writer.append(std::vector<double>{0.5, 2, 4});
  EXPECT_EQ(read_text_file(path), "time,step,energy\n0,0,1\n0.30000000000000004,1,2\n0.5,2,4\n");
}

TEST(Series, ARestartWithoutATableMakesOne) {
  const test::TemporaryDirectory directory;
  SeriesWriter::resume(directory / "new.csv", names, 1.0);
  EXPECT_EQ(read_text_file(directory / "new.csv"), "time,step,energy\n");
  std::ofstream(directory / "torn.csv") << "time,st";
  SeriesWriter::resume(directory / "torn.csv", names, 1.0);
  EXPECT_EQ(read_text_file(directory / "torn.csv"), "time,step,energy\n");
}

TEST(Series, OtherColumnsAndForeignLinesAreRefusedAndKept) {
  const test::TemporaryDirectory directory;
  const auto path = directory / "series.csv";
  const auto refusal = [&](const std::string& contents) {
    write_text_file(path, contents);
    const std::string found = message(path, 1.0);
    EXPECT_EQ(read_text_file(path), contents);
    return found;
  };
  EXPECT_NE(refusal("time,mass,energy\n0,1,1\n")
                .find("not those of this run\n  this run has in addition: step\n  the file has in addition: mass\n"),
            std::string::npos);
  EXPECT_NE(refusal("time,energy,step\n0,1,1\n").find("not those of this run\n  they come in another order\n"),
            std::string::npos);
  EXPECT_NE(refusal("time,step,energy\n0,0,1\nnote,0,1\n").find("series.csv:3: not a row of 3 numbers"),
            std::string::npos);
  EXPECT_NE(refusal("time,step,energy\n0,1\n").find("series.csv:2: not a row of 3 numbers"), std::string::npos);
}

TEST(Series, AMissingDirectoryIsTheMachinesRefusal) {
  EXPECT_THROW(SeriesWriter::create("/nonexistent/series.csv", names), ResourceError);
}

}  // namespace
}  // namespace scree
