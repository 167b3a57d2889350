// The kernels of devices with all that they include: src/scree/kernels/opencl/*.cl.
#pragma once

namespace scree::opencl {

extern const char* const kernel_text;

/// What follows that where some particles are no spheres.
extern const char* const shape_kernel_text;

}  // namespace scree::opencl
