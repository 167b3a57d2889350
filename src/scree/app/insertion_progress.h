// How far the random insertion of particles is, where it takes long.
#pragma once

#include <string>

#include "scree/app/progress.h"

namespace scree {

/// Is told of every try (InsertionWatch). Shows nothing for the first seconds, then rewrites a line on a terminal twice
/// a second and elsewhere prints one every 10 s.
class InsertionProgress {
 public:
  explicit InsertionProgress(ProgressOptions options);

  void operator()(const std::string& group, std::size_t placed, std::size_t wanted);

 private:
  ProgressOptions options_;
  double due_;          // wall time of the next line [s]
  bool begun_ = false;  // a line of a terminal that is not ended
};

}  // namespace scree
