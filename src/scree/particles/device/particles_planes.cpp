// Counting planes of particles on a device.
#include <algorithm>

#include "scree/particles/device/particles.h"

namespace scree {

void DeviceParticles::watch(const std::vector<sc_counting_plane>& planes) {
  if (planes.empty()) return;
  check_sizes("sc_plane_sizes", {sizeof(sc_counting_plane)});
  DevicePlanes& p = planes_.emplace();
  p.planes = opencl::sent(device_, planes);
  p.counts.resize(planes.size());
  p.passed = opencl::DeviceBuffer(device_, rows_ * p.row_bytes());
  p.passed.clear();
  make_scratch(p.row_bytes());
}

void DeviceParticles::count_passings(int number, int from, int to) {
  program_.run("sc_count_passings", n_, group, constants_, number, stale_, motion_[from], motion_[to], ghost_flags(),
               static_cast<int>(planes_->counts.size()), planes_->planes, planes_->passed);
}

/// Takes down what the particles have passed: before some go, or come to rows where others were.
void DeviceParticles::take_passings() {
  if (!planes_) return;
  DevicePlanes& p = *planes_;
  const std::size_t planes = p.counts.size();
  const auto passed = p.passed.values<std::int32_t>(n_ * planes * 2);
  if (std::all_of(passed.begin(), passed.end(), [](std::int32_t times) { return times == 0; })) return;
  const auto mass = columns_.at("mass").values<double>(n_);
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t k = 0; k < planes; ++k) {
      const std::int32_t* times = &passed[2 * (i * planes + k)];
      for (std::int32_t t = 0; t < times[0]; ++t) p.counts[k].add(1, mass[i]);
      for (std::int32_t t = 0; t < times[1]; ++t) p.counts[k].add(-1, mass[i]);
    }
  p.passed.clear();
}

std::vector<PlaneCount> DeviceParticles::take_counts() {
  take_passings();
  const std::size_t planes = planes_ ? planes_->counts.size() : 0;
  std::vector<PlaneCount> out(planes);
  if (planes_) std::swap(out, planes_->counts);
  return out;
}

}  // namespace scree
