// The particles of the benchmark scenes, made by running a case once.
#pragma once

#include <string>

namespace scree {

/// Path of the table of particles (CSV) of a scene in `directory`; makes it by running bench/make_SCENE.toml if it is
/// not there yet, which takes a minute or two.
std::string make_packing(const std::string& scene, const std::string& directory);

}  // namespace scree
