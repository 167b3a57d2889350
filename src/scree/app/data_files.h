// Files that come with the program: examples, verification cases, benchmark scenes, scripts.
#pragma once

#include <filesystem>
#include <string>

namespace scree {

/// The directory `name` (examples, verify, bench, share) of the installed program, or of the source tree that it was
/// built from. Throws InputError when neither is there.
std::filesystem::path data_directory(const std::string& name);

/// Names and titles of the examples.
std::string list_examples();

/// Copies an example into `directory` (its name if empty) and says how to run it. Throws InputError for an unknown
/// example or a directory that is there already.
std::string copy_example(const std::string& name, const std::string& directory);

}  // namespace scree
