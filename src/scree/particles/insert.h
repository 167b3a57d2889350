// How particles come to be: groups of them, placed on a lattice, at random, or as given.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/forms.h"
#include "scree/data/particles.h"
#include "scree/data/walls.h"
#include "scree/particles/orientations.h"
#include "scree/particles/sizes.h"

namespace scree {

/// A particle whose place is given; what is empty comes from its group.
struct GivenParticle {
  std::array<double, 3> position{};                       // [m]
  std::optional<std::array<double, 3>> velocity;          // [m/s]
  std::optional<std::array<double, 3>> angular_velocity;  // [rad/s]
  std::optional<double> diameter;                         // of the sphere of equal volume [m]
  std::optional<sc_quat> orientation{};
  std::optional<Form> shape{};
};

/// The velocity of the fluid [m/s] at a position [m].
using FluidVelocity = std::function<std::array<double, 3>(const std::array<double, 3>&)>;

/// Particles that are made alike.
struct ParticleGroup {
  enum class Placement { lattice, random, given, feed };
  enum class Start { given, random, fluid };

  std::string name;
  std::int32_t material = 0;
  double density = 0;      // [kg/m3]
  SizeDistribution sizes;  // of the sphere of equal volume
  Form shape = sphere_form();
  Orientations orientations;
  double effect_gap = 0;  // effect diameter minus body diameter [m]
  bool free = true;       // else fixed or moving as prescribed: of infinite mass

  Placement placement = Placement::lattice;
  std::array<double, 3> region_min{}, region_max{};  // lattice, random: bodies lie wholly inside [m]
  std::uint64_t count = 0;                           // lattice, random
  double solid_fraction = 0;                         // random: instead of count
  double spacing = 0;                                // lattice [m]; 0: fill the region evenly with `count`
  double jitter = 0;                                 // lattice: largest shift over half the gap between neighbours
  std::uint64_t attempts = 1000;                     // random: tries per particle, on average over the group
  std::vector<GivenParticle> given;                  // given; those of a feed come later (feed.h)

  Start start = Start::given;
  std::array<double, 3> velocity{};          // given; the mean if random [m/s]
  double velocity_deviation = 0;             // random: of each component [m/s]
  std::array<double, 3> angular_velocity{};  // [rad/s]
};

/// Is told of every try to place a particle of a group at random how many of it are placed already, of how many.
using InsertionWatch = std::function<void(const std::string& group, std::size_t placed, std::size_t wanted)>;

/// What insertion needs to know of the run.
struct InsertionSetting {
  Domain domain;
  const Walls* walls = nullptr;
  Forms forms;  // of all particles; empty if all are spheres
  std::uint64_t seed = 1;
  double max_overlap = 0.2;  // of the smaller radius; deeper overlaps at the start are refused
  FluidVelocity fluid;       // for groups that start with the velocity of the fluid
  InsertionWatch watch;      // may be empty
};

/// How many particles the group has from the start; 0 where a solid fraction decides.
std::uint64_t group_count(const ParticleGroup& group);

/// The diameters [m] of all particles of group number `index`, in the order of their numbers; as many as it has.
/// With a solid fraction, particles are added until their volume is as near to the wanted one as it can be.
std::vector<double> group_diameters(const ParticleGroup& group, std::uint32_t index, std::uint64_t seed);

/// The sphere, and the shapes of all groups; empty if there is nothing but spheres.
Forms forms_of(const std::vector<ParticleGroup>& groups);

/// Radius of the sphere around a body of this shape, whose volume is that of a sphere of this diameter [m].
inline double radius_around(const Form& shape, double diameter) { return 0.5 * diameter / shape.equivalent_radius; }

/// The shape and the orientation of particle number `number` of a group.
const Form& shape_of(const ParticleGroup& group, std::uint64_t number);
sc_quat orientation_of(const ParticleGroup& group, std::uint32_t index, std::uint64_t number, std::uint64_t seed);

/// A particle that is to be made: its number in its group, and where.
struct Newcomer {
  std::uint64_t number = 0;
  double diameter = 0;               // [m]
  std::array<double, 3> position{};  // [m]
};

/// Writes a particle of group number `index` into a row, with the id of that row.
void write_particle(Particles& particles, std::size_t row, const ParticleGroup& group, std::uint32_t index,
                    const Newcomer& newcomer, const InsertionSetting& setting);

/// Makes the particles of all groups. Ids count from 0 through the groups in their order. The result depends on the
/// arguments alone. Throws InputError when a group does not fit, when a given particle lies outside the domain or in a
/// wall, or when two overlap by more than setting.max_overlap.
Particles insert_particles(const std::vector<ParticleGroup>& groups, const InsertionSetting& setting);

}  // namespace scree
