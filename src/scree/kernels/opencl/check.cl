// What a device run begins with: structs are laid out as on the host.
#include "scree/kernels/opencl/parameters.h"

/// Sizes of what the host passes and reads.
__kernel void sc_sizes(__global int* out) {
  if (get_global_id(0) != 0) return;
  out[0] = (int)sizeof(sc_device_step);
  out[1] = (int)sizeof(sc_findings);
  out[2] = (int)sizeof(sc_wall);
  out[3] = (int)sizeof(sc_wall_pose);
  out[4] = (int)sizeof(sc_field);
  out[5] = (int)sizeof(sc_flow_shape);
}
