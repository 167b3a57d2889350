// XDMF 3: the small XML file that tells ParaView what the frames hold.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scree/output/element.h"

namespace scree {

/// What XDMF needs to know of one dataset.
struct XdmfField {
  std::string name;
  Element element = Element::float64;
  std::uint64_t components = 1;
};

/// What XDMF needs to know of one frame; `file` is relative to the XDMF file. One field is called "position".
struct XdmfFrame {
  std::string file;
  double time = 0;
  std::uint64_t points = 0;
  std::vector<XdmfField> fields;
  std::string group = "particles";  // of the datasets in the file
};

/// Fields of the cells of a regular grid; x runs fastest.
struct XdmfCells {
  std::string file;
  double time = 0;
  std::array<double, 3> min{}, spacing{};
  std::array<std::int64_t, 3> cells{};
  std::vector<XdmfField> fields;
};

/// Fields of the cells of a rectilinear grid, whose faces are the datasets "x", "y", "z" of the group "faces"; x runs
/// fastest.
struct XdmfRectilinear {
  std::string file;
  double time = 0;
  std::array<std::int64_t, 3> cells{};
  std::vector<XdmfField> fields;
};

/// The walls at the time of one frame; files are relative to the XDMF file.
struct XdmfSurface {
  std::string points_file, triangles_file;  // the second holds the walls of the triangles too
  double time = 0;                          // [s]
  std::uint64_t points = 0, triangles = 0;
};

/// The element for one frame: a cloud of points at one time, each other field an attribute of its points.
std::string xdmf_grid(const XdmfFrame& frame);

/// The element for the walls at the time of one frame: triangles, with the number of their wall.
std::string xdmf_surface(const XdmfSurface& surface);

/// The element for averages on a grid, each field an attribute of its cells; datasets are in the group "fields".
std::string xdmf_grid(const XdmfCells& cells);

/// The element for a frame of fields, each an attribute of the cells; datasets are in the group "fields".
std::string xdmf_grid(const XdmfRectilinear& cells);

/// The whole document: a temporal collection of the given grids, one after the other.
std::string xdmf_document(const std::string& grids);

}  // namespace scree
