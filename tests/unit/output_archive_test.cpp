// Checkpoint files: bits come back as they were, and anything that is not a whole checkpoint is refused with its
// reason.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <bit>
#include <fstream>
#include <limits>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/archive.h"
#include "scree/output/hdf5_file.h"
#include "support/temporary_directory.h"

// The HDF5 library keeps a few hundred bytes of each file whose closing failed (full disk below); the leak checker of
// the sanitizer builds asks this function what not to count.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

namespace scree {
namespace {

namespace fs = std::filesystem;

/// Message of the InputError that `action` throws.
template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(not refused)";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Archive sample(const std::vector<double>& motion) {
  Archive archive;
  archive.set("time", 0.1);
  archive.set("step", std::int64_t{12345678901});
  archive.set("case", std::string("[simulation]\ntitle = \"\xC3\xA9\"\n"));
  archive.set("empty", std::string());
  archive.put("motion", motion, 4);
  archive.put("id", std::vector<std::int64_t>{1, -1, std::numeric_limits<std::int64_t>::max()});
  return archive;
}

TEST(Archive, EveryTypeComesBackBitForBit) {
  const test::TemporaryDirectory directory;
  const double quiet = std::bit_cast<double>(0x7ff8dead0000beefULL);
  const std::vector<double> odd = {-0.0, 5e-324, quiet, std::numeric_limits<double>::infinity(), 0.1, 1e308, -1.5, 3.0};
  const std::vector<float> single = {0.1F, -0.0F, 1e-45F};
  Archive written = sample(odd);
  written.put("single", single);
  written.put("small", std::vector<std::int32_t>{-7, 7}, 2);
  written.put("bytes", std::vector<std::uint8_t>{0, 255});
  written.put("word", std::vector<std::uint32_t>{4294967295U});
  written.put("long", std::vector<std::uint64_t>{18446744073709551615ULL});
  written.put("nothing", std::vector<double>{}, 8);
  write_archive(directory / "a.h5", written);
  const Archive read = read_archive(directory / "a.h5");

  const auto back = read.get<double>("motion", 4);
  ASSERT_EQ(back.size(), odd.size());
  for (std::size_t i = 0; i < odd.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back[i]), std::bit_cast<std::uint64_t>(odd[i])) << i;
  for (std::size_t i = 0; i < single.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint32_t>(read.get<float>("single")[i]), std::bit_cast<std::uint32_t>(single[i]));
  EXPECT_EQ(read.get<std::int64_t>("id")[2], std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(read.get<std::int32_t>("small", 2)[0], -7);
  EXPECT_EQ(read.get<std::uint8_t>("bytes")[1], 255);
  EXPECT_EQ(read.get<std::uint32_t>("word")[0], 4294967295U);
  EXPECT_EQ(read.get<std::uint64_t>("long")[0], 18446744073709551615ULL);
  EXPECT_EQ(read.get<double>("nothing", 8).size(), 0U);
  EXPECT_EQ(read.number("time"), 0.1);
  EXPECT_EQ(read.integer("step"), 12345678901);
  EXPECT_EQ(read.text("case"), written.text("case"));
  EXPECT_EQ(read.text("empty"), "");
}

TEST(Archive, OrderSurvivesAndAnEmptyArchiveIsFine) {
  const test::TemporaryDirectory directory;
  Archive written;
  for (const char* name : {"z", "a", "m"}) written.put(name, std::vector<double>{1});
  write_archive(directory / "a.h5", written);
  std::string order;
  const Archive read = read_archive(directory / "a.h5");
  for (const ArchivedArray& array : read.arrays()) order += array.name;
  EXPECT_EQ(order, "zam");
  write_archive(directory / "b.h5", Archive());
  EXPECT_TRUE(read_archive(directory / "b.h5").arrays().empty());
}

TEST(Archive, EqualContentsGiveEqualFiles) {
  const test::TemporaryDirectory directory;
  const std::vector<double> motion(4000, 0.5);
  write_archive(directory / "a.h5", sample(motion));
  write_archive(directory / "b.h5", sample(motion));
  EXPECT_EQ(read_text_file(directory / "a.h5"), read_text_file(directory / "b.h5"));
}

TEST(Archive, LvaluesAreBorrowedAndTemporariesKept) {
  std::vector<double> motion = {1, 2, 3, 4};
  Archive archive = sample(motion);
  motion[0] = 9;
  EXPECT_EQ(archive.get<double>("motion", 4)[0], 9);
  EXPECT_EQ(archive.get<double>("motion", 4).data(), motion.data());
  EXPECT_EQ(archive.get<std::int64_t>("id")[1], -1);
}

TEST(Archive, WrongNamesAndTypesAreRefused) {
  const std::vector<double> motion = {1, 2, 3, 4};
  Archive archive = sample(motion);
  archive.origin = "'x.h5'";
  EXPECT_EQ(refusal([&] { archive.get<double>("spin"); }), "'x.h5' holds no array 'spin'");
  EXPECT_EQ(refusal([&] { archive.get<float>("motion", 4); }),
            "'x.h5': array 'motion' holds float64 in 4 columns, expected float32 in 4");
  EXPECT_TRUE(holds(refusal([&] { archive.get<double>("motion", 8); }), "in 4 columns, expected float64 in 8"));
  EXPECT_TRUE(holds(refusal([&] { archive.number("step"); }), "'step' is not a number"));
  EXPECT_TRUE(holds(refusal([&] { archive.text("title"); }), "no value 'title'"));
  EXPECT_THROW(archive.put("motion", std::vector<double>{1}), std::logic_error);
  EXPECT_THROW(archive.set("a/b", 1.0), std::logic_error);
}

TEST(ArchiveFile, EveryFlippedBitIsFound) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory / "a.h5";
  write_archive(path, sample({1, 2, 3, 4}));
  const std::string whole = read_text_file(path);
  const auto try_flipped = [&](std::size_t at, unsigned bit) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1U << bit));
    std::ofstream(path, std::ios::binary) << damaged;
    EXPECT_TRUE(holds(refusal([&] { read_archive(path); }), "cannot restart from")) << at << ' ' << bit;
  };
  for (std::size_t at = 0; at < 512; at += 3) try_flipped(at, at % 8);
  for (std::size_t at = 512; at < whole.size(); at += 41) try_flipped(at, at % 8);
}

TEST(ArchiveFile, EachKindOfBadFileHasItsReason) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory / "a.h5";
  write_archive(path, sample({1, 2, 3, 4}));
  const std::string whole = read_text_file(path);
  const auto reason = [&](const std::string& contents) {
    std::ofstream(path, std::ios::binary) << contents;
    const std::string message = refusal([&] { read_archive(path); });
    EXPECT_TRUE(holds(message, path.string())) << message;
    return message;
  };
  EXPECT_TRUE(holds(reason(whole.substr(0, whole.size() - 1)), "it is incomplete"));
  EXPECT_TRUE(holds(reason(whole.substr(0, 600)), "it is incomplete: 600 bytes instead of"));
  EXPECT_TRUE(holds(reason(whole + "x"), "it is incomplete"));
  EXPECT_TRUE(holds(reason(whole.substr(0, 20)), "it is damaged"));
  EXPECT_TRUE(holds(reason(""), "it is not a checkpoint of Scree"));
  EXPECT_TRUE(holds(reason("time,step\n0,0\n"), "it is not a checkpoint of Scree"));
  std::string other = whole;
  other.replace(other.find("version 1"), 9, "version 7");
  EXPECT_TRUE(holds(reason(other), "checkpoint format 7, this program reads format 1"));
  std::string changed = whole;
  changed.back() = static_cast<char>(changed.back() + 1);
  EXPECT_TRUE(holds(reason(changed), "do not match their SHA-256"));
  std::ofstream(path, std::ios::binary) << whole;
  EXPECT_EQ(read_archive(path).get<double>("motion", 4)[3], 4);
}

TEST(ArchiveFile, MissingFilesDirectoriesAndFramesAreRefused) {
  const test::TemporaryDirectory directory;
  EXPECT_TRUE(holds(refusal([&] { read_archive(directory / "no.h5"); }), "No such file or directory"));
  EXPECT_TRUE(holds(refusal([&] { read_archive(directory.path()); }), "it is a directory"));
  Hdf5File frame = Hdf5File::create(directory / "frame.h5");
  frame.close();
  EXPECT_TRUE(holds(refusal([&] { read_archive(directory / "frame.h5"); }), "it is not a checkpoint of Scree"));
}

/// The files that this process writes may not grow beyond `bytes` while an object lives, as on a full disk.
struct DiskLimit {
  rlimit old{};
  explicit DiskLimit(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &old);
    const rlimit limit{bytes, old.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~DiskLimit() { ::setrlimit(RLIMIT_FSIZE, &old); }
};

// Also a test of the end of the program: without precautions the HDF5 library crashes in its exit handler.
TEST(ArchiveFile, FullDiskKeepsTheOldCheckpoint) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory / "a.h5";
  write_archive(path, sample({1, 2, 3, 4}));
  const std::string before = read_text_file(path);
  const std::vector<double> large(100000, 1.0);
  for (const rlim_t limit : {100U, 1000U, 3000U, 100000U, 800000U}) {
    const DiskLimit full(limit);
    try {
      write_archive(path, sample(large));
      ADD_FAILURE() << "not refused at " << limit;
    } catch (const ResourceError& error) {
      EXPECT_TRUE(holds(error.what(), path.string())) << error.what();
      EXPECT_TRUE(holds(error.what(), "File too large")) << error.what();
    }
  }
  EXPECT_EQ(read_text_file(path), before);
  write_archive(path, sample(large));
  EXPECT_EQ(read_archive(path).get<double>("motion", 4).size(), large.size());
  EXPECT_EQ(std::distance(fs::directory_iterator(directory.path()), fs::directory_iterator{}), 1);
}

}  // namespace
}  // namespace scree
