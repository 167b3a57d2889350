// Files that appear whole or not at all.
#include <gtest/gtest.h>

#include <fstream>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator{}));
}

TEST(AtomicFile, TextComesBackByteForByte) {
  const test::TemporaryDirectory directory;
  for (const std::string& text :
       {std::string(), std::string("a\nb"), std::string("\0x\r\n", 4), std::string(100000, 'z')}) {
    write_text_file(directory / "text", text);
    EXPECT_EQ(read_text_file(directory / "text"), text);
  }
  EXPECT_EQ(files_in(directory.path()), 1U);
}

TEST(AtomicFile, FailedWriterLeavesTheOldFileAndNothingElse) {
  const test::TemporaryDirectory directory;
  write_text_file(directory / "text", "old");
  const auto half = [](const fs::path& temporary) {
    std::ofstream(temporary) << "half";
    throw ResourceError("disk full");
  };
  EXPECT_THROW(write_atomically(directory / "text", half), ResourceError);
  EXPECT_EQ(read_text_file(directory / "text"), "old");
  EXPECT_EQ(files_in(directory.path()), 1U);
}

TEST(AtomicFile, RefusalsNameThePath) {
  const test::TemporaryDirectory directory;
  try {
    write_text_file(directory / "missing" / "text", "x");
    FAIL();
  } catch (const ResourceError& error) {
    EXPECT_NE(std::string(error.what()).find("missing/text': No such file"), std::string::npos) << error.what();
  }
  EXPECT_THROW(read_text_file(directory / "missing"), InputError);
  EXPECT_THROW(read_text_file(directory.path()), InputError);
}

}  // namespace
}  // namespace scree
