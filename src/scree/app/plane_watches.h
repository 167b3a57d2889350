// The counting planes of a run. Each rank watches them with its own particles; the root adds up what all have counted.
#pragma once

#include <vector>

#include "scree/analysis/planes.h"
#include "scree/input/case.h"
#include "scree/mpi/ranks.h"
#include "scree/output/archive.h"

namespace scree {

class PlaneWatches {
 public:
  PlaneWatches() = default;
  explicit PlaneWatches(const Case& c);

  bool empty() const { return watches_.empty(); }
  std::vector<sc_counting_plane> planes() const;

  /// Before the first step: nobody has passed yet.
  void begin(const Particles& particles, const Domain& domain);

  /// Others have come since the last step, into the run or from other ranks, and have not passed yet where they are.
  void note(const Particles& particles, const Domain& domain);

  /// After a step.
  void look(const Particles& particles, const Domain& domain);

  /// Adds what has passed each plane while a device has looked.
  void add(const std::vector<PlaneCount>& counts);

  /// What has passed each plane since the start, at the root; all ranks call it.
  std::vector<PlaneCount> counts(const Ranks& ranks) const;

  /// The root goes on from what an archive says; what it does not know begins now.
  void restore(const Case& c, const Archive& archive, const Ranks& ranks);

 private:
  std::vector<PlaneWatch> watches_;
  bool begun_ = false;
};

}  // namespace scree
