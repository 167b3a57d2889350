#include "scree/input/option.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "scree/base/error.h"
#include "scree/input/problem.h"
#include "scree/input/read_value.h"

namespace scree {
namespace {

template <class T>
std::optional<T> whole_text(const std::string& text) {
  T out{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), out);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
  return out;
}

/// Where the option's text stands in "NAME TEXT".
Place place_of(const OptionText& option) {
  return {1, 1, characters(option.name) + 2, std::max(1, characters(option.text))};
}

[[noreturn]] void refuse(const OptionText& option, std::vector<Problem> problems) {
  Sources sources{"", "", {fmt::format("{} {}", option.name, option.text)}};
  sources.before_override = "";
  throw InputError(render(sources, std::move(problems), false));
}

template <class T>
struct Holder {
  T value{};
};

/// Reads the text as a key would be read that is declared by `declare`.
template <class T, class Declare>
T read(const OptionText& option, const Declare& declare) {
  Holder<T> holder;
  const Key declared = declare(key(option.name.c_str(), &Holder<T>::value, ""));
  const Section section = {"", option.command, "", {}, {}};
  Value value{place_of(option), option.text};
  if (const auto integer = whole_text<std::int64_t>(option.text))
    value.data = *integer;
  else if (const auto number = whole_text<double>(option.text))
    value.data = *number;
  std::vector<Problem> problems;
  if (!read_value(section, declared, option.name, value, &holder, problems)) refuse(option, std::move(problems));
  return holder.value;
}

/// "2:30:00" or "30:00" as seconds; empty if the text is none of these.
std::optional<double> clock_time(const std::string& text) {
  double total = 0;
  int parts = 0;
  for (std::size_t at = 0; at <= text.size(); ++parts) {
    const std::size_t end = std::min(text.find(':', at), text.size());
    const auto part = whole_text<unsigned>(text.substr(at, end - at));
    if (!part || (parts > 0 && *part >= 60)) return {};
    total = 60 * total + *part;
    at = end + 1;
  }
  return parts == 2 || parts == 3 ? std::optional(total) : std::nullopt;
}

}  // namespace

std::uint64_t read_count(const OptionText& option) {
  return read<std::uint64_t>(option, [](Key k) { return k.at_least(1).at_most(2147483647); });
}

double read_time(const OptionText& option) {
  return read<double>(option, [](Key k) { return k.unit("s").above(0); });
}

double read_duration(const OptionText& option) {
  if (option.text.find(':') == std::string::npos) return read_time(option);
  const std::optional<double> seconds = clock_time(option.text);
  if (!seconds || *seconds == 0)
    refuse(option,
           {{"E121", place_of(option), fmt::format("'{}' is not a duration", option.text),
             "expected hours:minutes:seconds", "write \"2:30:00\", \"90 s\" or \"1.5 h\"   (scree run --help)"}});
  return *seconds;
}

}  // namespace scree
