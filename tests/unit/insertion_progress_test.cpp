// The line about random insertion: nothing for short ones, on a clock that the test turns.
#include "scree/app/insertion_progress.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "scree/particles/insert.h"

namespace scree {
namespace {

/// What is shown of an insertion of 100 particles, with a try every half second.
std::string shown(bool terminal, double seconds) {
  char* text = nullptr;
  std::size_t size = 0;
  ProgressOptions options;
  options.stream = open_memstream(&text, &size);
  options.terminal = terminal;
  double now = 100;
  options.now = [&now] { return now; };
  InsertionWatch watch = InsertionProgress(options);
  const int tries = static_cast<int>(2 * seconds);
  for (int k = 0; k < tries; ++k, now += 0.5) watch("rods", static_cast<std::size_t>(100 * k / tries), 100);
  watch("rods", 100, 100);
  std::fclose(options.stream);
  const std::string out(text, size);
  std::free(text);
  return out;
}

TEST(InsertionProgress, ShortInsertionsSayNothing) {
  EXPECT_EQ(shown(false, 3), "");
  EXPECT_EQ(shown(true, 3), "");
}

TEST(InsertionProgress, ALineNowAndThen) {
  EXPECT_EQ(
      shown(false, 25),
      "inserting 'rods': 12 of 100 placed\ninserting 'rods': 52 of 100 placed\ninserting 'rods': 92 of 100 placed\n");
}

TEST(InsertionProgress, OneLineOnATerminal) {
  EXPECT_EQ(shown(true, 4),
            "\rinserting 'rods': 75 of 100 placed\rinserting 'rods': 87 of 100 placed"
            "\rinserting 'rods': 100 of 100 placed\n");
}

}  // namespace
}  // namespace scree
