// Records of cases and their comparison, by the tables of keys.
#include "scree/input/record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/base/hash.h"
#include "scree/input/bind.h"
#include "scree/input/keys.h"
#include "scree/input/toml_reader.h"
#include "scree/input/toml_text.h"
#include "scree/input/write.h"

namespace scree {
namespace {

constexpr std::string_view digest_mark = " sha256 ";

/// The file by its contents.
std::string by_contents(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  try {
    return fmt::format("{}{}{}", name, digest_mark, sha256_hex(read_text_file(path)));
  } catch (const InputError&) {
    return name;  // gone since the run began; only the beginning needs it
  }
}

std::string name_of_file(const std::string& text) { return text.substr(0, text.find(digest_mark)); }

/// The same contents; where one of them is unknown, the same name.
bool same_file(const std::string& a, const std::string& b) {
  const auto x = a.find(digest_mark), y = b.find(digest_mark);
  if (x == std::string::npos || y == std::string::npos) return name_of_file(a) == name_of_file(b);
  return a.substr(x) == b.substr(y);
}

/// Calls visit(key, keys) for every key of the case that applies.
template <class Visit>
void for_each_key(const Section& section, void* keys, const Visit& visit) {
  for (const Key& key : section.keys) {
    if (!applies(section, key, keys)) continue;
    if (const auto* nested = std::get_if<Nested>(&key.slot)) {
      for_each_key(*nested->section, nested->at(keys), visit);
    } else if (const auto* list = std::get_if<NestedList>(&key.slot)) {
      for (std::size_t i = 0; i < list->size(keys); ++i) for_each_key(*list->section, list->at(keys, i), visit);
    } else {
      visit(key, keys);
    }
  }
}

Case with_files_by_contents(Case c) {
  for_each_key(case_section(), &c, [](const Key& key, void* keys) {
    const auto* text = std::get_if<Get<std::string>>(&key.slot);
    if (text == nullptr || key.text != TextKind::file) return;
    std::string& path = (*text)(keys);
    if (!path.empty()) path = by_contents(path);
  });
  return c;
}

Case case_of_record(std::string_view record) {
  std::optional<Problem> syntax;
  std::vector<Problem> problems;
  const Table root = read_toml(record, 0, syntax);
  if (syntax) problems.push_back(*syntax);
  Case c;
  Origins origins;
  bind_case(root, c, origins, problems);
  if (!problems.empty())
    throw InputError(
        fmt::format("its case is one of another version of Scree: {}; continue with the version that wrote it",
                    problems.front().message));
  return c;
}

struct Comparison {
  std::vector<Difference>& found;

  void add(const std::string& path, std::string was, std::string is) {
    found.push_back({path, std::move(was), std::move(is)});
  }

  void values(const Section& section, const Key& key, const std::string& path, void* was, void* is) {
    // A key that applies to one of them only hangs on another, which differs and is named.
    if (!applies(section, key, was) || !applies(section, key, is)) return;
    const auto* text = std::get_if<Get<std::string>>(&key.slot);
    if (text != nullptr && key.text == TextKind::file) return files(path, (*text)(was), (*text)(is));
    const std::optional<std::string> before = toml_text(key, was), now = toml_text(key, is);
    if (before != now) add(path, before.value_or("not given"), now.value_or("not given"));
  }

  void files(const std::string& path, const std::string& before, const std::string& now) {
    if (same_file(before, now)) return;
    const std::string was = name_of_file(before), is = name_of_file(now);
    add(path, quoted(was), was == is ? "a file of that name with other contents" : quoted(is));
  }

  /// The names of the tables of a list, or their places where they have none.
  static std::vector<std::string> labels(const NestedList& list, void* keys) {
    const Key* name = find(*list.section, "name");
    const auto* text = name == nullptr ? nullptr : std::get_if<Get<std::string>>(&name->slot);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < list.size(keys); ++i)
      out.push_back(text == nullptr ? std::to_string(i) : (*text)(list.at(keys, i)));
    return out;
  }

  void lists(const NestedList& list, const std::string& path, void* was, void* is) {
    const std::vector<std::string> before = labels(list, was), now = labels(list, is);
    const auto has = [](const std::vector<std::string>& all, const std::string& label) {
      return std::find(all.begin(), all.end(), label) != all.end();
    };
    for (const std::string& label : now)
      if (!has(before, label)) add(path + "." + label, "not there", "there");
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto place = std::find(now.begin(), now.end(), before[i]);
      if (place == now.end())
        add(path + "." + before[i], "there", "not there");
      else
        tables(*list.section, path + "." + before[i], list.at(was, i),
               list.at(is, static_cast<std::size_t>(place - now.begin())));
    }
    const bool same_names = std::is_permutation(before.begin(), before.end(), now.begin(), now.end());
    if (same_names && before != now)
      add(path, fmt::format("in the order {}", fmt::join(before, ", ")), fmt::format("{}", fmt::join(now, ", ")));
  }

  void tables(const Section& section, const std::string& path, void* was, void* is) {
    if (section.observes) return;
    for (const Key& key : section.keys) {
      if (key.may_change || !describes_run(key)) continue;
      const std::string place = path.empty() ? key.name : path + "." + key.name;
      if (const auto* nested = std::get_if<Nested>(&key.slot)) {
        if (applies(section, key, was) && applies(section, key, is))
          tables(*nested->section, place, nested->at(was), nested->at(is));
      } else if (const auto* list = std::get_if<NestedList>(&key.slot)) {
        lists(*list, place, was, is);
      } else {
        values(section, key, place, was, is);
      }
    }
  }
};

}  // namespace

std::string case_record(const Case& c) { return resolved_case(with_files_by_contents(c)); }

std::vector<Difference> differences_from(std::string_view record, const Case& c) {
  // The present case makes the same way through a record, so that both have lost the same.
  Case was = case_of_record(record), is = case_of_record(case_record(c));
  std::vector<Difference> found;
  Comparison{found}.tables(case_section(), "", &was, &is);
  return found;
}

std::string changeable_keys() {
  std::vector<std::string> names;
  for_each_section(case_section(), [&](const Section& section) {
    if (section.observes && !section.path.empty()) names.push_back(section.path + ".*");
    if (section.observes) return;
    for (const Key& key : section.keys)
      if (key.may_change) names.push_back(full_name(section, key));
  });
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace scree
