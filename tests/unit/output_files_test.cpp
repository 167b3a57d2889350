// A run directory as the output layer writes it, read by other people's readers and compared with docs/files.md.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/archive.h"
#include "scree/output/frames.h"
#include "scree/output/hdf5_file.h"
#include "scree/output/run_directory.h"
#include "scree/output/series.h"
#include "scree/output/summary.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// Particles on a line, with every field that docs/files.md lists.
struct Sample {
  std::uint64_t n;
  std::vector<std::int64_t> id, agglomerate;
  std::vector<double> position, velocity, spin, diameter, mass;
  std::vector<std::int32_t> material, group, size;

  explicit Sample(std::uint64_t count)
      : n(count),
        id(n),
        agglomerate(n, -1),
        position(3 * n),
        velocity(3 * n, 0.5),
        spin(3 * n),
        diameter(n, 1e-3),
        mass(n, 2.0),
        material(n, 1),
        group(n),
        size(n, 1) {
    for (std::uint64_t i = 0; i < n; ++i) {
      id[i] = static_cast<std::int64_t>(2 * i);
      position[3 * i] = 0.1 * static_cast<double>(i);
    }
  }

  std::vector<FrameColumn> columns() const {
    return {{"id", "1", "number for life", array_view(id.data(), n)},
            {"position", "m", "centre", array_view(position.data(), n, 3)},
            {"velocity", "m/s", "of the centre", array_view(velocity.data(), n, 3)},
            {"angular_velocity", "rad/s", "in the axes of space", array_view(spin.data(), n, 3)},
            {"diameter", "m", "of the body", array_view(diameter.data(), n)},
            {"mass", "kg", "mass", array_view(mass.data(), n)},
            {"material", "1", "index", array_view(material.data(), n)},
            {"group", "1", "index", array_view(group.data(), n)},
            {"agglomerate", "1", "number or -1", array_view(agglomerate.data(), n)},
            {"agglomerate_size", "1", "particles", array_view(size.data(), n)}};
  }
};

const Domain box{{0, 0, 0}, {1, 2, 3}, {true, false, true}};

std::vector<std::string> documented_columns(const std::string& section) {
  const std::string document = read_text_file(fs::path(SCREE_SOURCE_DIR) / "docs/files.md");
  const auto from = document.find("\n## " + section + "\n"), to = document.find("\n## ", from + 1);
  std::vector<std::string> names;
  for (auto at = document.find("\n| `", from); at < to; at = document.find("\n| `", at + 1)) {
    const std::string cell = document.substr(at + 3, document.find(" | ", at + 3) - at - 3);
    for (auto tick = cell.find('`'); tick != std::string::npos;) {
      const auto end = cell.find('`', tick + 1);
      const std::string name = cell.substr(tick + 1, end - tick - 1);
      // Columns with names of the case (WALL_force_x, _y) are not in every table.
      const bool usual =
          name.front() != '_' && std::none_of(name.begin(), name.end(), [](char c) { return std::isupper(c); });
      if (usual) names.push_back(name);
      tick = cell.find('`', end + 1);
    }
  }
  return names;
}

void write_table(const fs::path& path, const std::vector<std::string>& names) {
  SeriesWriter writer = SeriesWriter::create(path, names);
  for (int row = 0; row < 3; ++row) {
    std::vector<double> values(names.size(), 1.0 / 3);
    values[0] = 0.1 * row;
    values[1] = 4;
    writer.append(values);
  }
}

Summary sample_summary() {
  Summary summary;
  summary.version = "0.1.0";
  summary.status = "finished";
  summary.started = summary.ended = timestamp_now();
  summary.wall_seconds = 2.0;
  summary.stages = {{"contacts", 1.25}, {"motion", 0.5}};
  summary.particle_steps = 3000;
  summary.ledger = {{"energy_error", 1e-12}, {"fractal_dimension", std::nan("")}};
  summary.state_hash = std::string(64, 'a');
  return summary;
}

/// Runs the checks of tests/python/check_output.py; its output and 0, or its exit status.
int check(const fs::path& directory) {
  const std::string script = SCREE_SOURCE_DIR "/tests/python/check_output.py";
  const std::string document = SCREE_SOURCE_DIR "/docs/files.md";
  const int status =
      std::system(fmt::format("/usr/bin/python3 -B '{}' '{}' '{}'", script, directory.string(), document).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::vector<std::string> frames_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory / "frames"))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(OutputFiles, OtherReadersFindWhatTheDocumentSays) {
  const test::TemporaryDirectory directory;
  const RunDirectory run(directory / "run", Existing::refuse);
  write_text_file(run.case_file(), "[simulation]\n");
  FrameWriter frames = FrameWriter::create(run.path(), box, "scree 0.1.0");
  for (const std::uint64_t count : {5U, 0U, 70000U}) {
    const Sample sample(count);
    const double number = static_cast<double>(frames.count());
    frames.write(0.1 * number, 7 * frames.count(), sample.columns());
  }
  write_table(run.series(), documented_columns("series.csv"));
  write_table(run.tracks(), documented_columns("tracks.csv"));
  write_summary(run.summary(), sample_summary());
  Archive archive;
  archive.set("time", 0.2);
  archive.put("motion", std::vector<double>{1, 2, 3});
  write_archive(run.checkpoint(14), archive);
  EXPECT_EQ(check(run.path()), 0);

  // The check itself must be able to fail: a frame that the XDMF file does not name.
  fs::copy_file(run.path() / "frames/frame_000000.h5", run.path() / "frames/frame_000003.h5");
  EXPECT_EQ(check(run.path()), 1);
}

TEST(Frames, ARestartDropsLaterFramesAndGoesOn) {
  const test::TemporaryDirectory directory;
  const Sample sample(4);
  {
    FrameWriter frames = FrameWriter::create(directory.path(), box, "scree");
    for (int i = 0; i < 4; ++i) frames.write(0.25 * i, 10 * static_cast<std::uint64_t>(i), sample.columns());
  }
  const std::string all = read_text_file(directory / "fields.xdmf");
  FrameWriter frames = FrameWriter::resume(directory.path(), box, "scree", 0.25);
  EXPECT_EQ(frames_in(directory.path()), (std::vector<std::string>{"frame_000000.h5", "frame_000001.h5"}));
  EXPECT_EQ(read_text_file(directory / "fields.xdmf").find("frame_000002"), std::string::npos);
  EXPECT_EQ(frames.count(), 2U);
  frames.write(0.5, 20, sample.columns());
  frames.write(0.75, 30, sample.columns());
  EXPECT_EQ(read_text_file(directory / "fields.xdmf"), all);
  EXPECT_EQ(frames_in(directory.path()).size(), 4U);
}

TEST(Frames, AFileThatIsNoFrameStopsARestart) {
  const test::TemporaryDirectory directory;
  fs::create_directories(directory / "frames");
  std::ofstream(directory / "frames/frame_000000.h5") << "no frame";
  EXPECT_THROW(FrameWriter::resume(directory.path(), box, "scree", 1.0), InputError);
  Hdf5File file = Hdf5File::create(directory / "frames/frame_000000.h5");
  file.set_attribute("/", "format", "something else");
  file.close();
  EXPECT_THROW(FrameWriter::resume(directory.path(), box, "scree", 1.0), InputError);
}

TEST(Frames, ColumnsOfDifferentLengthAreAProgrammingError) {
  const test::TemporaryDirectory directory;
  FrameWriter frames = FrameWriter::create(directory.path(), box, "scree");
  const Sample sample(4);
  std::vector<FrameColumn> columns = sample.columns();
  columns[3].values.rows = 3;
  EXPECT_THROW(frames.write(0, 0, columns), std::logic_error);
}

TEST(Hdf5File, FailuresNameFilePlaceAndReason) {
  const test::TemporaryDirectory directory;
  const auto refusal = [](auto&& action) -> std::string {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "(not refused)";
  };
  EXPECT_EQ(refusal([&] { Hdf5File::open(directory / "no.h5"); }),
            "cannot read '" + (directory / "no.h5").string() + "': No such file or directory");
  EXPECT_NE(refusal([] { Hdf5File::create("/nonexistent/a.h5"); }).find("'/nonexistent/a.h5': No such file"),
            std::string::npos);
  Hdf5File file = Hdf5File::create(directory / "a.h5");
  const double value = 1;
  file.write("x", array_view(&value, 1));
  EXPECT_NE(refusal([&] { file.write("x", array_view(&value, 1)); }).find("('x')"), std::string::npos);
  file.close();
  const Hdf5File read = Hdf5File::open(directory / "a.h5");
  EXPECT_TRUE(read.contains("x"));
  EXPECT_FALSE(read.contains("y"));
  EXPECT_THROW(read.shape("y"), InputError);
  EXPECT_THROW(read.text_attribute("/", "title"), InputError);
}

TEST(Summary, SpeedIsDerivedAndOrderKept) {
  const auto json = nlohmann::ordered_json::parse(summary_text(sample_summary()));
  EXPECT_EQ(json["particle_steps_per_second"], 1500.0);
  EXPECT_EQ(json["stages"].begin().key(), "contacts");
  EXPECT_TRUE(json["ledger"]["fractal_dimension"].is_null());
  Summary odd = sample_summary();
  odd.case_file = "caf\xE9.toml";  // Latin-1, as a file system may hold
  odd.wall_seconds = 0;
  EXPECT_EQ(nlohmann::json::parse(summary_text(odd))["particle_steps_per_second"], 0.0);
}

}  // namespace
}  // namespace scree
