// The particles of the benchmark scenes, made by running a case once.
#pragma once

#include <string>
#include <vector>

#include "scree/app/bench_list.h"

namespace scree {

/// Makes the tables of particles (CSV) of a scene in `directory`, one for each group, by running its case once, if they
/// are not there yet, which takes up to some minutes. Returns what must be changed in the scene's case so that it reads
/// them.
std::vector<std::string> make_packing(const BenchScene& scene, const std::string& directory);

}  // namespace scree
