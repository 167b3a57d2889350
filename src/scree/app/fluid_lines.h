// Tables of the fluid along straight lines.
#pragma once

#include <vector>

#include "scree/fluid/solver.h"
#include "scree/input/case.h"
#include "scree/output/run_directory.h"
#include "scree/output/series.h"

namespace scree {

class FluidLines {
 public:
  /// Opens the tables. `directory` is there at the root only; `resumed`: the run goes on from a checkpoint at `now`
  /// [s].
  FluidLines(const Case& c, const RunDirectory* directory, double now, bool resumed);

  /// The next time after `time` at which a sample is due [s].
  double next_event(double time) const;

  /// Writes the samples that are due; with `last` all. To be called by all ranks.
  void write_due(const FluidSolver& s, bool last);

 private:
  struct Line {
    FluidLineKeys keys;
    double interval, due;
    double written = -1;  // time of the last sample [s]
  };

  std::vector<Line> lines_;
  std::vector<SeriesWriter> tables_;  // at the root
};

}  // namespace scree
