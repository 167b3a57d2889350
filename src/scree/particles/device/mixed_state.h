// The state of particles on a device in mixed precision, and the units of its numbers.
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <iterator>
#include <optional>
#include <type_traits>
#include <vector>

#include "scree/compute/opencl/device.h"
#include "scree/kernels/opencl/fixed_space.h"
#include "scree/particles/system.h"

namespace scree {

/// Units in which the numbers of a system are near 1, and its space: bodies further apart than `reach` [m] never meet.
sc_fixed_space fixed_space_of(const ParticleSystem& system, double reach);

/// The same space of another domain, in the units of `units`.
sc_fixed_space fixed_space_of(const Domain& domain, double reach, const sc_fixed_space& units);

/// Of what a contact remembers, rows of four numbers: of the first three and of the last.
struct MemoryUnits {
  double stretch = 1, last = 1;
};

/// Writes rows of what contacts remember; in single precision where there are units.
void write_memory(opencl::DeviceBuffer& to, const std::vector<double>& rows, const std::optional<MemoryUnits>& units);

/// Reads `count` rows, the first of them `first`.
std::vector<double> read_memory(const opencl::DeviceBuffer& from, std::size_t first, std::size_t count,
                                const std::optional<MemoryUnits>& units);

/// Numbers of a struct that has no others, in single precision.
template <class T>
std::vector<float> narrowed(const T& numbers) {
  static_assert(sizeof(T) % sizeof(double) == 0 && std::is_trivially_copyable_v<T>);
  double wide[sizeof(T) / sizeof(double)];
  std::memcpy(wide, &numbers, sizeof wide);
  return {std::begin(wide), std::end(wide)};
}

/// What is kept of every particle, besides the books. The first three are there twice, for the present step and the
/// next.
struct MixedState {
  /// Of nobody yet.
  explicit MixedState(const sc_fixed_space& units_and_space) : space(units_and_space) {}

  /// Calls visit(buffer, bytes of a row) for what goes along when particles are put in another order.
  void for_each_row(int now, const std::function<void(opencl::DeviceBuffer&, std::size_t)>& visit);

  /// The same for all that has a row for each particle.
  void for_each_buffer(const std::function<void(opencl::DeviceBuffer&, std::size_t)>& visit);

  /// Sends what contacts of materials go by.
  void send_laws(const opencl::Device& device, const Materials& materials, const sc_fixed_space& units);

  /// Takes `count` particles from their rows in double, the first of them `first`.
  void take(opencl::Program& program, int now, std::size_t first, std::size_t count, const opencl::DeviceBuffer& motion,
            const opencl::DeviceBuffer& spin, const opencl::DeviceBuffer& excess);

  /// Takes velocities and spins alone, of the first `count`, if step number `step` is done.
  void take_speeds(opencl::Program& program, int now, int step, const opencl::DeviceBuffer& stale, std::size_t count,
                   const opencl::DeviceBuffer& motion, const opencl::DeviceBuffer& spin);

  /// Keeps the places of the first `count` in another space of the same domain, with the same units.
  void move_to(const sc_fixed_space& other, opencl::Program& program, int now, std::size_t count,
               const opencl::DeviceBuffer& motion);

  /// Gives positions, velocities and spins of the first `count` to the rows in double.
  void give(opencl::Program& program, int now, std::size_t count, const opencl::DeviceBuffer& motion,
            const opencl::DeviceBuffer& spin) const;

  std::size_t bytes() const;

  MemoryUnits slide_units() const { return {space.length, space.length / space.time}; }

  sc_fixed_space space;
  opencl::DeviceBuffer near[2], speed[2], spin[2];
  opencl::DeviceBuffer rest_places, rest_speeds, rest_spins;
  opencl::DeviceBuffer excess_of, listed, laws;
};

}  // namespace scree
