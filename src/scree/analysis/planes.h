// Counting planes: how many particles, and how much mass, have passed through a surface.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scree/base/exact_sum.h"
#include "scree/data/domain.h"
#include "scree/data/particles.h"

namespace scree {

/// A plane, or what of it lies within a distance of its point and within a box.
struct CountingPlane {
  std::array<double, 3> point{}, normal{};  // [m], unit vector
  double radius = 0;                        // of the disc about the point; infinite for a whole plane [m]
  std::array<double, 3> min{}, max{};       // the box [m]
};

/// What has passed through a plane since the start.
struct PlaneCount {
  std::int64_t along = 0, against = 0;  // particles that crossed along the normal, and against it
  ExactSum mass;                        // net, along the normal [kg]
};

/// Watches the centres of all particles of finite mass. A particle passes when it goes over from the side against the
/// normal (the plane's own points are on the other side); the place of passing is where a straight way meets the plane.
///
/// The sides are a function of the positions, so that one step's after is the next one's before to the last bit and
/// nothing is counted twice or lost; they take a byte per particle and plane, and no place in checkpoints. Across a
/// periodic axis the nearest image of the plane counts; its normal is along such an axis, or at right angles to it.
class PlaneWatch {
 public:
  explicit PlaneWatch(const CountingPlane& plane) : plane_(plane) {}

  /// Looks at the particles after a step of `dt` [s] with their present velocities; those that have not been seen
  /// before are taken to have come with these velocities. `first`: nobody has passed yet, only sides are noted.
  void look(const Particles& particles, const Domain& domain, double dt, bool first);

  /// Notes the sides of all whose ids are below `fresh`: who has been watched elsewhere so far has not passed
  /// meanwhile.
  void note(const Particles& particles, const Domain& domain, std::int64_t fresh);

  const PlaneCount& count() const { return count_; }
  void restore(const PlaneCount& count) { count_ = count; }

 private:
  enum Side : std::uint8_t { unseen, before, behind };

  void make_room(const Particles& particles);

  CountingPlane plane_;
  std::vector<std::uint8_t> side_;  // [ids]
  PlaneCount count_;
};

/// A count as plain numbers and back, for a checkpoint. Throws InputError if there are not as many as there must be.
std::vector<std::int64_t> numbers_of(const PlaneCount& count);
PlaneCount plane_count_from(std::span<const std::int64_t> numbers);

}  // namespace scree
