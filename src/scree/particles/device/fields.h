// What acts on particles besides contacts, as the kernels of a device are told of it (kernels/opencl/fields.cl).
#pragma once

#include <optional>
#include <string>

#include "scree/compute/opencl/device.h"
#include "scree/kernels/opencl/parameters.h"
#include "scree/particles/fields.h"

namespace scree {

/// Fields of particles that stay on a device. Of particles in a fluid that is solved for, forces, density and viscosity
/// of the fields are those by which it turns them; all else it has said to each.
class DeviceFields {
 public:
  /// `prescribed`: some bodies' motion is; their accelerations stand among what acts.
  DeviceFields(const opencl::Device& device, const Fields& fields, const Particles& particles, bool prescribed);

  /// The choices of the fields, which are constants of the kernels.
  static std::string options(const Fields& fields, bool coupled, bool prescribed);

  /// The formulas of the fields, to stand before the text of the kernels.
  static std::string formulas(const Fields& fields);

  /// For so many particles.
  void make_room(const opencl::Device& device, std::size_t particles);

  /// SC_FIELDS_...
  static int place(const Fields& fields, bool coupled, bool prescribed);

  /// Whether sc_meet_fields has to run before every step.
  bool apart() const { return place_ == SC_FIELDS_APART; }

  /// Whether sc_turn_particles has to follow it.
  bool turns() const { return turns_; }

  /// Whether what acts may be no number.
  bool watched() const { return watched_; }

  sc_surroundings around(double now) const;

  /// Of the forms of the particles: sc_flow_shape, and their tables; empty where no force goes by shape.
  const opencl::DeviceBuffer& shapes() const { return shapes_; }
  const opencl::DeviceBuffer& tables() const { return tables_; }

  /// What acts at each particle in the last step for which it was found apart.
  const opencl::DeviceBuffer& found() const { return found_; }
  opencl::DeviceBuffer& found() { return found_; }

  /// Marks of the steps in which what acts somewhere is no number.
  opencl::DeviceBuffer& lost() { return lost_; }
  const opencl::DeviceBuffer& lost() const { return lost_; }

  /// The first of `steps` steps with such a mark, which goes; empty if there is none.
  std::optional<std::ptrdiff_t> take_first_lost(std::size_t steps);

  /// Memory of the device in use [bytes].
  std::size_t bytes() const;

 private:
  void send_shapes(const opencl::Device& device, const std::vector<FlowShape>& shapes);

  int place_;
  bool watched_, turns_;
  sc_surroundings around_{};
  opencl::DeviceBuffer shapes_, tables_, found_, lost_;
};

}  // namespace scree
