// Who may write in a run directory, what --force removes, and which checkpoint is the newest.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/archive.h"
#include "scree/output/run_directory.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(not refused)";
}

std::set<std::string> contents(const fs::path& directory) {
  std::set<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) found.insert(entry.path().lexically_relative(directory).string());
  return found;
}

void touch(const fs::path& path) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "x";
}

TEST(RunDirectory, IsMadeWithItsFolders) {
  const test::TemporaryDirectory directory;
  const RunDirectory run(directory / "a" / "b", Existing::refuse);
  EXPECT_TRUE(fs::is_directory(directory / "a" / "b" / "frames"));
  EXPECT_EQ(run.checkpoint(42).string(), (directory / "a/b/checkpoints/checkpoint_000000000042.h5").string());
}

TEST(RunDirectory, AnEmptyOneIsTakenAndAFullOneRefused) {
  const test::TemporaryDirectory directory;
  { const RunDirectory run(directory.path(), Existing::refuse); }
  const std::string message = refusal([&] { RunDirectory(directory.path(), Existing::refuse); });
  for (const char* part : {"is not empty", "--force", "--restart", "-o DIR"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  touch(directory / "file");
  EXPECT_NE(refusal([&] { RunDirectory(directory / "file", Existing::replace); }).find("is a file"), std::string::npos);
  EXPECT_NE(refusal([&] { RunDirectory(directory / "no", Existing::resume); }).find("no run directory"),
            std::string::npos);
}

TEST(RunDirectory, ForceRemovesOnlyFilesOfScree) {
  const test::TemporaryDirectory directory;
  const std::set<std::string> own = {"case.toml",
                                     "fields.xdmf",
                                     "series.csv",
                                     "tracks.csv",
                                     "summary.json",
                                     "frames/frame_000000.h5",
                                     "frames/frame_1000000.h5",
                                     "walls/walls_000000.h5",
                                     "walls.xdmf",
                                     "frames/frame_000001.h5.part",
                                     "checkpoints/checkpoint_000000000007.h5",
                                     "series.csv.part"};
  const std::set<std::string> others = {"notes.txt",
                                        "frames/frame_1.h5",
                                        "frames/frame_000000.h5.bak",
                                        "frames/mine.h5",
                                        "checkpoints/checkpoint_000000000007x.h5",
                                        "frames/deep/frame_000000.h5",
                                        "frame_000000.h5",
                                        "frames/notes.part"};
  for (const auto& name : own) touch(directory / name);
  for (const auto& name : others) touch(directory / name);
  { const RunDirectory run(directory.path(), Existing::replace); }
  EXPECT_EQ(contents(directory.path()), others);
}

TEST(RunDirectory, ForceNeverReplacesTheCaseItself) {
  const test::TemporaryDirectory directory;
  touch(directory / "case.toml");
  touch(directory / "series.csv");
  fs::create_symlink(directory / "case.toml", directory / "link.toml");
  EXPECT_NE(refusal([&] {
              RunDirectory(directory.path(), Existing::replace, directory / "link.toml");
            }).find("is the case itself"),
            std::string::npos);
  EXPECT_EQ(contents(directory.path()), (std::set<std::string>{"case.toml", "link.toml", "series.csv"}));
}

TEST(RunDirectory, ResumeKeepsFilesAndDropsLeftovers) {
  const test::TemporaryDirectory directory;
  for (const char* name : {"series.csv", "frames/frame_000000.h5", "frames/frame_000001.h5.part", "fields.xdmf.part"})
    touch(directory / name);
  const RunDirectory run(directory.path(), Existing::resume);
  EXPECT_EQ(contents(directory.path()), (std::set<std::string>{"series.csv", "frames/frame_000000.h5"}));
}

TEST(RunDirectory, TwoRunsInOneDirectoryAreRefused) {
  const test::TemporaryDirectory directory;
  {
    const RunDirectory run(directory.path(), Existing::refuse);
    for (const Existing existing : {Existing::refuse, Existing::replace, Existing::resume})
      EXPECT_NE(refusal([&] { RunDirectory(directory.path(), existing); }).find("another run is writing"),
                std::string::npos);
  }
  EXPECT_EQ(refusal([&] { RunDirectory(directory.path(), Existing::resume); }), "(not refused)");
}

TEST(RunDirectory, TheLastTwoCheckpointsStayAndTheNewestWholeOneIsFound) {
  const test::TemporaryDirectory directory;
  const RunDirectory run(directory.path(), Existing::refuse);
  EXPECT_FALSE(newest_checkpoint(directory.path()).path);
  for (const std::uint64_t step : {5U, 100U, 20U, 999U}) write_archive(run.checkpoint(step), Archive());
  run.prune_checkpoints();
  EXPECT_EQ(contents(directory.path()), (std::set<std::string>{"checkpoints/checkpoint_000000000100.h5",
                                                               "checkpoints/checkpoint_000000000999.h5"}));
  EXPECT_EQ(newest_checkpoint(directory.path()).path, run.checkpoint(999));
  std::ofstream(run.checkpoint(999), std::ios::app) << "damage";
  const NewestCheckpoint found = newest_checkpoint(directory.path());
  EXPECT_EQ(found.path, run.checkpoint(100));
  ASSERT_EQ(found.refused.size(), 1U);
  EXPECT_NE(found.refused[0].find("incomplete"), std::string::npos);
  run.drop_checkpoints_after(100);
  EXPECT_EQ(contents(directory.path()), (std::set<std::string>{"checkpoints/checkpoint_000000000100.h5"}));
}

}  // namespace
}  // namespace scree
