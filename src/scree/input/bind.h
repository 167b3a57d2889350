// The value tree put into the structs of a case, by the tables of keys.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scree/input/key.h"
#include "scree/input/problem.h"

namespace scree {

/// Where each given key stands, by its path ("particles.0.diameter.mean"), and where each table is opened.
struct Origins {
  std::map<std::string, Place> values, names, headings;
  std::set<std::string> failed;  // keys that could not be read or are missing

  bool given(const std::string& path) const { return values.contains(path); }
  /// Whether the key was set on the command line.
  bool overridden(const std::string& path) const;
  /// Place of the key's value; if it is not given, of the nearest table around it.
  Place place(const std::string& path) const;
};

/// Stores every key of `root`, a whole case file, in `c`. Problems: what read_value finds, unknown keys (E102), missing
/// keys (E103), keys without effect (E150).
void bind_case(const Table& root, Case& c, Origins& origins, std::vector<Problem>& problems);

}  // namespace scree
