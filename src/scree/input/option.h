// Values of the command line's options, read and refused like those of a case.
#pragma once

#include <cstdint>
#include <string>

namespace scree {

/// An option as it was given: "scree COMMAND NAME TEXT".
struct OptionText {
  std::string command, name, text;
};

/// A whole number of at least 1. Throws InputError.
std::uint64_t read_count(const OptionText& option);

/// A time above 0, in seconds or with a unit, "2 ms" [s]. Throws InputError.
double read_time(const OptionText& option);

/// As read_time(), or hours, minutes and seconds of a clock, "2:30:00" or "30:00" [s]. Throws InputError.
double read_duration(const OptionText& option);

}  // namespace scree
