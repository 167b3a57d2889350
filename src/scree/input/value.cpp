// Small helpers on the value tree.
#include "scree/input/value.h"

namespace scree {

const Entry* find(const Table& table, std::string_view name) {
  for (const Entry& entry : table)
    if (entry.name == name) return &entry;
  return nullptr;
}

Entry* find(Table& table, std::string_view name) {
  for (Entry& entry : table)
    if (entry.name == name) return &entry;
  return nullptr;
}

std::string kind_of(const Value& value) {
  constexpr const char* names[] = {"a date", "true or false", "a whole number", "a number",
                                   "a text", "a list",        "a table"};
  return names[value.data.index()];
}

}  // namespace scree
