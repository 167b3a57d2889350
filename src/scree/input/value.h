// A parsed case file as a plain tree, every node with its place in the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scree {

/// Where something stands: line and column count from 1, columns and length in characters. Source 0 is the case file,
/// source k the k-th override of the command line.
struct Place {
  int source = 0;
  int line = 1, column = 1;
  int length = 0;  // 0: unknown, nothing to underline
};

struct Value;
struct Entry;
using List = std::vector<Value>;
using Table = std::vector<Entry>;  // in the order of the file
struct Date {};                    // a date or time: TOML has them, no key does

struct Value {
  Place place;
  std::variant<Date, bool, std::int64_t, double, std::string, List, Table> data;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&data);
  }
  template <class T>
  T* as() {
    return std::get_if<T>(&data);
  }
};

struct Entry {
  std::string name;
  Place place;  // of the name
  Value value;
};

/// The entry of that name, or nullptr.
const Entry* find(const Table& table, std::string_view name);
Entry* find(Table& table, std::string_view name);

/// What kind of value it is, in words: "a number", "a list", ...
std::string kind_of(const Value& value);

}  // namespace scree
