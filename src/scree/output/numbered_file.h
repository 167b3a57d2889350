// Names of files that come in numbered series, such as frame_000012.h5.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace scree {

/// A series: prefix, the number with at least `digits` digits, ".h5".
struct NumberedFiles {
  std::string_view prefix;
  int digits;
};

inline constexpr NumberedFiles frame_files{"frame_", 6};
inline constexpr NumberedFiles wall_files{"walls_", 6};
inline constexpr NumberedFiles contact_files{"contacts_", 6};
inline constexpr NumberedFiles fluid_files{"fluid_", 6};
inline constexpr NumberedFiles checkpoint_files{"checkpoint_", 12};

std::string numbered_name(const NumberedFiles& series, std::uint64_t number);

/// The number in a file name, or nothing if the name is not exactly one of the series.
std::optional<std::uint64_t> number_in(const NumberedFiles& series, std::string_view name);

/// The files of the series in a directory by their number; empty if there is no such directory.
std::map<std::uint64_t, std::filesystem::path> list_numbered(const NumberedFiles& series,
                                                             const std::filesystem::path& directory);

}  // namespace scree
