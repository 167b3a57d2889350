// Walking of a dotted path through the value tree.
#include "scree/input/overrides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "scree/input/keys.h"
#include "scree/input/suggest.h"
#include "scree/input/toml_reader.h"

namespace scree {
namespace {

struct Step {
  std::string name;
  Place place;
};

struct Walker {
  int source;
  std::vector<Problem>& problems;

  void fail(const Place& place, std::string message, std::string note, std::string help) {
    problems.push_back({"E180", place, std::move(message), std::move(note), std::move(help)});
  }

  std::vector<Step> steps(const std::string& path) {
    std::vector<Step> all;
    int column = 1;
    for (std::size_t at = 0; at <= path.size();) {
      const std::size_t end = std::min(path.find('.', at), path.size());
      const std::string name = path.substr(at, end - at);
      all.push_back({name, {source, 1, column, std::max(1, characters(name))}});
      column += characters(name) + 1;
      at = end + 1;
    }
    return all;
  }

  /// The value after "=": TOML, or else a text. Spaces in front keep its columns those of the override.
  std::optional<Value> value(const std::string& text, std::size_t equals) {
    const int column = characters(std::string_view(text).substr(0, equals)) + 1;
    const std::string words = text.substr(equals + 1);
    const std::size_t first = words.find_first_not_of(" \t");
    const std::size_t last = words.find_last_not_of(" \t");
    const std::string trimmed = first == std::string::npos ? "" : words.substr(first, last - first + 1);
    std::optional<Problem> problem;
    Table parsed = read_toml(std::string(column - 1, ' ').replace(0, 1, "v") + "=" + words, source, problem);
    if (!problem && parsed.size() == 1 && parsed[0].name == "v" && parsed[0].value.place.line == 1)
      return std::move(parsed[0].value);
    const Place place{source, 1, column + 1 + static_cast<int>(first == std::string::npos ? 0 : first),
                      std::max(1, characters(trimmed))};
    const bool meant_toml = !trimmed.empty() && std::string_view("[{\"'").find(trimmed[0]) != std::string_view::npos;
    if (trimmed.empty() || meant_toml || text.find('\n') != std::string::npos) {
      fail(place, trimmed.empty() ? "a value is missing" : "the value is not TOML", problem ? problem->message : "",
           "write key.path=value, as in simulation.end=0.5 or gravity.acceleration=[0, 0, -9.81]");
      return std::nullopt;
    }
    return Value{place, trimmed};
  }

  Value* item(List& list, const Step& step, const std::string& owner) {
    std::size_t index = 0;
    const char* end = step.name.data() + step.name.size();
    if (const auto parsed = std::from_chars(step.name.data(), end, index);
        parsed.ec == std::errc() && parsed.ptr == end) {
      if (index < list.size()) return &list[index];
      fail(step.place, fmt::format("'{}' has no element {}", owner, index),
           fmt::format("it has {}, counted from 0", list.size()), "");
      return nullptr;
    }
    std::vector<std::string> names;
    for (Value& value : list) {
      const Table* table = value.as<Table>();
      const Entry* name = table == nullptr ? nullptr : find(*table, "name");
      if (name == nullptr || name->value.as<std::string>() == nullptr) continue;
      names.push_back(*name->value.as<std::string>());
      if (names.back() == step.name) return &value;
    }
    const std::string meant = did_you_mean(step.name, names);
    fail(step.place, fmt::format("'{}' has no element named '{}'", owner, step.name), "no such name",
         !meant.empty()  ? meant
         : names.empty() ? "count from 0"
                         : fmt::format("names: {}", fmt::join(names, ", ")));
    return nullptr;
  }

  /// The entry of that name; added if it is not there.
  Value* entry(Value& from, const Step& step, const Step& owner) {
    if (from.as<Table>() == nullptr) {
      fail(step.place, fmt::format("'{}' is {}, which has no keys", owner.name, kind_of(from)), "leads nowhere", "");
      return nullptr;
    }
    Table& table = *from.as<Table>();
    if (Entry* known = find(table, step.name)) return &known->value;
    table.push_back({step.name, step.place, Value{step.place, Table{}}});
    return &table.back().value;
  }

  /// Opens a plain value into the table that it is a shorthand of.
  static void open_shorthand(Value& value, const Key* key) {
    const Nested* nested = key == nullptr ? nullptr : std::get_if<Nested>(&key->slot);
    if (nested == nullptr || nested->shorthand.empty() || value.as<Table>() != nullptr) return;
    Value inner = std::move(value);
    value = Value{inner.place, Table{}};
    value.as<Table>()->push_back({nested->shorthand, inner.place, std::move(inner)});
  }

  /// The value that the path leads to, added where it is not there; nullptr if it leads nowhere.
  Value* follow(Value& top, const std::string& path) {
    Value* at = &top;
    const Section* section = &case_section();
    const Key* key = nullptr;  // the key whose value `at` is
    Step owner;
    for (const Step& step : steps(path)) {
      open_shorthand(*at, key);
      if (List* list = at->as<List>()) {
        at = item(*list, step, owner.name);
      } else {
        at = entry(*at, step, owner);
        key = section == nullptr ? nullptr : find(*section, step.name);
        section = key == nullptr ? nullptr : opened_by(*key);
      }
      if (at == nullptr) return nullptr;
      owner = step;
    }
    return at;
  }
};

}  // namespace

void apply_override(Table& root, const std::string& text, int source, std::vector<Problem>& problems) {
  Walker walk{source, problems};
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    walk.fail({source, 1, 1, std::max(1, characters(text))}, "an override is written key.path=value",
              "no '=' after a key", "as in simulation.end=0.5");
    return;
  }
  std::string path = text.substr(0, equals);
  path.erase(path.find_last_not_of(' ') + 1);
  std::optional<Value> value = walk.value(text, equals);
  if (!value) return;
  Value top{{}, std::move(root)};
  if (Value* target = walk.follow(top, path)) *target = std::move(*value);
  root = std::move(*top.as<Table>());
}

}  // namespace scree
