// What bodies that are no spheres have on a device besides.
#pragma once

#include <cstddef>

#include "scree/compute/opencl/device.h"
#include "scree/particles/device/mixed_state.h"

namespace scree {

/// Pairs with what they remember, numbered by owner: that of the lower id. The rows are those of
/// kernels/opencl/pairs.cl.
struct DevicePairs {
  std::size_t count = 0;
  std::size_t room = 0;
  opencl::DeviceBuffer rows;                   // owner with contact_code(), partner
  opencl::DeviceBuffer slides, rolls, shapes;  // shapes: two rows each, PairContacts::shape
  opencl::DeviceBuffer apart;                  // PairContacts::apart

  std::size_t bytes() const { return rows.bytes() + slides.bytes() + rolls.bytes() + shapes.bytes() + apart.bytes(); }
};

struct DeviceShapes {
  opencl::DeviceBuffer forms;
  DevicePairs pairs, fresh;
  opencl::DeviceBuffer first;          // pairs of earlier owners, for each particle
  opencl::DeviceBuffer gather;         // as the partners' lists: the number of the pair, and whether one is its partner
  std::size_t room = 0;                // pairs that there is place for in a step
  opencl::DeviceBuffer loads, full;    // of pairs, of one step: what they did, and whether there is anything
  opencl::DeviceBuffer looks, looked;  // pairs that need a look, and how many, step by step
  opencl::DeviceBuffer wall_loads;     // of particles: what walls did
  opencl::DeviceBuffer places;         // of the listed faces, in the present step

  std::size_t bytes() const {
    std::size_t sum = pairs.bytes() + fresh.bytes();
    for (const auto* b : {&forms, &first, &gather, &loads, &full, &looks, &looked, &wall_loads, &places})
      sum += b->bytes();
    return sum;
  }
};

/// Calls launch(...) with what kernels are given of the present state of bodies: rows in double, or where there is a
/// state in mixed precision, the half `now` of that.
template <class Launch>
void with_bodies(const MixedState* mixed, int now, const opencl::DeviceBuffer& motion, const opencl::DeviceBuffer& spin,
                 const opencl::DeviceBuffer& excess, Launch&& launch) {
  if (mixed)
    launch(mixed->space, mixed->near[now], mixed->speed[now], mixed->spin[now], mixed->rest_places, mixed->rest_speeds,
           mixed->rest_spins, mixed->excess_of);
  else
    launch(motion, spin, excess);
}

}  // namespace scree
