// Bodies on a device whose motion is prescribed.
#include "scree/particles/device/particles.h"

namespace scree {

void DeviceParticles::send_bodies(const std::vector<sc_body_group>& groups) {
  if (groups.empty()) return;
  check_sizes("sc_body_sizes", {sizeof(sc_body_group), sizeof(sc_prescribed)});
  DeviceBodies& b = bodies_.emplace();
  b.groups = groups;
  b.count = static_cast<int>(groups.back().number + groups.back().count);
  b.of_groups = opencl::sent(device_, groups);
  b.rows = opencl::DeviceBuffer(device_, static_cast<std::size_t>(b.count) * sizeof(std::int32_t));
  b.prescribed = opencl::DeviceBuffer(device_, most_given * static_cast<std::size_t>(b.count) * sizeof(sc_prescribed));
}

/// Rows are others when the particles have been sorted.
void DeviceParticles::find_bodies() {
  DeviceBodies& b = *bodies_;
  b.rows.clear();
  program_.run("sc_find_bodies", n_, group, static_cast<int>(n_), columns_.at("id"), ghost_flags(),
               static_cast<int>(b.groups.size()), b.of_groups, b.rows);
}

/// What moves the bodies in all steps given.
void DeviceParticles::send_prescribed() {
  std::vector<sc_prescribed> all;
  for (const DeviceStep& g : given_) all.insert(all.end(), g.bodies.begin(), g.bodies.end());
  bodies_->prescribed.write(all.data(), all.size() * sizeof all[0]);
}

void DeviceParticles::accelerate_bodies(int number, int from) {
  const DeviceBodies& b = *bodies_;
  if (constants_.move.lag == 0) return;
  program_.run("sc_accelerate_bodies", static_cast<std::size_t>(b.count), group, constants_, number, stale_, b.count,
               b.rows, b.prescribed, motion_[from], fields_.found());
}

void DeviceParticles::carry_bodies(int number, int to) {
  const DeviceBodies& b = *bodies_;
  program_.run("sc_carry_bodies", static_cast<std::size_t>(b.count), group, constants_, number, stale_, b.count, b.rows,
               b.prescribed, listed_, motion_[to], columns_.at("image"), column_or_none("angular_momentum"));
}

}  // namespace scree
