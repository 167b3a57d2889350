// One [[analysis.averages]] while a run goes on: when to sample, what has been summed, and the files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "scree/analysis/averages.h"
#include "scree/app/simulation.h"
#include "scree/output/grids.h"

namespace scree {

class AverageRun {
 public:
  /// Begins, or goes on from what save() put into `archive`; averages that the archive does not know begin now.
  /// Throws InputError when the archive has averages of this name on another grid.
  AverageRun(const Case& c, const AverageKeys& keys, const Clock& clock, const std::filesystem::path& directory,
             const Archive* archive);

  /// Takes a sample if one is due at the present step, and writes the file of a window that is complete.
  void look(Simulation& simulation);

  /// Writes what there is of an incomplete window; a run that goes on will write that file again.
  void finish();

  void save(Archive& archive) const;

 private:
  void restore(const Archive& archive);
  void plan(std::int64_t step);
  void write();

  AverageKeys keys_;
  double dt_;
  std::int64_t first_step_;               // of the first sample
  std::int64_t sample_due_, window_due_;  // steps
  std::int64_t window_ = 0;               // number of the present one
  double begin_ = 0, end_ = 0;            // times of its first and last sample [s]
  Averages averages_;
  std::optional<GridWriter> writer_;
};

}  // namespace scree
