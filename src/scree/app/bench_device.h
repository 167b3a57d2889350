// Up to ten million particles on an OpenCL device: a dense bed, a bed of ellipsoids, and a vortex.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scree/app/bench.h"
#include "scree/app/bench_scene.h"

namespace scree {

/// One size of the bed on a device.
struct DeviceFigures {
  std::string name, device, precision;
  std::int64_t particles = 0;
  int steps = 0;                              // of a round
  double rate = 0, slowest = 0, fastest = 0;  // particle-steps per second: median, slowest and fastest round
  double contacts = 0;                        // that acted, per particle
  bool shaped = false;                        // not all particles are spheres
  double bytes = 0;                           // that a particle-step has to move, counted from the layout; spheres only
  double copy_bandwidth = 0;                  // of the device [bytes/s]
  double memory = 0;                          // of the device, per particle [bytes]
};

/// Measures the bed of `scene` in tiles side by side, up to `largest` particles, on the device and in the
/// precision of the options. Prints each size when it is done.
std::vector<DeviceFigures> measure_bed_on_device(const std::string& benchmark, const BenchScene& scene,
                                                 const BenchOptions& options, std::int64_t largest, int rounds);

/// The same of cohesive spheres in a Taylor-Green vortex, the kind of case of the OpenCL report.
std::vector<DeviceFigures> measure_vortex_on_device(const BenchOptions& options, std::int64_t largest, int rounds);

nlohmann::json device_json(const DeviceFigures& f);

}  // namespace scree
