// What can be asked of a key's description.
#include "scree/input/key.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scree {
namespace {

std::string quoted_list(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += fmt::format("{}'{}'", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
  return text;
}

std::string in_unit(const Key& key) { return key.si_unit.empty() ? "" : " in " + key.si_unit; }

/// The words for each kind of slot.
struct Expected {
  const Key& key;

  std::string operator()(const Get<double>&) const { return "a number" + in_unit(key); }
  std::string operator()(const Get<std::optional<double>>&) const {
    return "a number" + in_unit(key) + (key.word.empty() ? "" : fmt::format(" or '{}'", key.word));
  }
  std::string operator()(const Get<std::uint64_t>&) const { return "a whole number"; }
  std::string operator()(const Get<bool>&) const { return "true or false"; }
  std::string operator()(const Get<std::string>&) const {
    if (!key.choices.empty()) return quoted_list(key.choices);
    switch (key.text) {
      case TextKind::name:
        return "a name";
      case TextKind::file:
        return "a file name";
      case TextKind::formula:
        return "a formula or a number";
      default:
        return "a text";
    }
  }
  std::string operator()(const Get<int>&) const { return quoted_list(key.choices); }
  std::string operator()(const Get<Vec3>&) const { return "three numbers" + in_unit(key); }
  std::string operator()(const Get<std::array<bool, 3>>&) const { return "three times true or false"; }
  std::string operator()(const Get<Expression3>&) const { return "three formulas of x, y, z and t" + in_unit(key); }
  std::string operator()(const Get<std::vector<double>>&) const { return "a list of numbers" + in_unit(key); }
  std::string operator()(const Get<std::vector<std::string>>&) const {
    return key.choices.empty() ? "a list of texts" : "a list of " + quoted_list(key.choices);
  }
  std::string operator()(const Get<std::vector<std::uint64_t>>&) const { return "a list of whole numbers"; }
  std::string operator()(const Get<std::vector<Vec3>>&) const {
    return "a list of points, each three numbers" + in_unit(key);
  }
  std::string operator()(const Get<std::array<std::string, 2>>&) const { return "two names"; }
  std::string operator()(const Nested& nested) const {
    if (nested.shorthand.empty()) return "a table";
    return scree::expected(*find(*nested.section, nested.shorthand)) + ", or a table";
  }
  std::string operator()(const NestedList&) const { return "a list of tables"; }
};

bool holds(const Section& section, const Condition& c, void* keys) {
  const std::string word = current_word(*find(section, c.key), keys);
  return (std::find(c.values.begin(), c.values.end(), word) != c.values.end()) != c.none;
}

}  // namespace

const Key* find(const Section& section, std::string_view name) {
  for (const Key& key : section.keys)
    if (key.name == name) return &key;
  return nullptr;
}

const Section* opened_by(const Key& key) {
  if (const auto* nested = std::get_if<Nested>(&key.slot)) return nested->section;
  if (const auto* list = std::get_if<NestedList>(&key.slot)) return list->section;
  return nullptr;
}

void for_each_section(const Section& section, const std::function<void(const Section&)>& visit) {
  visit(section);
  for (const Key& key : section.keys)
    if (const Section* inner = opened_by(key)) for_each_section(*inner, visit);
}

std::string current_word(const Key& key, void* keys) {
  if (const auto* text = std::get_if<Get<std::string>>(&key.slot)) return (*text)(keys);
  if (const auto* yes = std::get_if<Get<bool>>(&key.slot)) return (*yes)(keys) ? "true" : "false";
  if (const auto* number = std::get_if<Get<int>>(&key.slot)) return key.choices.at((*number)(keys));
  return "";
}

bool applies(const Section& section, const Key& key, void* keys) {
  return std::all_of(key.conditions.begin(), key.conditions.end(),
                     [&](const Condition& c) { return holds(section, c, keys); });
}

std::string requirement(const Key& key) {
  std::string out = "required";
  for (const Condition& c : key.spared) out += " unless " + in_words(c);
  return out;
}

bool is_spared(const Section& section, const Key& key, void* keys) {
  return std::any_of(key.spared.begin(), key.spared.end(), [&](const Condition& c) { return holds(section, c, keys); });
}

void set_default(const Section& section, const Key& key, void* keys) {
  const std::shared_ptr<void> fresh = section.make();
  std::visit(
      [&](const auto& slot) {
        using SlotType = std::decay_t<decltype(slot)>;
        if constexpr (!std::is_same_v<SlotType, Nested> && !std::is_same_v<SlotType, NestedList>)
          slot(keys) = slot(fresh.get());
      },
      key.slot);
}

std::string in_words(const Condition& condition) {
  if (condition.values == std::vector<std::string>{"true"}) return condition.key + " = true";
  return fmt::format("{} {} {}", condition.key, condition.none ? "other than" : "=", quoted_list(condition.values));
}

std::string expected(const Key& key) { return std::visit(Expected{key}, key.slot); }

std::string in_words(const Limits& limits) {
  const bool low = limits.low > -std::numeric_limits<double>::infinity();
  const bool high = limits.high < std::numeric_limits<double>::infinity();
  const std::string above = fmt::format("{} {}", limits.low_open ? "above" : "at least", limits.low);
  const std::string below = fmt::format("{} {}", limits.high_open ? "below" : "at most", limits.high);
  if (low && high && !limits.low_open && !limits.high_open)
    return fmt::format("from {} to {}", limits.low, limits.high);
  if (low && high) return above + " and " + below;
  return low ? above : high ? below : "";
}

std::string full_name(const Section& section, const Key& key) {
  return section.path.empty() ? key.name : section.path + "." + key.name;
}

}  // namespace scree
