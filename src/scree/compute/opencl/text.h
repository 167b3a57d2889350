// The kernels of devices with all that they include: src/scree/kernels/opencl/*.cl.
#pragma once

namespace scree::opencl {

extern const char* const kernel_text;
// Mixed precision is these around it: contacts in single precision before, its own kernels behind.
extern const char* const single_text;
extern const char* const mixed_text;

// What follows that where some particles are no spheres: how their state is kept stands between the two others.
extern const char* const bodies_text;
extern const char* const full_bodies_text;
extern const char* const mixed_bodies_text;
extern const char* const shape_kernel_text;

}  // namespace scree::opencl
