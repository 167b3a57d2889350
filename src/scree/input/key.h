// The description of a key of the case file. Each key is declared in one line of a keys_*.cpp; parser, validator, the
// resolved case, `scree explain`, the JSON Schema and docs/reference.md all read these lines.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scree/input/case.h"

namespace scree {

struct Section;

/// Finds the value of a key in the struct of its table.
template <class V>
using Get = std::function<V&(void*)>;

/// A key that is a table of its own. With a shorthand, a plain value stands for the table with that one key.
struct Nested {
  std::function<void*(void*)> at;
  const Section* section = nullptr;
  std::string shorthand;
};

/// A key that is a list of tables.
struct NestedList {
  std::function<std::size_t(void*)> size;
  std::function<void*(void*, std::size_t)> at;
  std::function<void*(void*)> add;
  const Section* section = nullptr;
};

/// Where a key's value lives. An `int` is a choice by number; a `string` may be a choice by name.
using Slot = std::variant<Get<double>, Get<std::optional<double>>, Get<std::uint64_t>, Get<bool>, Get<std::string>,
                          Get<int>, Get<Vec3>, Get<std::array<bool, 3>>, Get<Expression3>, Get<std::vector<double>>,
                          Get<std::vector<std::string>>, Get<std::vector<std::uint64_t>>, Get<std::vector<Vec3>>,
                          Get<std::array<std::string, 2>>, Nested, NestedList>;

/// An interval for numbers.
struct Limits {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool contains(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};

/// A key applies only while another key of its table has one of some values, or has none of them.
struct Condition {
  std::string key;
  std::vector<std::string> values;
  bool none = false;
};

/// What a text is, beyond a text.
enum class TextKind { any, name, file, formula };

struct Key {
  std::string name, meaning;
  Slot slot;
  std::string si_unit;  // "" for numbers without dimension
  Limits limits;
  std::vector<std::string> choices;
  TextKind text = TextKind::any;
  bool is_required = false;           // whenever it applies
  std::string word;                   // of an optional number: the word for "not given"
  std::string default_text;           // what an absent value means, where it is no constant
  std::vector<Condition> conditions;  // all must hold
  std::vector<Condition> spared;      // may be left out, required or not, while one of these holds
  bool may_change = false;            // at a restart

  Key& unit(std::string u) { return si_unit = std::move(u), *this; }
  Key& above(double x) { return limits.low = x, limits.low_open = true, *this; }
  Key& at_least(double x) { return limits.low = x, *this; }
  Key& below(double x) { return limits.high = x, limits.high_open = true, *this; }
  Key& at_most(double x) { return limits.high = x, *this; }
  Key& between(double low, double high) { return at_least(low).at_most(high); }
  Key& one_of(std::vector<std::string> words) { return choices = std::move(words), *this; }
  Key& is_a(TextKind kind) { return text = kind, *this; }
  Key& required() { return is_required = true, *this; }
  Key& or_word(std::string w) { return word = std::move(w), *this; }
  Key& defaults_to(std::string words) { return default_text = std::move(words), *this; }
  Key& only_with(std::string key, std::vector<std::string> values) {
    return conditions.push_back({std::move(key), std::move(values)}), *this;
  }
  Key& not_with(std::string key, std::vector<std::string> values) {
    return conditions.push_back({std::move(key), std::move(values), true}), *this;
  }
  Key& spared_unless(std::string key, std::vector<std::string> values) {
    return spared.push_back({std::move(key), std::move(values), true}), *this;
  }
  Key& may_change_at_restart() { return may_change = true, *this; }
};

/// A table of the case file.
struct Section {
  std::string path;     // "particles.diameter"; empty for the whole file
  std::string heading;  // as messages call it: "[domain]", "[[materials]]", "the diameter"
  std::string meaning;
  std::vector<Key> keys;
  std::function<std::shared_ptr<void>()> make;  // a fresh struct of this table, to read defaults from
  bool observes = false;                        // its keys change nothing of the motion: all may change at a restart
};

/// A key of struct S held in one of its members.
template <class S, class V>
Key key(const char* name, V S::*member, const char* meaning) {
  return {name, meaning, Get<V>([member](void* s) -> V& { return static_cast<S*>(s)->*member; }),
          "",   {},      {},
          {},   {},      {},
          {},   {},      {}};
}

/// A choice of a law by number, in the order of the enumeration.
inline Key law(const char* name, int sc_laws::*member, const char* meaning) {
  return {name, meaning, Get<int>([member](void* s) -> int& { return static_cast<ContactKeys*>(s)->laws.*member; }),
          "",   {},      {},
          {},   {},      {},
          {},   {},      {}};
}

/// A table within a table.
template <class S, class T>
Key table(const char* name, T S::*member, const Section& section, const char* shorthand = "") {
  return {name,
          section.meaning,
          Nested{[member](void* s) -> void* { return &(static_cast<S*>(s)->*member); }, &section, shorthand},
          "",
          {},
          {},
          {},
          {},
          {},
          {},
          {},
          {}};
}

/// A list of tables; `list` finds the vector in the struct of the table that holds the key.
template <class S, class T>
Key tables(const char* name, std::vector<T>& (*list)(S&), const Section& section) {
  const auto of = [list](void* s) -> std::vector<T>& { return list(*static_cast<S*>(s)); };
  NestedList nested;
  nested.size = [of](void* s) { return of(s).size(); };
  nested.at = [of](void* s, std::size_t i) -> void* { return &of(s)[i]; };
  nested.add = [of](void* s) -> void* { return &of(s).emplace_back(); };
  nested.section = &section;
  return {name, section.meaning, nested, "", {}, {}, {}, {}, {}, {}, {}, {}};
}

/// The key of that name, or nullptr.
const Key* find(const Section& section, std::string_view name);

/// The table within, or the tables within, that the key opens; nullptr if it opens none.
const Section* opened_by(const Key& key);

/// Calls `visit` for this table and every table in it, in order.
void for_each_section(const Section& section, const std::function<void(const Section&)>& visit);

/// The current word of a choice (by name, by number, or "true"/"false"); empty for other keys.
std::string current_word(const Key& key, void* keys);

/// Whether the key's conditions hold for the struct.
bool applies(const Section& section, const Key& key, void* keys);

/// "required", and unless what.
std::string requirement(const Key& key);

/// Whether the key may be left out for what the struct holds, though it is required.
bool is_spared(const Section& section, const Key& key, void* keys);

/// Gives the key its default again.
void set_default(const Section& section, const Key& key, void* keys);

/// "gravity.type = 'uniform' or 'rotating'", the words of a condition.
std::string in_words(const Condition& condition);

/// What the value must be: "a number in m", "one of 'linear', 'hertz'", "three formulas of x, y, z and t", ...
std::string expected(const Key& key);

/// The limits in words: "above 0", "from 0 to 1"; empty if there are none.
std::string in_words(const Limits& limits);

/// "section.key".
std::string full_name(const Section& section, const Key& key);

}  // namespace scree
