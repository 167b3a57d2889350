// What the program can tell about its input, derived from the tables of keys.
#pragma once

#include <string>

namespace scree {

/// Plain text about a key ("contact.normal", "friction"), a table ("materials"), an error code ("E102"), or the topics
/// "units", "formulas" and "overrides"; empty: an overview. Throws InputError with a suggestion for anything else.
std::string explain(const std::string& key_or_code);

/// JSON Schema (draft-07) of case files.
std::string json_schema();

/// docs/reference.md: every table and key.
std::string reference_markdown();

}  // namespace scree
