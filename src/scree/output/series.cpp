// Rows of numbers appended to a CSV file, and the cut of an old one at the time of a restart.
#include "scree/output/series.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// Takes the next line off `text`, without its end; a last line without one was torn by a kill and is dropped.
bool next_line(std::string_view& text, std::string_view& line) {
  const auto end = text.find('\n');
  if (end == std::string_view::npos) return false;
  line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return true;
}

/// The first line of a table without its end; empty when a kill has torn it.
std::string names_line(const fs::path& path) {
  const std::string contents = read_text_file(path);
  std::string_view rest = contents, line;
  return next_line(rest, line) ? std::string(line) : std::string();
}

/// The names of one header that another has not, for a message; empty if there are none.
std::string names_without(std::string_view header, std::string_view other, std::string_view label) {
  const auto parts = [](std::string_view text) {
    std::vector<std::string> out;
    for (std::size_t end = 0; end != std::string_view::npos; text.remove_prefix(std::min(text.size(), end + 1))) {
      end = text.find(',');
      out.emplace_back(text.substr(0, end));
    }
    return out;
  };
  const std::vector<std::string> known = parts(other);
  std::vector<std::string> alone;
  for (const std::string& name : parts(header))
    if (std::ranges::find(known, name) == known.end()) alone.push_back(name);
  return alone.empty() ? "" : fmt::format("\n  {}: {}", label, fmt::join(alone, ", "));
}

[[noreturn]] void refuse_columns(const fs::path& path, const std::string& found, const std::string& expected) {
  const std::string differences = names_without(expected, found, "this run has in addition") +
                                  names_without(found, expected, "the file has in addition");
  throw InputError(
      fmt::format("cannot append to '{}': its columns are not those of this run{}\n  = help: restart into a new "
                  "directory (-o DIR), "
                  "or give back what the case measured",
                  path.string(), differences.empty() ? "\n  they come in another order" : differences));
}

}  // namespace

void drop_rows_after(const fs::path& path, double last_time) {
  const std::string contents = read_text_file(path);
  std::string_view rest = contents, line;
  if (!next_line(rest, line)) {
    fs::remove(path);
    return;
  }
  const auto columns = 1 + std::ranges::count(line, ',');
  std::string kept = std::string(line) + "\n";
  for (std::size_t number = 2; next_line(rest, line); ++number) {
    double time = 0;
    const auto parsed = std::from_chars(line.data(), line.data() + line.size(), time);
    if (parsed.ec != std::errc() || 1 + std::ranges::count(line, ',') != columns)
      throw InputError(
          fmt::format("{}:{}: not a row of {} numbers; mend or remove the line", path.string(), number, columns));
    if (time <= last_time) kept.append(line).append("\n");
  }
  if (kept != contents) write_text_file(path, kept);
}

SeriesWriter::SeriesWriter(fs::path path, std::size_t columns)
    : path_(std::move(path)), columns_(columns), descriptor_(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {
  if (descriptor_ < 0) throw ResourceError(fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)));
}

SeriesWriter::SeriesWriter(SeriesWriter&& other) noexcept
    : path_(std::move(other.path_)), columns_(other.columns_), descriptor_(std::exchange(other.descriptor_, -1)) {}

SeriesWriter::~SeriesWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

SeriesWriter SeriesWriter::create(const fs::path& path, std::vector<std::string> names) {
  write_text_file(path, fmt::format("{}\n", fmt::join(names, ",")));
  return SeriesWriter(path, names.size());
}

SeriesWriter SeriesWriter::resume(const fs::path& path, std::vector<std::string> names, double last_time) {
  const std::string expected = fmt::format("{}", fmt::join(names, ",")),
                    found = fs::exists(path) ? names_line(path) : "";
  if (found.empty()) return create(path, std::move(names));
  if (found != expected) refuse_columns(path, found, expected);
  drop_rows_after(path, last_time);
  return SeriesWriter(path, names.size());
}

void SeriesWriter::append(std::span<const double> values) {
  if (values.size() % columns_ != 0) throw std::logic_error("a series takes whole rows");
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < values.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{}{}", values[i], (i + 1) % columns_ == 0 ? '\n' : ',');
  const off_t end = ::lseek(descriptor_, 0, SEEK_END);
  try {
    write_all(descriptor_, {text.data(), text.size()}, path_);
  } catch (const ResourceError&) {
    // A full disk takes half a row; should the cut fail too, a restart drops the torn line.
    std::error_code ignored;
    if (end >= 0) fs::resize_file(path_, static_cast<std::uintmax_t>(end), ignored);
    throw;
  }
}

}  // namespace scree
