// The kinds of bodies of a case: what their sizes and speeds range over, for the numbers derived from it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scree/app/contact_places.h"
#include "scree/data/materials.h"
#include "scree/data/particles.h"
#include "scree/input/case.h"
#include "scree/particles/insert.h"

namespace scree {

/// One particle group, in numbers.
struct BodyKind {
  std::string name;
  std::size_t group = 0;  // of the case
  int material = 0;
  bool free = true;
  std::uint64_t count = 0;
  double density = 0;                    // [kg/m3]
  double smallest = 0, largest = 0;      // diameters that the case can create [m]
  double thickness = 0;                  // least, of the smallest body [m]
  double inscribed = 1;                  // diameter of a sphere inside a body over that by volume
  double tip = 1;                        // how much faster than its centre a point of a tumbling body gets; 1: sphere
  std::vector<ContactPlace> places{{}};  // of its surface where impacts are shortest
  double volume = 0;                     // of all of them [m3]
  double effect_gap = 0;                 // effect diameter minus body diameter [m]
  Vec3 velocity{};                       // mean at the start [m/s]
  double spread = 0;                     // how far velocities at the start are from the mean [m/s]

  /// Diameter of a particle of the mean volume [m].
  double typical() const;
};

/// The kinds of the case in the order of its groups. Draws all diameters and reads files of particles. Of groups that
/// come from another run's checkpoint it looks at `present`, where a run goes on, in place of that file.
std::vector<BodyKind> body_kinds(const Case& c, const Particles* present = nullptr);

/// How many particles a group has from the start, where a solid fraction decides from the mean volume of the first.
double expected_number(const ParticleGroup& group, std::uint32_t index, std::uint64_t seed);

}  // namespace scree
