// The OpenCL library of this machine, found when the program runs: one binary works with and without it.
#pragma once

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <string>
#include <vector>

namespace scree::opencl {

// The functions that Scree uses, each declared once.
#define SCREE_OPENCL_FUNCTIONS(FUNCTION) \
  FUNCTION(clGetPlatformIDs)             \
  FUNCTION(clGetPlatformInfo)            \
  FUNCTION(clGetDeviceIDs)               \
  FUNCTION(clGetDeviceInfo)              \
  FUNCTION(clCreateContext)              \
  FUNCTION(clReleaseContext)             \
  FUNCTION(clCreateCommandQueue)         \
  FUNCTION(clReleaseCommandQueue)        \
  FUNCTION(clCreateProgramWithSource)    \
  FUNCTION(clBuildProgram)               \
  FUNCTION(clGetProgramBuildInfo)        \
  FUNCTION(clReleaseProgram)             \
  FUNCTION(clCreateKernel)               \
  FUNCTION(clReleaseKernel)              \
  FUNCTION(clSetKernelArg)               \
  FUNCTION(clCreateBuffer)               \
  FUNCTION(clReleaseMemObject)           \
  FUNCTION(clEnqueueReadBuffer)          \
  FUNCTION(clEnqueueWriteBuffer)         \
  FUNCTION(clEnqueueFillBuffer)          \
  FUNCTION(clEnqueueCopyBuffer)          \
  FUNCTION(clEnqueueNDRangeKernel)       \
  FUNCTION(clFlush)                      \
  FUNCTION(clFinish)

/// The functions by name; null where there is no library.
struct Library {
#define FUNCTION(name) decltype(&::name) name = nullptr;
  SCREE_OPENCL_FUNCTIONS(FUNCTION)
#undef FUNCTION
  std::vector<std::string> tried;  // where it was looked for, and what came of it
  bool found = false;
};

/// Looks once in a process: for the loader; where there is none or it knows no platform, for NVIDIA's library, which
/// containers often have without the file that tells the loader of it.
const Library& library();

}  // namespace scree::opencl
