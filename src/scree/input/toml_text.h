// Values of a case as TOML text.
#pragma once

#include <optional>
#include <string>

#include "scree/input/key.h"

namespace scree {

/// The key's current value as TOML; numbers in SI units, the shortest text that reads back to the same bits. Empty when
/// an optional value is not given and has no word for it. Not for tables.
std::optional<std::string> toml_text(const Key& key, void* keys);

/// A text in quotes, escaped.
std::string quoted(const std::string& text);

/// The default of a key as TOML text or in words; empty when the key is required.
std::string default_of(const Section& section, const Key& key);

}  // namespace scree
