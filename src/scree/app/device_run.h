// A simulation whose particles are on a device.
#pragma once

#include <string>

#include "scree/compute/opencl/device.h"
#include "scree/input/case.h"
#include "scree/particles/device/spheres.h"

namespace scree {

/// The device of a simulation, and the particles on it once they have been sent there.
struct DeviceRun {
  explicit DeviceRun(const opencl::DeviceInfo& info) : device(info) {}

  opencl::Device device;
  std::optional<DeviceSpheres> spheres;
};

/// The device that `--device` names: "opencl:2" is the third of those that `scree info` lists, "opencl" the first, or
/// where several ranks of a machine share those of its kind, that of the rank with this `place` among them. Throws
/// InputError if there is none of that name, with what was tried.
opencl::DeviceInfo find_device(const std::string& name, int place = 0);

/// Throws InputError at the key of the first thing in the case that runs on the CPU only so far.
void refuse_on_device(const Case& c);

/// The same of what runs on a device of one process only.
void refuse_on_several_devices(const Case& c);

}  // namespace scree
