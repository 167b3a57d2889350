// Pictures of runs and measurements: Python scripts that come with the program draw them with matplotlib.
#pragma once

#include <string>

namespace scree {

/// Writes DIRECTORY/series.png and DIRECTORY/particles.png from the tables and the last frame of a run.
/// The scripts run under /usr/bin/python3, or the interpreter that the environment names in SCREE_PYTHON. Throws
/// InputError when the directory is none, ResourceError when the interpreter or a package is missing or drawing fails.
void plot_run(const std::string& directory);

/// Writes DIRECTORY/NN_name/figure.png for every verification case whose figure.json is there; errors as above.
void plot_verification(const std::string& directory);

/// Draws the run times of `scree bench linear`, from the figures it wrote as JSON, into `picture` (PNG). Throws
/// ResourceError as above.
void plot_benchmark(const std::string& figures, const std::string& picture);

}  // namespace scree
