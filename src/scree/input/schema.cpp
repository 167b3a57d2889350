// The JSON Schema of case files, for editors and other programs.
#include <cmath>
#include <nlohmann/json.hpp>

#include "scree/input/explain.h"
#include "scree/input/keys.h"
#include "scree/input/toml_text.h"

namespace scree {
namespace {

using Json = nlohmann::ordered_json;

Json describe_table(const Section& section);

void add_limits(Json& schema, const Limits& limits) {
  if (std::isfinite(limits.low)) schema[limits.low_open ? "exclusiveMinimum" : "minimum"] = limits.low;
  if (std::isfinite(limits.high)) schema[limits.high_open ? "exclusiveMaximum" : "maximum"] = limits.high;
}

/// A number in SI units, or a text with a unit.
Json number(const Key& key) {
  Json plain = {{"type", "number"}};
  add_limits(plain, key.limits);
  const Json text = {{"type", "string"}, {"pattern", "^[ \t]*[+-]?[0-9.]"}};
  return {{"anyOf", Json::array({plain, text})}};
}

Json whole(const Key& key) {
  Json schema = {{"type", "integer"}, {"minimum", 0}};
  add_limits(schema, key.limits);
  return schema;
}

Json text(const Key& key) {
  if (!key.choices.empty()) return {{"enum", key.choices}};
  if (key.text == TextKind::formula) return {{"type", Json::array({"string", "number"})}};
  if (key.text == TextKind::name) return {{"type", "string"}, {"pattern", "^[A-Za-z][A-Za-z0-9_-]*$"}};
  return {{"type", "string"}};
}

Json list(const Json& items, std::size_t size) {
  return {{"type", "array"}, {"items", items}, {"minItems", size}, {"maxItems", size}};
}

Json list(const Json& items) { return {{"type", "array"}, {"items", items}}; }

struct Describe {
  const Key& key;

  Json operator()(const Get<double>&) const { return number(key); }
  Json operator()(const Get<std::optional<double>>&) const {
    Json schema = number(key);
    if (!key.word.empty()) schema["anyOf"].push_back({{"const", key.word}});
    return schema;
  }
  Json operator()(const Get<std::uint64_t>&) const { return whole(key); }
  Json operator()(const Get<bool>&) const { return {{"type", "boolean"}}; }
  Json operator()(const Get<std::string>&) const { return text(key); }
  Json operator()(const Get<int>&) const { return {{"enum", key.choices}}; }
  Json operator()(const Get<Vec3>&) const { return list(number(key), 3); }
  Json operator()(const Get<std::array<bool, 3>>&) const { return list({{"type", "boolean"}}, 3); }
  Json operator()(const Get<Expression3>&) const { return list({{"type", Json::array({"string", "number"})}}, 3); }
  Json operator()(const Get<std::vector<double>>&) const { return list(number(key)); }
  Json operator()(const Get<std::vector<std::string>>&) const { return list(text(key)); }
  Json operator()(const Get<std::vector<std::uint64_t>>&) const { return list(whole(key)); }
  Json operator()(const Get<std::vector<Vec3>>&) const { return list(list(number(key), 3)); }
  Json operator()(const Get<std::array<std::string, 2>>&) const { return list({{"type", "string"}}, 2); }
  Json operator()(const Nested& nested) const {
    Json inner = describe_table(*nested.section);
    if (nested.shorthand.empty()) return inner;
    const Key& plain = *find(*nested.section, nested.shorthand);
    return {{"anyOf", Json::array({std::visit(Describe{plain}, plain.slot), inner})}};
  }
  Json operator()(const NestedList& nested) const { return list(describe_table(*nested.section)); }
};

Json describe_key(const Section& section, const Key& key) {
  Json schema = std::visit(Describe{key}, key.slot);
  std::string words = key.meaning;
  if (!key.si_unit.empty()) words += " [" + key.si_unit + "]";
  for (const Condition& c : key.conditions) words += "; only with " + in_words(c);
  if (opened_by(key) == nullptr && !key.is_required) words += "; default: " + default_of(section, key);
  schema["description"] = words;
  return schema;
}

/// The key is there, or the key of a condition excuses it: by one of its words where the required key must have none of
/// them, by none of them where it may be left out then.
Json required_unless(const Key& key) {
  Json ways = Json::array({{{"required", Json::array({key.name})}}});
  const auto excuse = [&](const Condition& c, const Json& word) {
    ways.push_back({{"properties", {{c.key, word}}}, {"required", Json::array({c.key})}});
  };
  for (const Condition& c : key.conditions) excuse(c, {{"enum", c.values}});
  for (const Condition& c : key.spared) excuse(c, {{"not", {{"enum", c.values}}}});
  return {{"anyOf", ways}};
}

Json describe_table(const Section& section) {
  Json schema = {{"type", "object"}, {"description", section.meaning}, {"additionalProperties", false}};
  Json required = Json::array();
  for (const Key& key : section.keys) {
    schema["properties"][key.name] = describe_key(section, key);
    if (key.is_required && key.conditions.empty() && key.spared.empty()) required.push_back(key.name);
    if (key.is_required && key.conditions.size() == 1 && key.conditions[0].none)
      schema["allOf"].push_back(required_unless(key));
  }
  if (!required.empty()) schema["required"] = required;
  return schema;
}

}  // namespace

std::string json_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Scree case file"}};
  schema.update(describe_table(case_section()));
  schema["required"] = {"simulation", "domain"};
  schema["anyOf"] = Json::array({{{"required", {"materials", "particles"}}}, {{"required", {"fluid"}}}});
  return schema.dump(1) + "\n";
}

}  // namespace scree
