// Counting planes: how many particles, and how much mass, have passed through a surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/particles.h"
#include "scree/data/plane_count.h"
#include "scree/kernels/counting_plane.h"

namespace scree {

/// Watches the centres of all particles of finite mass. A particle passes when it goes over from the side against the
/// normal (the plane's own points are on the other side); the place of passing is where a straight way meets the plane.
///
/// The sides are a function of the positions, so that one step's after is the next one's before to the last bit and
/// nothing is counted twice or lost; they take a byte per particle and plane, and no place in checkpoints. Across a
/// periodic axis the nearest image of the plane counts; its normal is along such an axis, or at right angles to it.
class PlaneWatch {
 public:
  explicit PlaneWatch(const sc_counting_plane& plane) : plane_(plane) {}

  /// Notes on which side all are: at the start, and whenever others have come.
  void note(const Particles& particles, const Domain& domain);

  /// Looks at the particles after a step, with their present velocities.
  void look(const Particles& particles, const Domain& domain);

  const sc_counting_plane& plane() const { return plane_; }
  const PlaneCount& count() const { return count_; }

  /// Adds what has passed while somebody else has looked.
  void add(const PlaneCount& count) { count_.add(count); }

  void restore(const PlaneCount& count) { count_ = count; }

 private:
  sc_counting_plane plane_;
  std::vector<std::uint8_t> side_;  // [ids]: SC_..._PLANE
  PlaneCount count_;
};

/// A count as plain numbers and back, for a checkpoint. Throws InputError if there are not as many as there must be.
std::vector<std::int64_t> numbers_of(const PlaneCount& count);
PlaneCount plane_count_from(std::span<const std::int64_t> numbers);

}  // namespace scree
