// docs/reference.md from the tables of keys.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scree/input/codes.h"
#include "scree/input/explain.h"
#include "scree/input/keys.h"
#include "scree/input/record.h"
#include "scree/input/toml_text.h"
#include "scree/input/topics.h"

namespace scree {
namespace {

/// A bar would end the cell of a table.
std::string escaped(std::string_view text) {
  std::string out;
  for (char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

std::string value_cell(const Key& key) {
  std::string cell = expected(key);
  if (const std::string range = in_words(key.limits); !range.empty()) cell += ", " + range;
  return escaped(cell);
}

std::string default_cell(const Section& section, const Key& key) {
  if (key.is_required) return escaped("**" + requirement(key) + "**");
  const std::string text = default_of(section, key);
  return key.default_text.empty() && opened_by(key) == nullptr ? fmt::format("`{}`", text) : text;
}

std::string meaning_cell(const Key& key) {
  std::string cell = key.meaning;
  if (cell.ends_with('.')) cell.pop_back();  // of a table
  for (const Condition& c : key.conditions) cell += fmt::format(". Only with `{}`", in_words(c));
  return escaped(cell);
}

std::string section_text(const Section& section) {
  std::string out = fmt::format("\n## `{}`\n\n{}\n\n", section.path, section.meaning);
  out += "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const Key& key : section.keys)
    out += fmt::format("| `{}` | {} | {} | {} |\n", key.name, value_cell(key), default_cell(section, key),
                       meaning_cell(key));
  return out;
}

}  // namespace

std::string reference_markdown() {
  std::string out =
      "# Reference of the case file\n\n"
      "Written by `scree explain --markdown` from the table that also drives the parser; do not edit it by hand.\n\n"
      "A case is a TOML file. Keys that are not known, or that another key of their table puts out of effect, are "
      "errors; what only soft or only hard collisions read may stand beside the other. Tables in double brackets may "
      "be "
      "repeated.\nA restart may change " +
      changeable_keys() + ".\n\n| table | meaning |\n|---|---|\n";
  for (const Key& key : case_section().keys)
    out += fmt::format("| `{}` | {} |\n", opened_by(key)->heading, key.meaning);
  for_each_section(case_section(), [&](const Section& section) {
    if (!section.path.empty()) out += section_text(section);
  });
  for (const Topic& topic : topics()) out += fmt::format("\n## On {}\n\n```text\n{}```\n", topic.name, topic.text);
  out += "\n## Errors\n\n| code | meaning | explanation |\n|---|---|---|\n";
  for (const ErrorCode& code : error_codes())
    out += fmt::format("| {} | {} | {} |\n", code.code, code.title, escaped(code.text));
  return out;
}

}  // namespace scree
