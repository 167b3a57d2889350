// The walls of a run as surfaces for pictures: an HDF5 file whenever they have moved, and an XDMF file over all frames.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace scree {

/// Triangles, and the wall that each belongs to.
struct WallSurface {
  std::vector<double> points;           // three coordinates each [m]
  std::vector<std::int32_t> triangles;  // three points each
  std::vector<std::int32_t> wall;       // of each triangle: index into the walls of the case

  bool operator==(const WallSurface&) const = default;
};

/// Writes DIR/walls/walls_NNNNNN.h5, where NNNNNN is the first frame that shows the walls so, and DIR/walls.xdmf,
/// which has a grid for each frame. Both are replaced atomically. A file of walls that have only moved holds their
/// points alone; the triangles are in an earlier file, which its attribute `triangles_in` names.
class SurfaceWriter {
 public:
  /// A new series in an existing run directory that has a folder `frames`; nothing is written before the first frame.
  static SurfaceWriter create(const std::filesystem::path& directory);

  /// Goes on after what is there; what is later than `last_time` [s] is deleted.
  /// Throws InputError when the last surface cannot be read.
  static SurfaceWriter resume(const std::filesystem::path& directory, double last_time);

  /// Adds the walls of the frame with this number; a surface that has not changed costs no file. Throws ResourceError.
  void write(double time, std::uint64_t frame, const WallSurface& surface);

 private:
  explicit SurfaceWriter(std::filesystem::path directory) : directory_(std::move(directory)) {}
  void write_list() const;

  std::filesystem::path directory_;
  WallSurface last_;
  std::string file_;           // of the last surface, relative to the run directory; empty before the first
  std::string topology_file_;  // that holds its triangles
  std::string grids_;          // the XDMF text of the frames so far
};

}  // namespace scree
