// Writing of the resolved case from the tables of keys.
#include "scree/input/write.h"

#include <fmt/format.h>

#include "scree/base/version.h"
#include "scree/input/keys.h"
#include "scree/input/toml_text.h"

namespace scree {
namespace {

/// Whether the value only says that nothing is given; written out it could not be read again.
bool is_place_holder(const Key& key, const std::string& text, void* keys) {
  const auto* number = std::get_if<Get<double>>(&key.slot);
  return text == "\"\"" || text == "[]" || (number != nullptr && !key.limits.contains((*number)(keys)));
}

/// Plain keys first, then the tables, as TOML demands.
void write_keys(std::string& out, const Section& section, void* keys) {
  for (const Key& key : section.keys) {
    if (opened_by(key) != nullptr || !applies(section, key, keys)) continue;
    const std::optional<std::string> value = toml_text(key, keys);
    const bool absent = !value || (!key.default_text.empty() && is_place_holder(key, *value, keys));
    if (absent)
      out += fmt::format("# {}: {}\n", key.name, key.default_text);
    else
      out += fmt::format("{} = {}{}\n", key.name, *value, key.si_unit.empty() ? "" : "  # " + key.si_unit);
  }
  for (const Key& key : section.keys) {
    if (!applies(section, key, keys) || !describes_run(key)) continue;
    if (const auto* nested = std::get_if<Nested>(&key.slot)) {
      out += fmt::format("\n[{}]\n", nested->section->path);
      write_keys(out, *nested->section, nested->at(keys));
    }
    if (const auto* list = std::get_if<NestedList>(&key.slot))
      for (std::size_t i = 0; i < list->size(keys); ++i) {
        out += fmt::format("\n[[{}]]\n", list->section->path);
        write_keys(out, *list->section, list->at(keys, i));
      }
  }
}

}  // namespace

bool describes_run(const Key& key) {
  const Section* opened = opened_by(key);
  return opened != &verify_section() && opened != &expect_section();
}

std::string resolved_case(const Case& c) {
  Case copy = c;  // the tables of keys read and write through the same access
  std::string out = fmt::format("# Written by Scree {}: every key that applies, in SI units.\n", version);
  write_keys(out, case_section(), &copy);
  return out;
}

}  // namespace scree
