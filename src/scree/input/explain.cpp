// `scree explain`.
#include "scree/input/explain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scree/base/error.h"
#include "scree/base/units.h"
#include "scree/input/codes.h"
#include "scree/input/keys.h"
#include "scree/input/suggest.h"
#include "scree/input/toml_text.h"
#include "scree/input/topics.h"

namespace scree {
namespace {

std::string explain_key(const Section& section, const Key& key) {
  std::string out = fmt::format("{}  in {}\n", full_name(section, key), section.heading);
  out += fmt::format("  {}\n", key.meaning);
  out += fmt::format("  value:    {}\n", expected(key));
  if (const std::string range = in_words(key.limits); !range.empty())
    out += fmt::format("  limits:   {}{}\n", range, key.si_unit.empty() ? "" : " " + key.si_unit);
  out += key.is_required ? fmt::format("  {}\n", requirement(key))
                         : fmt::format("  default:  {}\n", default_of(section, key));
  for (const Condition& c : key.conditions) out += fmt::format("  only with {}\n", in_words(c));
  if (section.observes || key.may_change) out += "  may change at a restart\n";
  return out;
}

std::string explain_section(const Section& section) {
  std::string out = fmt::format("{}\n  {}\n\n", section.heading, section.meaning);
  for (const Key& key : section.keys) {
    const std::string note = key.is_required ? requirement(key) : default_of(section, key);
    out += fmt::format("  {:<28} {}{} [{}]\n", key.name, key.meaning, key.si_unit.empty() ? "" : ", in " + key.si_unit,
                       note);
  }
  return out;
}

/// The keys that have the word among their choices; of many their names alone.
std::string explain_choice(const std::string& word) {
  std::vector<std::string> names, texts;
  for_each_section(case_section(), [&](const Section& section) {
    for (const Key& key : section.keys) {
      if (std::ranges::find(key.choices, word) == key.choices.end()) continue;
      names.push_back(full_name(section, key));
      texts.push_back(explain_key(section, key));
    }
  });
  if (names.empty()) return {};
  const std::string head = fmt::format("'{}' is a value of {}\n", word, fmt::join(names, ", "));
  return names.size() > 3 ? head : fmt::format("{}\n{}", head, fmt::join(texts, "\n"));
}

std::string overview() {
  std::string out = "Tables of the case file:\n";
  for_each_section(case_section(), [&](const Section& section) {
    if (!section.path.empty()) out += fmt::format("  {:<22} {}\n", section.path, section.meaning);
  });
  out += "\nscree explain TABLE lists its keys, scree explain TABLE.KEY explains one, scree explain E102 an error.\n";
  out += "Other topics:";
  for (const Topic& topic : topics()) out += fmt::format("  {}", topic.name);
  return out + "\n";
}

/// Everything that can be explained, for suggestions.
std::vector<std::string> known_words() {
  std::vector<std::string> words;
  for_each_section(case_section(), [&](const Section& section) {
    words.push_back(section.path);
    for (const Key& key : section.keys) {
      words.push_back(full_name(section, key));
      words.push_back(key.name);
      words.insert(words.end(), key.choices.begin(), key.choices.end());
    }
  });
  for (const ErrorCode& code : error_codes()) words.emplace_back(code.code);
  for (const Topic& topic : topics()) words.push_back(topic.name);
  return words;
}

}  // namespace

std::string explain(const std::string& key_or_code) {
  if (key_or_code.empty()) return overview();
  std::string out;
  for (const ErrorCode& code : error_codes())
    if (code.code == key_or_code) return fmt::format("{}: {}\n  {}\n", code.code, code.title, code.text);
  for (const Topic& topic : topics())
    if (topic.name == key_or_code) return topic.text;
  for_each_section(case_section(), [&](const Section& section) {
    if (!section.path.empty() && section.path == key_or_code) out += explain_section(section);
  });
  if (!out.empty()) return out;
  for_each_section(case_section(), [&](const Section& section) {
    for (const Key& key : section.keys)
      if (key_or_code == key.name || key_or_code == full_name(section, key))
        out += (out.empty() ? "" : "\n") + explain_key(section, key);
  });
  if (!out.empty()) return out;
  out = explain_choice(key_or_code);
  if (!out.empty()) return out;
  const std::string meant = did_you_mean(key_or_code, known_words());
  throw InputError(fmt::format("nothing is known about '{}'{}", key_or_code,
                               meant.empty() ? "; scree explain lists what is" : "; " + meant));
}

}  // namespace scree
