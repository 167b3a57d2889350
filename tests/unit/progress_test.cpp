// The progress line: what it says, how wide it is, and how often it appears; on a clock that the test turns.
#include "scree/app/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace scree {
namespace {

ProgressState half_way() {
  ProgressState state;
  state.time = 1.0;
  state.end = 2.0;
  state.fraction = 0.5;
  state.speed = 1.8e6;
  state.remaining = 842;
  state.note = "KE 3.2e-4 J";
  return state;
}

/// A progress display writing into memory, with a clock that stands still until it is moved.
struct Display {
  char* text = nullptr;
  std::size_t size = 0;
  double now = 100;
  std::FILE* stream = open_memstream(&text, &size);
  ProgressOptions options;

  explicit Display(bool terminal) {
    options.stream = stream;
    options.terminal = terminal;
    options.width = [] { return 100; };
    options.now = [this] { return now; };
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  ~Display() {
    std::fclose(stream);
    std::free(text);
  }
  std::string shown() const { return {text, size}; }
  long lines() const {
    const std::string all = shown();
    return std::count(all.begin(), all.end(), '\n');
  }
};

TEST(ProgressText, ClockIsHoursMinutesSeconds) {
  EXPECT_EQ(clock_text(0), "00:00:00");
  EXPECT_EQ(clock_text(842), "00:14:02");
  EXPECT_EQ(clock_text(3600 * 123 + 59.2), "123:01:00");
}

TEST(ProgressText, PlainLine) {
  EXPECT_EQ(progress_line(half_way()), "t = 1 / 2 s |  50 % | 1.80e+06 particle-steps/s | ETA 00:14:02 | KE 3.2e-4 J");
  ProgressState first;
  first.end = 2;
  EXPECT_EQ(progress_line(first), "t = 0 / 2 s |   0 %");
}

TEST(ProgressText, BarFillsAndNeverExceedsTheWidth) {
  const std::string wide = progress_bar(half_way(), 200, false);
  EXPECT_NE(wide.find("[####################--------------------]  50 %"), std::string::npos) << wide;
  EXPECT_NE(wide.find("| KE 3.2e-4 J"), std::string::npos);
  for (int width = 0; width <= 200; ++width)
    EXPECT_LE(progress_bar(half_way(), width, false).size(), static_cast<std::size_t>(width));
  ProgressState done = half_way();
  done.fraction = 1;
  EXPECT_NE(progress_bar(done, 200, false).find("[########################################] 100 %"), std::string::npos);
}

TEST(ProgressText, ColourAddsOnlyEscapes) {
  std::string coloured = progress_bar(half_way(), 120, true);
  const std::string plain = progress_bar(half_way(), 120, false);
  EXPECT_NE(coloured, plain);
  for (const std::string escape : {"\x1b[32m", "\x1b[0m"}) coloured.erase(coloured.find(escape), escape.size());
  EXPECT_EQ(coloured, plain);
}

TEST(Progress, DueAtTenHertzOnATerminalAndOneElsewhere) {
  for (const bool terminal : {true, false}) {
    Display display(terminal);
    Progress progress(display.options, 0, 1);
    EXPECT_FALSE(progress.due());
    display.now += terminal ? 0.09 : 0.9;
    EXPECT_FALSE(progress.due());
    display.now += terminal ? 0.02 : 0.2;
    EXPECT_TRUE(progress.due());
    progress.update(0.1, 10, "");
    EXPECT_FALSE(progress.due());
  }
}

TEST(Progress, ATerminalIsRewrittenInPlace) {
  Display display(true);
  Progress progress(display.options, 0, 10);
  for (int i = 1; i <= 5; ++i) {
    display.now += 1;
    progress.update(i, static_cast<std::uint64_t>(1000 * i), "");
  }
  EXPECT_EQ(display.lines(), 0);
  EXPECT_NE(display.shown().find("50 % | 1.00e+03 particle-steps/s | ETA 00:00:05\x1b[K"), std::string::npos);
  progress.finish(10, 10000, "closed");
  EXPECT_EQ(display.lines(), 1);
  EXPECT_TRUE(display.shown().ends_with("\x1b[K\n"));
}

TEST(Progress, ALogGetsALinePerTenthOrTenSeconds) {
  Display quick(false);
  Progress tenths(quick.options, 0, 100);
  for (int i = 1; i <= 99; ++i) {
    quick.now += 0.5;
    tenths.update(i, 1, "");
  }
  EXPECT_EQ(quick.lines(), 9);
  Display slow(false);
  Progress seconds(slow.options, 0, 1e6);
  for (int i = 1; i <= 60; ++i) {
    slow.now += 1;
    seconds.update(i, 1, "");
  }
  EXPECT_EQ(slow.lines(), 6);
}

TEST(Progress, ARestartCountsFromWhereItBegan) {
  Display display(false);
  Progress progress(display.options, 8, 10);
  display.now += 10;
  progress.update(9, 500, "");
  EXPECT_NE(display.shown().find("t = 9 / 10 s |  50 % | 5.00e+01 particle-steps/s | ETA 00:00:10"), std::string::npos)
      << display.shown();
}

TEST(Progress, TheLastLineSumsUp) {
  Display display(false);
  Progress progress(display.options, 0, 10);
  for (const double wait : {1.0, 19.0}) {
    display.now += wait;
    progress.update(wait == 1.0 ? 5 : 9, wait == 1.0 ? 1000 : 1900, "");
  }
  display.now += 5;
  progress.finish(10, 5000, "energy closed");
  EXPECT_TRUE(display.shown().ends_with("t = 10 / 10 s | 100 % | 2.00e+02 particle-steps/s | energy closed\n"))
      << display.shown();
}

TEST(Progress, AFileIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  EXPECT_FALSE(detect_progress(file).terminal);
  EXPECT_FALSE(detect_progress(file).colour);
  EXPECT_EQ(detect_progress(file).width(), 80);
  std::fclose(file);
}

}  // namespace
}  // namespace scree
