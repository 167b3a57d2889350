// Random places without overlap (random sequential addition).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scree/data/domain.h"
#include "scree/particles/cell_grid.h"
#include "scree/particles/insert.h"
#include "scree/physics/touch/shape_shape.h"

namespace scree {

/// A body where it is to be, for the narrow phase; empty where all are spheres.
std::optional<sc_body_shape> body_of(const ParticleGroup& group, std::uint32_t index, const Newcomer& newcomer,
                                     const InsertionSetting& setting);

/// The bodies placed so far by the spheres around them, in one cell grid per octave of radius, so that finding out
/// whether a place is free takes the same time however many there are.
class OccupiedSpace {
 public:
  /// Room for spheres with these radii, all inside the box of the domain.
  OccupiedSpace(const Domain& domain, const std::vector<double>& radii);

  /// `body`: what is in the sphere; without it the whole sphere is taken.
  void add(const std::array<double, 3>& position, double radius, const std::optional<sc_body_shape>& body = {});

  /// True if a body at `position`, or without one the sphere, touches none of those added.
  bool is_free(const std::array<double, 3>& position, double radius,
               const std::optional<sc_body_shape>& body = {}) const;

 private:
  struct Level {
    double reach = 0;  // largest radius
    CellLattice lattice;
    std::vector<std::int32_t> head;  // [cells]: the last sphere added to the cell, or -1
  };
  struct Sphere {
    std::array<double, 3> position;
    double radius;
    std::int32_t next;  // in the same cell, or -1
    std::int32_t body;  // in bodies_, or -1
  };

  bool overlap(const std::array<double, 3>& position, const sc_body_shape* body, const Sphere& sphere) const;

  int octave(double radius) const;

  Domain domain_;
  double largest_ = 0;
  std::vector<Level> levels_;
  std::vector<Sphere> spheres_;
  std::vector<sc_body_shape> bodies_;
};

/// Where the centre of a body may be so that it lies in the region of its group.
struct PlaceRange {
  std::array<double, 3> low{}, width{};  // [m]
};

/// `body`: as body_of() tells. Throws InputError when it is too large for the region.
PlaceRange range_of_places(const ParticleGroup& group, const Newcomer& newcomer,
                           const std::optional<sc_body_shape>& body, const InsertionSetting& setting);

/// Place number `attempt` [m] that is tried for a particle of group `index`, by its number: uniform over the range.
std::array<double, 3> random_place(const PlaceRange& range, std::uint32_t index, std::uint64_t number,
                                   std::uint32_t attempt, const InsertionSetting& setting);

/// Places the particles of a group, the largest first, where they touch neither what is in `space` nor a wall, and adds
/// them to it. Position number i belongs to diameter number i. Every place is tried at random, uniform over the region;
/// the tries of the whole group together are bounded by `group.attempts` per particle.
/// Throws InputError, saying how many found room, when that is not enough.
std::vector<std::array<double, 3>> random_positions(const ParticleGroup& group, std::uint32_t index,
                                                    const std::vector<double>& diameters,
                                                    const InsertionSetting& setting, OccupiedSpace& space);

}  // namespace scree
