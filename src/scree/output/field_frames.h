// Pictures of the fluid at chosen times: one HDF5 file per frame and an XDMF file over all of them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "scree/output/frames.h"

namespace scree {

/// Writes DIR/fluid/fluid_NNNNNN.h5 and DIR/fluid.xdmf, each replaced atomically.
class FieldFrameWriter {
 public:
  /// `faces` are those of the grid along x, y, z [m]. Keeps the frames up to `last_time` [s] and removes later ones.
  /// Throws InputError when a frame cannot be read, ResourceError.
  FieldFrameWriter(const std::filesystem::path& directory, std::array<std::vector<double>, 3> faces,
                   std::string program, double last_time);

  /// Writes the next frame. Every column has one row per cell, x running fastest.
  void write(double time, std::uint64_t step, std::span<const FrameColumn> columns);

 private:
  void write_film() const;

  std::filesystem::path directory_;
  std::array<std::vector<double>, 3> faces_;
  std::string program_;
  std::uint64_t count_ = 0;
  std::string grids_;  // the XDMF text of the frames so far
};

}  // namespace scree
