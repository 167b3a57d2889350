// Making and recognising the names of numbered files.
#include "scree/output/numbered_file.h"

#include <fmt/format.h>

#include <charconv>

namespace scree {

namespace fs = std::filesystem;

std::string numbered_name(const NumberedFiles& series, std::uint64_t number) {
  return fmt::format("{}{:0{}}.h5", series.prefix, number, series.digits);
}

std::optional<std::uint64_t> number_in(const NumberedFiles& series, std::string_view name) {
  if (!name.starts_with(series.prefix)) return std::nullopt;
  std::uint64_t number = 0;
  const std::string_view rest = name.substr(series.prefix.size());
  if (std::from_chars(rest.data(), rest.data() + rest.size(), number).ec != std::errc()) return std::nullopt;
  if (name != numbered_name(series, number)) return std::nullopt;
  return number;
}

std::map<std::uint64_t, fs::path> list_numbered(const NumberedFiles& series, const fs::path& directory) {
  std::map<std::uint64_t, fs::path> found;
  if (!fs::is_directory(directory)) return found;
  for (const auto& entry : fs::directory_iterator(directory))
    if (const auto number = number_in(series, entry.path().filename().string())) found[*number] = entry.path();
  return found;
}

}  // namespace scree
