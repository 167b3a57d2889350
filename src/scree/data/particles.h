// The particles of this rank: plain arrays, each declared by one line of the table below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "scree/compute/buffer.h"

namespace scree {

/// When a field is sent where particles are spread over ranks: to the copies of the particle in every step, to the
/// copies when they are made, or only with the particle when it gets another owner.
enum class Travels { always, with_lists, on_migration };

// FIELD(name, type, components, travels, saved, what the components are [unit])
//
// What a pair reads together lies together: `motion` is one cache line, `spin` half of one; a contact reads 96 bytes of
// each partner. The spin is kept as radius times angular velocity, so that every lane a contact needs is a sum or a
// difference of the two rows.
#define SCREE_PARTICLE_FIELDS(FIELD)                                                                                \
  FIELD(motion, double, 8, always, true, "x y z [m] radius [m] vx vy vz [m/s] inverse_mass [1/kg]")                 \
  FIELD(spin, double, 4, always, true, "radius * wx wy wz [m/s] inverse_radius [1/m]")                              \
  FIELD(id, std::int64_t, 1, with_lists, true, "id for life")                                                       \
  FIELD(material, std::int32_t, 1, with_lists, true, "index into the materials")                                    \
  FIELD(group, std::int32_t, 1, on_migration, true, "index into the particle groups of the case")                   \
  FIELD(image, std::int32_t, 4, on_migration, true, "periods travelled along x y z, unused")                        \
  FIELD(mass, double, 1, on_migration, true, "mass [kg], also of bodies that move as prescribed")                   \
  FIELD(effect_excess, double, 1, with_lists, true, "effect radius minus body radius [m]")                          \
  FIELD(loss, double, 4, on_migration, true, "energy lost by normal damping, sliding, rolling, relocation [J]")     \
  FIELD(work, double, 4, on_migration, true, "work by drag, body force, prescribed motion, walls [J]")              \
  FIELD(impulse, double, 4, on_migration, true, "impulse of drag, fields, walls, fixed bodies x y z [N s], unused") \
  FIELD(angular_impulse, double, 4, on_migration, true, "their angular impulse about the origin x y z [N m s], unused")

// Only where some particle is no sphere. `spin` then follows from the angular momentum: that of the time of the
// velocities, with the inertia of the orientation, which goes with the positions. Inverse moments of bodies of infinite
// mass are 0, and their spin is what it was set to.
#define SCREE_SHAPE_FIELDS(FIELD)                                                                                 \
  FIELD(form, std::int32_t, 1, with_lists, true, "index into the forms; 0 is the sphere")                         \
  FIELD(orientation, double, 4, always, true, "quaternion w x y z from the body's frame to the world's")          \
  FIELD(angular_momentum, double, 4, always, true, "in the world x y z [kg m2/s], way of the surface so far [m]") \
  FIELD(inertia, double, 4, with_lists, true, "inverse principal moments x y z [1/(kg m2)], radius by volume [m]")

// Only where particles and a fluid that is solved for act on each other: what the fluid has said at its last step, and
// what has come of it since.
#define SCREE_COUPLED_FIELDS(FIELD)                                                                                   \
  FIELD(stream, double, 4, on_migration, true, "velocity of the fluid x y z [m/s], rate of its drag [1/s]")           \
  FIELD(pull, double, 4, on_migration, true, "acceleration by the fluid besides drag x y z [m/s2], unused")           \
  FIELD(drag_impulse, double, 4, on_migration, true, "impulse of drag since x y z [N s], time it has acted [s]")      \
  FIELD(expected, double, 4, on_migration, true, "impulse the fluid counts on x y z [N s], part of slip that stays")  \
  FIELD(before, double, 4, on_migration, true, "velocity at the fluid's last step x y z [m/s], added mass over mass") \
  FIELD(met_at, double, 4, on_migration, true, "place at the fluid's last step x y z [m], 1 where there was one")     \
  FIELD(met_turned, double, 4, on_migration, true, "orientation then, quaternion w x y z")

// Only where such a fluid turns particles.
#define SCREE_TURNED_FIELDS(FIELD)                \
  FIELD(gradient, double, 10, on_migration, true, \
        "of the fluid's velocity, a row for each component [1/s], void fraction")

// Only where particles have a temperature.
#define SCREE_HEAT_FIELDS(FIELD) FIELD(heat, double, 2, always, true, "temperature [K], heat capacity [J/K]")

/// One field: `components` values per particle, contiguous.
template <class T, int Components>
struct Column {
  using value_type = T;
  static constexpr int components = Components;
  Buffer<T> values;

  T* row(std::size_t i) { return values.data() + i * Components; }
  const T* row(std::size_t i) const { return values.data() + i * Components; }
  T& operator[](std::size_t i) requires(Components == 1) { return values[i]; }
  const T& operator[](std::size_t i) const requires(Components == 1) { return values[i]; }
};

/// Components of Particles::motion and ::spin by name.
namespace lane {
enum : int { x = 0, y = 1, z = 2, radius = 3, vx = 4, vy = 5, vz = 6, inverse_mass = 7 };
enum : int { sx = 0, sy = 1, sz = 2, inverse_radius = 3 };
/// Of ::angular_momentum, and of ::inertia.
enum : int { path = 3 };
enum : int { radius_by_volume = 3 };
/// Of Particles::heat.
enum : int { temperature = 0, heat_capacity = 1 };
}  // namespace lane

class Particles {
 public:
  Particles() = default;

  /// With the fields of shapes, or without.
  explicit Particles(bool shaped) : shaped_(shaped) {}

#define FIELD(name, type, components, travels, saved, doc) Column<type, components> name;
  SCREE_PARTICLE_FIELDS(FIELD)
  SCREE_SHAPE_FIELDS(FIELD)
  SCREE_COUPLED_FIELDS(FIELD)
  SCREE_TURNED_FIELDS(FIELD)
  SCREE_HEAT_FIELDS(FIELD)
#undef FIELD

  /// The particles that this rank moves.
  std::size_t size() const { return size_; }

  /// Copies of particles of other ranks, which stand after the own ones. Of them only what Travels says is there.
  std::size_t ghosts() const { return ghosts_; }

  /// Own particles and copies.
  std::size_t held() const { return size_ + ghosts_; }

  /// Whether the fields of shapes are there.
  bool shaped() const { return shaped_; }

  /// Whether the fields of a coupling with a fluid are there.
  bool coupled() const { return coupled_; }

  /// Whether the fields of a coupling that turns particles are there.
  bool turned() const { return turned_; }

  /// Adds the fields of a coupling, all zero; `with_turning`: that turns particles, too.
  void couple(bool with_turning);

  /// Whether particles have a temperature.
  bool warm() const { return warm_; }

  /// Adds the fields of heat, all zero.
  void give_heat();

  /// No particles, with the same fields.
  Particles none_alike() const;

  /// Radius of the sphere of the same volume, for what goes by volume: drag, solid fractions [m]. The radius in
  /// `motion` is that of the sphere around the body.
  double radius_by_volume(std::size_t i) const {
    return shaped_ ? inertia.row(i)[lane::radius_by_volume] : motion.row(i)[lane::radius];
  }

  /// New particles have all fields zero. Copies of other ranks' particles go.
  void resize(std::size_t n);

  /// Makes room for `n` copies of other ranks' particles, all fields zero.
  void resize_ghosts(std::size_t n);

  /// Puts particle order[i] at place i, in every field; particles that `order` does not name are gone, and copies of
  /// other ranks' particles.
  void permute(const std::vector<std::uint32_t>& order);

  /// Adds copies of all the others after those that are there. Both have shapes, or neither; fields of a coupling and
  /// of heat are zero where the others have none.
  void append(const Particles& others);

  /// Calls visit(name, column, travels, saved, doc) for every field, in the order of the table.
  template <class Visit>
  void for_each_field(Visit&& visit) {
#define FIELD(name, type, components, travels, saved, doc) \
  visit(std::string_view(#name), name, Travels::travels, saved, doc);
    SCREE_PARTICLE_FIELDS(FIELD)
    if (shaped_) {
      SCREE_SHAPE_FIELDS(FIELD)
    }
    if (coupled_) {
      SCREE_COUPLED_FIELDS(FIELD)
    }
    if (turned_) {
      SCREE_TURNED_FIELDS(FIELD)
    }
    if (warm_) {
      SCREE_HEAT_FIELDS(FIELD)
    }
#undef FIELD
  }

  template <class Visit>
  void for_each_field(Visit&& visit) const {
    // The table is the same; who only reads gets columns that can only be read.
    const_cast<Particles*>(this)->for_each_field(
        [&](std::string_view name, const auto& column, auto... rest) { visit(name, column, rest...); });
  }

  /// Memory of one particle over all fields that are there [bytes].
  std::size_t bytes_per_particle() const;

 private:
  std::size_t size_ = 0, ghosts_ = 0;
  bool shaped_ = false, coupled_ = false, turned_ = false, warm_ = false;
};

/// The places of all particles in the order of their ids.
std::vector<std::uint32_t> order_by_id(const Particles& particles);

}  // namespace scree
