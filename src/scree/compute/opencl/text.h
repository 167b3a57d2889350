// The kernels of devices with all that they include, as one text: src/scree/kernels/opencl/*.cl.
#pragma once

namespace scree::opencl {

extern const char* const kernel_text;

}  // namespace scree::opencl
