// Counting planes that a device looks at in every step.
#pragma once

#include <vector>

#include "scree/compute/opencl/device.h"
#include "scree/data/plane_count.h"

namespace scree {

struct DevicePlanes {
  opencl::DeviceBuffer planes;     // sc_counting_plane
  opencl::DeviceBuffer passed;     // of each particle [plane]: how often it has passed along the normal, and against it
  std::vector<PlaneCount> counts;  // of those who were there when `passed` was emptied last

  std::size_t row_bytes() const { return counts.size() * 2 * sizeof(std::int32_t); }
  std::size_t bytes() const { return planes.bytes() + passed.bytes(); }
};

}  // namespace scree
