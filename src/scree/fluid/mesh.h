// The cells of one rank: a box of the grid with two layers of ghosts, which of its faces are open, and its boundary.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scree/compute/buffer.h"
#include "scree/data/fluid_region.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// A number for every cell, or for the lower face of every cell along one axis; ghosts included.
using Field = Buffer<double>;
using VectorField = std::array<Field, 3>;

/// Widths along one axis. Entry [ghosts + i] belongs to cell i, or to the face between cells i - 1 and i.
struct MeshAxis {
  std::vector<double> width;         // of cells [m]
  std::vector<double> per_width;     // its inverse
  std::vector<double> lower_share;   // linear interpolation to the face: the weight of the cell below it
  std::vector<double> per_distance;  // inverse distance of the centres on both sides of the face [1/m]
};

/// A face of the boundary.
struct BoundaryFace {
  std::int64_t cell = 0, face = 0;  // places in the arrays
  std::int64_t inward = 0;          // step of an index into the fluid
  int axis = 0;
  int side = 0;  // +1: the outward normal points along the axis, -1: against it
  int patch = -1;
  PatchKind kind = PatchKind::wall;
  int depth = 1;                  // cells of fluid in a row from here on, 3 at most
  double area = 0;                // [m2]
  double half = 0;                // from the centre of the cell to the face [m]
  double second = 0;              // from the face to the centre of the cell behind [m]
  double far = 0;                 // from there to that of the third cell [m]
  std::array<double, 3> place{};  // [m]
  std::array<double, 3> reach{};  // half widths of the cell [m]
  // What is given there at the end of the step.
  std::array<double, 3> velocity{};  // [m/s]
  double pressure = 0;               // of outlets, and beyond plates [Pa]
  double resistance = 0;             // of plates, at the speed of the step [Pa s/m]
  double viscosity = 0;              // of the fluid at the face [Pa s]
};

struct Mesh {
  static constexpr int ghosts = 2;

  const FluidRegion* region = nullptr;
  CellBox box;                           // of this rank, in the whole grid
  std::array<int, 3> n{};                // cells of this rank
  std::array<std::int64_t, 3> stride{};  // of the arrays
  std::int64_t size = 0;                 // of the arrays
  std::array<int, 3> blocks{1, 1, 1};    // ranks along each axis
  std::array<int, 3> place{};            // of this rank among them
  std::array<MeshAxis, 3> axis;
  VectorField open;  // 1 for faces between two cells of fluid, else 0
  Field fluid;       // 1 for cells of fluid, else 0; ghosts included
  std::vector<BoundaryFace> boundary;
  bool slips = false;        // whether some face holds the fluid along some axes only
  bool plates = false;       // whether some face is permeable, on any rank
  bool outlets = false;      // whether the pressure is given somewhere, on any rank
  std::int64_t anchor = -1;  // place in the arrays of one cell of fluid, on one rank; -1 on the others
  std::int64_t cells = 0;    // of fluid, on all ranks
  double volume = 0;         // of the fluid, on all ranks [m3]

  std::int64_t index(int i, int j, int k) const {
    return (i + ghosts) + (j + ghosts) * stride[1] + (k + ghosts) * stride[2];
  }
  double area(int a, int i, int j, int k) const {
    const int at[3] = {i, j, k}, b = (a + 1) % 3, c = (a + 2) % 3;
    return axis[b].width[ghosts + at[b]] * axis[c].width[ghosts + at[c]];
  }
  double cell_volume(int i, int j, int k) const {
    return axis[0].width[ghosts + i] * axis[1].width[ghosts + j] * axis[2].width[ghosts + k];
  }
  std::array<double, 3> centre(int i, int j, int k) const;

  Field make_field() const { return Field(static_cast<std::size_t>(size)); }
  VectorField make_vector() const { return {make_field(), make_field(), make_field()}; }
};

/// The share of a rank: boxes of nearly equal numbers of cells. `region` must outlive the mesh. Throws InputError when
/// an axis has fewer than two cells for a rank.
Mesh make_mesh(const FluidRegion& region, const Ranks& ranks);

/// The cells of a rank among `blocks` along each axis; `place` is where it is among them.
CellBox share_of_grid(const Grid& grid, const std::array<int, 3>& blocks, const std::array<int, 3>& place);

/// Rank of a place among the blocks.
int rank_at(const std::array<int, 3>& blocks, const std::array<int, 3>& place);

/// Calls visit(j, k) for every row of cells along x, on the threads of the team; each must write only what is its own.
template <class Visit>
void for_each_row(const Mesh& mesh, Visit&& visit) {
  const int ny = mesh.n[1], rows = ny * mesh.n[2];
#pragma omp parallel for schedule(static)
  for (int row = 0; row < rows; ++row) visit(row % ny, row / ny);
}

}  // namespace scree
