// What a run writes while it goes on: series, tracks, frames, books and checkpoints, each when it is due.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scree/analysis/agglomerate_summary.h"
#include "scree/analysis/ledger.h"
#include "scree/app/due.h"
#include "scree/app/measures.h"
#include "scree/app/simulation.h"
#include "scree/app/sticking.h"
#include "scree/output/field_frames.h"
#include "scree/output/frames.h"
#include "scree/output/run_directory.h"
#include "scree/output/series.h"
#include "scree/output/wall_surface.h"

namespace scree {

class Outputs {
 public:
  /// Opens the files of a run. With `archive` the run continues from it: later rows and frames
  /// are dropped.
  Outputs(const Case& c, const RunDirectory& directory, const Clock& clock, const Archive* archive);

  /// Writes whatever is due at the present step of the simulation. Throws PhysicsError when the books do not close.
  void write_due(Simulation& simulation);

  /// Writes a checkpoint of the present state and removes old ones.
  void write_checkpoint(Simulation& simulation);

  /// Writes the state that the last row of the series saw, for when the present one is lost, unless a later checkpoint
  /// is there. Returns the file's name.
  std::string write_last_good(Simulation& simulation) const;

  /// Row and frame of a state that has gone wrong, as far as its numbers are finite; they are in no books and no
  /// checkpoint. Returns whether there was anything to show.
  bool show_failure(Simulation& simulation);

  /// Row, frame and checkpoint of the present state, due or not, unless they are there already.
  void finish(Simulation& simulation);

  /// The checkpoint that was written last; empty before the first.
  std::string latest_checkpoint() const;

  /// The latest balance of the books.
  const LedgerRow& balance() const { return row_; }
  /// What was measured last; the work of body forces counts from the start, as all exchanges do.
  Measured measured() const;

  /// What the progress of a run shows: the pressure that the particles cost, and the balance of the books.
  std::string note() const;

  /// True when enough particles are in agglomerates for the case to end.
  bool agglomerated() const { return agglomerated_; }

 private:
  void take_stock(Simulation& simulation);
  void enter_books(Simulation& simulation);
  void write_row(Simulation& simulation);
  void append_row(Simulation& simulation);
  void write_tracks(const Sample& sample, double time);
  void write_shapes(const Forms& forms);
  void write_frame(Simulation& simulation);
  void save_books(Archive& archive) const;

  Case case_;
  std::string record_;  // of the case, for the checkpoints
  const RunDirectory& directory_;
  double series_interval_;
  std::optional<SeriesWriter> series_, tracks_, sizes_;
  std::optional<FrameWriter> frames_, contacts_;
  std::optional<SurfaceWriter> surfaces_;
  std::optional<FieldFrameWriter> fields_;
  Measures measures_;
  std::int64_t row_due_ = 0, frame_due_ = 0, checkpoint_due_ = 0, books_due_ = 0;
  std::int64_t row_step_ = -1, frame_step_ = -1, checkpoint_step_ = -1;
  bool shapes_written_ = false;
  std::optional<Books> books_;
  Measured measured_;
  LedgerRow row_;
  std::int64_t impacts_ = 0, impact_speed_ = 0;  // of the tally at the last row
  std::optional<Archive> last_good_;             // what is added to the state that the simulation has kept
  std::int64_t last_good_step_ = -1;
  bool agglomerated_ = false;
  std::vector<double> fluid_row_;  // of the last row
};

}  // namespace scree
