// Conversion of toml++'s tree, whose tables are sorted by name, into ours in file order.
#include "scree/input/toml_reader.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

namespace scree {
namespace {

constexpr int deepest = 20;

struct Converter {
  int source;
  std::optional<Problem>* problem;

  Place place(const toml::source_region& region) const {
    Place p{source, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
    if (region.end.line == region.begin.line)
      p.length = std::max(1, static_cast<int>(region.end.column) - p.column);
    else
      p.length = 1000;  // to the end of the line
    return p;
  }

  Table table(const toml::table& from, int depth) const {
    Table to;
    for (const auto& [key, node] : from)
      to.push_back({std::string(key.str()), place(key.source()), value(node, depth + 1)});
    std::stable_sort(to.begin(), to.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    return to;
  }

  Value value(const toml::node& node, int depth) const {
    Value v;
    v.place = place(node.source());
    if (depth > deepest) {
      *problem = Problem{"E101", v.place, fmt::format("nested deeper than {} levels", deepest), "", ""};
      return v;
    }
    if (const auto* t = node.as_table()) v.data = table(*t, depth);
    if (const auto* list = node.as_array()) {
      List items;
      for (const toml::node& item : *list) items.push_back(value(item, depth + 1));
      v.data = std::move(items);
    }
    if (const auto* b = node.as_boolean()) v.data = b->get();
    if (const auto* i = node.as_integer()) v.data = i->get();
    if (const auto* d = node.as_floating_point()) v.data = d->get();
    if (const auto* s = node.as_string()) v.data = s->get();
    return v;
  }
};

/// The library's description without its preamble.
std::string cleaned(std::string_view description) {
  constexpr std::string_view preamble = "Error while parsing ";
  std::string text(description.starts_with(preamble) ? description.substr(preamble.size()) : description);
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

std::string syntax_help(std::string_view description) {
  if (description.find("expected a comment or whitespace") != std::string_view::npos)
    return "texts and numbers with a unit stand in quotes, as in \"1.2 mm\"";
  if (description.find("parsing string") != std::string_view::npos)
    return "a text ends with the quote it began with, on the same line";
  if (description.find("redefine") != std::string_view::npos) return "a key or table may be written once only";
  if (description.find("leading zeroes") != std::string_view::npos) return "write the number without leading zeros";
  return "the file is TOML: key = value, texts in quotes, lists in [ ], tables by [name]";
}

}  // namespace

Table read_toml(std::string_view text, int source, std::optional<Problem>& problem) {
  const Converter convert{source, &problem};
  try {
    const toml::table parsed = toml::parse(text);
    Table table = convert.table(parsed, 0);
    return problem ? Table{} : table;
  } catch (const toml::parse_error& error) {
    problem = Problem{"E101", convert.place(error.source()), "syntax: " + cleaned(error.description()), "here",
                      syntax_help(error.description())};
    return {};
  }
}

}  // namespace scree
