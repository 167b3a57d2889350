// Averages on a regular grid: one HDF5 file per span of time, and an XDMF file over all of them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "scree/output/frames.h"

namespace scree {

/// Which cells, and which samples, a file is about.
struct GridSpan {
  std::array<double, 3> min{}, max{};  // [m]
  std::array<std::int64_t, 3> cells{};
  double begin = 0, end = 0;  // times of the first and the last sample [s]
  std::int64_t samples = 0;
};

/// Writes DIR/averages/NAME_NNNNNN.h5 and DIR/averages/NAME.xdmf, each replaced atomically.
class GridWriter {
 public:
  /// Keeps the first `kept` files of that name, if they are there, and removes the others.
  /// Throws InputError when a file cannot be read, ResourceError.
  GridWriter(const std::filesystem::path& directory, std::string name, std::string program, std::uint64_t kept);

  /// Writes file `number`, or writes it again. Every column has one row per cell, x running fastest.
  void write(std::uint64_t number, const GridSpan& span, std::span<const FrameColumn> columns);

 private:
  void write_film() const;

  std::filesystem::path folder_;
  std::string name_, prefix_, program_;
  std::map<std::uint64_t, std::string> grids_;  // the XDMF text of each file
};

}  // namespace scree
