// Rendering of problems in the manner of a compiler.
#include "scree/input/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace scree {
namespace {

constexpr std::size_t most_shown = 50;
constexpr int widest_line = 120;  // longer source lines are shown in part

struct Paint {
  const char *error, *strong, *gutter, *mark, *reset;
};

Paint paint(bool colour) {
  if (!colour) return {"", "", "", "", ""};
  return {"\033[1;31m", "\033[1m", "\033[34m", "\033[31m", "\033[0m"};
}

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Byte offset of the n-th character (from 0); the size of the text beyond its end.
std::size_t byte_of(std::string_view text, int n) {
  std::size_t at = 0;
  for (; n > 0 && at < text.size(); --n)
    for (++at; at < text.size() && continues(text[at]);) ++at;
  return at;
}

std::string_view line_of(std::string_view text, int line) {
  std::size_t start = 0;
  for (; line > 1; --line) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string_view::npos) return "";
    start = end + 1;
  }
  std::string_view rest = text.substr(start, text.find('\n', start) - start);
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  return rest;
}

/// What a terminal may be sent: control characters become spaces, bytes that are not UTF-8 question marks.
std::string printable(std::string_view text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t size = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
    std::size_t have = 1;
    while (have < size && i + have < text.size() && continues(text[i + have])) ++have;
    if (size == 0 || have < size) {
      clean += '?';
      for (++i; i < text.size() && continues(text[i]);) ++i;
      continue;
    }
    if (size == 1 && (first < ' ' || first == 127))
      clean += ' ';
    else
      clean += text.substr(i, size);
    i += size;
  }
  return clean;
}

/// The source line and the marks below it, cut to a readable width.
struct Excerpt {
  std::string line;
  int before = 0, marked = 0;
};

Excerpt excerpt(std::string_view whole, const Place& place) {
  const int size = characters(whole);
  const int column = std::clamp(place.column - 1, 0, size);
  const int first = size <= widest_line ? 0 : std::max(0, std::min(column - widest_line / 3, size - widest_line));
  const int last = std::min(size, first + widest_line);
  const std::size_t from = byte_of(whole, first), to = byte_of(whole, last);
  Excerpt e;
  e.line = (first > 0 ? "..." : "") + printable(whole.substr(from, to - from)) + (last < size ? "..." : "");
  e.before = column - first + (first > 0 ? 3 : 0);
  e.marked = std::max(1, std::min(place.length, last - column));
  return e;
}

std::string render_one(const Sources& sources, const Problem& p, const Paint& c) {
  const bool in_file = p.place.source == 0;
  const std::string_view text = in_file ? std::string_view(sources.text) : sources.overrides[p.place.source - 1];
  const std::string where = in_file ? fmt::format("{}:{}:{}", sources.path, p.place.line, p.place.column)
                                    : sources.before_override + printable(text);
  std::string out = fmt::format("{}{}:{} {}error[{}]{}: {}{}{}\n", c.strong, where, c.reset, c.error, p.code, c.reset,
                                c.strong, printable(p.message), c.reset);
  if (p.place.length > 0) {
    const Excerpt e = excerpt(in_file ? line_of(text, p.place.line) : text, p.place);
    const std::string number = in_file ? std::to_string(p.place.line) : "";
    out += fmt::format("{}{:>5} |{} {}\n", c.gutter, number, c.reset, e.line);
    out += fmt::format("{}      |{} {:{}}{}{}{}{}{}\n", c.gutter, c.reset, "", e.before, c.mark,
                       std::string(e.marked, '^'), p.note.empty() ? "" : " ", printable(p.note), c.reset);
  }
  const std::string help = p.help.empty() ? fmt::format("scree explain {}", p.code) : printable(p.help);
  out += fmt::format("{}      ={} help: {}\n", c.gutter, c.reset, help);
  return out;
}

}  // namespace

int characters(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string render(const Sources& sources, std::vector<Problem> problems, bool colour) {
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.source, a.place.line, a.place.column) <
           std::tie(b.place.source, b.place.line, b.place.column);
  });
  std::string out;
  const Paint c = paint(colour);
  for (std::size_t i = 0; i < std::min(problems.size(), most_shown); ++i) out += render_one(sources, problems[i], c);
  if (problems.size() > most_shown) out += fmt::format("and {} more errors\n", problems.size() - most_shown);
  if (!out.empty()) out.pop_back();
  return out;
}

}  // namespace scree
