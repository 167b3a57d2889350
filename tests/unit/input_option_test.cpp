// Options of the command line: units, clocks, and refusals in the form of all errors.
#include <gtest/gtest.h>

#include "scree/base/error.h"
#include "scree/input/option.h"

namespace scree {
namespace {

template <class Read>
std::string refusal(Read read, const char* name, const char* text) {
  try {
    read(OptionText{"run", name, text});
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Option, TimesTakeUnits) {
  EXPECT_EQ(read_time({"run", "--until", "0.5"}), 0.5);
  EXPECT_EQ(read_time({"run", "--until", "3"}), 3);
  EXPECT_EQ(read_time({"run", "--until", "2 ms"}), 2e-3);
  EXPECT_EQ(refusal(read_time, "--until", "2 mm"),
            "--until 2 mm: error[E120]: '--until' is in s, but 'mm' is not convertible to it\n"
            "      | --until 2 mm\n"
            "      |         ^^^^ expected a unit convertible to s\n"
            "      = help: scree explain units lists the units   (scree run --help)");
  EXPECT_EQ(refusal(read_time, "--until", "-1"),
            "--until -1: error[E130]: '--until' must be above 0 s, but is -1\n"
            "      | --until -1\n"
            "      |         ^^ must be above 0\n"
            "      = help: scree run --help");
  EXPECT_NE(refusal(read_time, "--until", "soon").find("error[E121]"), std::string::npos);
  EXPECT_NE(refusal(read_time, "--until", "").find("error["), std::string::npos);
  EXPECT_NE(refusal(read_time, "--until", "inf").find("error[E131]"), std::string::npos);
}

TEST(Option, DurationsTakeClocksToo) {
  EXPECT_EQ(read_duration({"run", "--wall-time", "90 s"}), 90);
  EXPECT_EQ(read_duration({"run", "--wall-time", "1.5 h"}), 5400);
  EXPECT_EQ(read_duration({"run", "--wall-time", "2:30:00"}), 9000);
  EXPECT_EQ(read_duration({"run", "--wall-time", "100:00:01"}), 360001);
  EXPECT_EQ(read_duration({"run", "--wall-time", "01:30"}), 90);
  for (const char* wrong : {"2:60:00", "1:2:3:4", "2:", ":30", "0:00", "1:-3", "a:b", "1.5:00"})
    EXPECT_NE(refusal(read_duration, "--wall-time", wrong).find("error[E121]: '" + std::string(wrong)),
              std::string::npos)
        << refusal(read_duration, "--wall-time", wrong);
}

TEST(Option, CountsAreWholeAndAtLeastOne) {
  EXPECT_EQ(read_count({"bench", "--threads", "3"}), 3u);
  EXPECT_NE(refusal(read_count, "--threads", "0").find("'--threads' must be from 1 to 2147483647, but is 0"),
            std::string::npos);
  EXPECT_NE(refusal(read_count, "--threads", "1.5").find("must be a whole number, not 1.5"), std::string::npos);
  EXPECT_NE(refusal(read_count, "--threads", "two").find("must be a whole number, not a text"), std::string::npos);
  EXPECT_NE(refusal(read_count, "--threads", "9999999999").find("error[E130]"), std::string::npos);
}

}  // namespace
}  // namespace scree
