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

  /// Before a step: nobody has passed yet where nobody has been seen.
  void begin(const Particles& particles, const Domain& domain, double dt);

  /// Others have come from other ranks since the last step: notes the sides of all with ids below `fresh`; those that
  /// have come into the run since are taken to have come with their velocities, wherever they are.
  void note(const Particles& particles, const Domain& domain, std::int64_t fresh);

  /// After a step.
  void look(const Particles& particles, const Domain& domain, double dt);

  /// What has passed each plane since the start, at the root; all ranks call it.
  std::vector<PlaneCount> counts(const Ranks& ranks) const;

  /// The root goes on from what an archive says; what it does not know begins now.
  void restore(const Case& c, const Archive& archive, const Ranks& ranks);

 private:
  std::vector<PlaneWatch> watches_;
  bool begun_ = false;
};

}  // namespace scree
