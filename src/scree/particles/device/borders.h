// What a device has to do with those of other ranks.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/compute/opencl/device.h"
#include "scree/data/domain.h"
#include "scree/mpi/blocks.h"
#include "scree/mpi/halo.h"
#include "scree/particles/luggage.h"

namespace scree {

/// The borders of a rank's block: whose copies stand on the device, and whose copies the others have. Rows are those of
/// the device.
struct DeviceBorders {
  Ranks ranks;
  Blocks blocks;
  Domain domain;
  Halo halo;                                   // messages of each step
  std::vector<std::int32_t> sent, ghosts;      // in the order of the messages
  std::vector<std::int64_t> ghost_ids;         // in that order
  std::vector<std::int64_t> come;              // ids of those who came when lists were made last
  std::vector<std::int32_t> come_rows;         // where they stand
  Luggage luggage;                             // of these
  opencl::DeviceBuffer sent_rows, ghost_rows;  // the same on the device
  opencl::DeviceBuffer packed;                 // rows of one column on their way

  std::size_t bytes() const { return sent_rows.bytes() + ghost_rows.bytes() + packed.bytes(); }
};

}  // namespace scree
