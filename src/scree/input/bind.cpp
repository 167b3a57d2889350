// Binding of tables to structs.
#include "scree/input/bind.h"

#include <fmt/format.h>

#include "scree/base/edit_distance.h"
#include "scree/input/keys.h"
#include "scree/input/read_value.h"

namespace scree {
namespace {

std::string join(const std::string& path, const std::string& name) { return path.empty() ? name : path + "." + name; }

/// Remedy for an unknown key: a key of this table with a similar name, or the table where the name belongs. What is
/// written as a table can only be meant where a table is.
std::string meant(const Section& section, const std::string& name, bool table) {
  std::vector<std::string> here, elsewhere;
  std::string owners;
  for (const Key& key : section.keys) here.push_back(key.name);
  for_each_section(case_section(), [&](const Section& other) {
    if (&other == &section) return;
    for (const Key& key : other.keys) {
      if (key.name == name && (!table || opened_by(key) != nullptr))
        owners += (owners.empty() ? "" : ", ") + (other.path.empty() ? "the top of the file" : other.heading);
    }
  });
  if (!owners.empty()) return fmt::format("'{}' belongs to {}", name, owners);
  const std::string near = nearest(name, here);
  if (!near.empty())
    return fmt::format("did you mean '{}'?   (scree explain {})", near, full_name(section, *find(section, near)));
  const Section* owner = nullptr;
  for_each_section(case_section(), [&](const Section& other) {
    for (const Key& key : other.keys) elsewhere.push_back(key.name);
  });
  const std::string far = nearest(name, elsewhere);
  for_each_section(case_section(), [&](const Section& other) {
    if (owner == nullptr && find(other, far) != nullptr) owner = &other;
  });
  if (owner != nullptr && !owner->path.empty())
    return fmt::format("did you mean '{}' of {}?   (scree explain {}.{})", far, owner->heading, owner->path, far);
  return fmt::format("scree explain {} lists the keys", section.path);
}

struct Binder {
  Origins& origins;
  std::vector<Problem>& problems;

  void unknown(const Section& section, const Entry& entry) {
    const bool top = section.path.empty();
    const std::string what = top ? entry.value.as<Table>() || entry.value.as<List>() ? "table" : "key" : "key";
    const std::string where = top ? "at the top of the file" : "in " + section.heading;
    problems.push_back({"E102", entry.place, fmt::format("unknown {} '{}' {}", what, entry.name, where),
                        top ? "not known" : "not a key of " + section.heading,
                        meant(section, entry.name, what == "table")});
  }

  void missing(const Section& section, const Key& key, const std::string& path) {
    origins.failed.insert(join(path, key.name));
    std::string why;
    for (const Condition& c : key.conditions)
      if (!c.none) why += fmt::format("{} {}", why.empty() ? ", needed with" : " and", in_words(c));
    problems.push_back(
        {"E103", origins.headings.at(path), fmt::format("missing key '{}' in {}{}", key.name, section.heading, why),
         fmt::format("'{}' is missing", key.name),
         fmt::format("add '{}': {}   (scree explain {})", key.name, expected(key), full_name(section, key))});
  }

  /// Reports a key that is not read, or drops its value if the command line switched it off on purpose.
  void without_effect(const Section& section, const Key& key, const std::string& path, void* keys) {
    std::string needs;
    for (const Condition& c : key.conditions) {
      if (origins.overridden(join(path, c.key))) return set_default(section, key, keys);
      needs += (needs.empty() ? "" : " and ") + in_words(c);
    }
    problems.push_back({"E150", origins.names.at(join(path, key.name)),
                        fmt::format("'{}' has no effect here", key.name), "needs " + needs,
                        fmt::format("remove it, or set {}   (scree explain {})", needs, full_name(section, key))});
  }

  bool wrong_kind(const Section& section, const Key& key, const Value& value, const std::string& wanted) {
    problems.push_back({"E104", value.place, fmt::format("'{}' must be {}, not {}", key.name, wanted, kind_of(value)),
                        "expected " + wanted, fmt::format("scree explain {}", full_name(section, key))});
    return false;
  }

  bool nested(const Section& section, const Key& key, const Nested& slot, const Value& value, const std::string& path,
              void* keys) {
    void* inner = slot.at(keys);
    origins.headings[path] = value.place;
    if (const auto* table = value.as<Table>()) {
      bind(*slot.section, *table, path, inner);
      return true;
    }
    if (slot.shorthand.empty()) return wrong_kind(section, key, value, "a table");
    const Key& shorthand = *find(*slot.section, slot.shorthand);
    origins.values[join(path, shorthand.name)] = value.place;
    if (!read_value(*slot.section, shorthand, key.name, value, inner, problems)) return false;
    for (const Key& other : slot.section->keys)
      if (&other != &shorthand && other.is_required && applies(*slot.section, other, inner))
        missing(*slot.section, other, path);
    return true;
  }

  bool nested_list(const Section& section, const Key& key, const NestedList& slot, const Value& value,
                   const std::string& path, void* keys) {
    const auto* list = value.as<List>();
    if (list == nullptr)
      return wrong_kind(section, key, value, fmt::format("a list of tables, each headed by {}", slot.section->heading));
    for (const Value& item : *list) {
      if (item.as<Table>() == nullptr) return wrong_kind(section, key, item, "a table");
      const std::string item_path = join(path, std::to_string(slot.size(keys)));
      origins.headings[item_path] = item.place;
      bind(*slot.section, *item.as<Table>(), item_path, slot.add(keys));
    }
    return true;
  }

  bool given(const Section& section, const Key& key, const Entry& entry, const std::string& path, void* keys) {
    const std::string key_path = join(path, key.name);
    origins.names[key_path] = entry.place;
    origins.values[key_path] = entry.value.place;
    if (const auto* slot = std::get_if<Nested>(&key.slot))
      return nested(section, key, *slot, entry.value, key_path, keys);
    if (const auto* slot = std::get_if<NestedList>(&key.slot))
      return nested_list(section, key, *slot, entry.value, key_path, keys);
    return read_value(section, key, key.name, entry.value, keys, problems);
  }

  void absent(const Section& section, const Key& key, const std::string& path, void* keys) {
    if (is_spared(section, key, keys)) return;
    if (key.is_required) return missing(section, key, path);
    const auto* slot = std::get_if<Nested>(&key.slot);
    if (slot == nullptr) return;
    origins.headings[join(path, key.name)] = origins.headings.at(path);
    bind(*slot->section, {}, join(path, key.name), slot->at(keys));
  }

  void bind(const Section& section, const Table& table, const std::string& path, void* keys) {
    for (const Entry& entry : table) {
      const Key* key = find(section, entry.name);
      if (key == nullptr)
        unknown(section, entry);
      else if (!given(section, *key, entry, path, keys))
        origins.failed.insert(join(path, key->name));
    }
    for (const Key& key : section.keys) {
      bool unsure = false;  // a condition's own key could not be read
      for (const auto* conditions : {&key.conditions, &key.spared})
        for (const Condition& c : *conditions) unsure = unsure || origins.failed.contains(join(path, c.key));
      if (unsure) continue;
      const bool in_file = find(table, key.name) != nullptr;
      const bool in_force = applies(section, key, keys);
      if (in_file && !in_force) without_effect(section, key, path, keys);
      if (!in_file && in_force) absent(section, key, path, keys);
    }
  }
};

}  // namespace

bool Origins::overridden(const std::string& path) const {
  const auto found = values.find(path);
  return found != values.end() && found->second.source > 0;
}

Place Origins::place(const std::string& path) const {
  if (const auto found = values.find(path); found != values.end()) return found->second;
  if (const auto found = headings.find(path); found != headings.end()) return found->second;
  for (std::string outer = path; !outer.empty();) {
    const std::size_t dot = outer.rfind('.');
    outer = dot == std::string::npos ? "" : outer.substr(0, dot);
    if (const auto found = headings.find(outer); found != headings.end()) return found->second;
  }
  return {};
}

void bind_case(const Table& root, Case& c, Origins& origins, std::vector<Problem>& problems) {
  origins.headings[""] = Place{};
  Binder{origins, problems}.bind(case_section(), root, "", &c);
}

}  // namespace scree
