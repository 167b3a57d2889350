// The case that a checkpoint remembers, and what may differ from it when a run goes on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// The resolved case, with the files that it names by their contents: "beads.csv sha256 0f1e...". Folders do not
/// matter; of a file that cannot be read only the name is there.
std::string case_record(const Case& c);

/// A key in which a case differs from a record. Texts are TOML, or words where there is no value.
struct Difference {
  std::string key, was, is;
};

/// The keys in which `c` differs from a record of case_record(), without those that a restart may change. Keys that
/// only one of two versions of the program knows count with their defaults.
/// Throws InputError when the record cannot be read by this version.
std::vector<Difference> differences_from(std::string_view record, const Case& c);

/// The keys that a restart may change: "simulation.end, ..., output.*".
std::string changeable_keys();

}  // namespace scree
