// A simulation whose particles are on a device.
#pragma once

#include <string>

#include "scree/compute/opencl/device.h"
#include "scree/input/case.h"
#include "scree/particles/device/particles.h"

namespace scree {

/// The device of a simulation, and the particles on it once they have been sent there.
struct DeviceRun {
  DeviceRun(const opencl::DeviceInfo& info, Precision p) : device(info), precision(p) {}

  opencl::Device device;
  Precision precision;
  std::optional<DeviceParticles> particles;
};

/// The device that `--device` names: "opencl:2" is the third of those that `scree info` lists, "opencl" the first, or
/// where several ranks of a machine share those of its kind, that of the rank with this `place` among them. Throws
/// InputError if there is none of that name, with what was tried.
opencl::DeviceInfo find_device(const std::string& name, int place = 0);

/// The precision that `--precision` names beside that `--device`: "double" or "mixed". Throws InputError for any other
/// name, and for mixed precision on the CPU.
Precision find_precision(const std::string& name, const std::string& device);

/// Throws InputError at the key of the first thing in the case that runs on the CPU only so far.
void refuse_on_device(const Case& c);

/// Throws InputError at the key of the first thing that devices have in double precision only.
void refuse_in_mixed(const Case& c, bool several = false);

}  // namespace scree
