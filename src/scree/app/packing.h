// The particles of the benchmark scenes, made by running a case once.
#pragma once

#include <string>
#include <vector>

namespace scree {

/// Path of the table of particles (CSV) of a scene in `directory`; makes it by running bench/make_SCENE.toml with
/// `changes` (as of load_case()) if it is not there yet, which takes some minutes.
std::string make_packing(const std::string& scene, const std::string& directory,
                         const std::vector<std::string>& changes);

}  // namespace scree
