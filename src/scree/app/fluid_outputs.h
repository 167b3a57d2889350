// What the run of a fluid writes while it goes on. Every member is to be called by all ranks; the root writes.
#pragma once

#include <optional>
#include <string>

#include "scree/app/fluid_columns.h"
#include "scree/app/fluid_lines.h"
#include "scree/fluid/averages.h"
#include "scree/output/archive.h"
#include "scree/output/field_frames.h"
#include "scree/output/run_directory.h"
#include "scree/output/series.h"

namespace scree {

/// What a frame shows of the fluid; to be called by all ranks.
std::vector<FrameColumn> fluid_frame(const FluidSolver& s, bool single);

class FluidOutputs {
 public:
  /// Opens the files of a run. `directory` is there at the root only. With `archive` the run continues from it.
  FluidOutputs(const Case& c, const FluidSolver& s, const RunDirectory* directory, const Archive* archive);

  /// The next time at which something is due that the time step should meet [s].
  double next_event(double time) const;

  /// Takes a step that has been made into the averages.
  void note_step(const FluidSolver& s);

  /// Whether write_due() would write a row of the series.
  bool row_due(const FluidSolver& s) const;

  /// Writes what is due. With `last` everything, due or not.
  void write_due(const FluidSolver& s, FluidTally& tally, bool last);

  void write_checkpoint(const FluidSolver& s);

  /// The checkpoint that was written last; empty before the first.
  std::string latest_checkpoint() const { return latest_; }

 private:
  void write_row(const FluidSolver& s, FluidTally& tally);
  void write_frame(const FluidSolver& s);

  Case case_;
  std::string record_;  // of the case, for the checkpoints
  const RunDirectory* directory_;
  FluidLines lines_;
  std::optional<FluidAverages> averages_;
  double series_interval_, series_due_, frame_due_, checkpoint_due_;
  std::int64_t row_step_ = -1, frame_step_ = -1, checkpoint_step_ = -1;
  std::optional<SeriesWriter> series_;
  std::optional<FieldFrameWriter> frames_;
  std::string latest_;
};

}  // namespace scree
