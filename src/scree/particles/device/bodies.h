// Bodies on a device that move as formulas say.
#pragma once

#include <vector>

#include "scree/compute/opencl/device.h"
#include "scree/kernels/opencl/parameters.h"
#include "scree/kernels/prescribed.h"

namespace scree {

struct DeviceBodies {
  std::vector<sc_body_group> groups;
  int count = 0;                                     // of all groups
  opencl::DeviceBuffer of_groups, rows, prescribed;  // prescribed: [step][body]

  std::size_t bytes() const { return of_groups.bytes() + rows.bytes() + prescribed.bytes(); }
};

}  // namespace scree
