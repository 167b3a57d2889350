// Vertices on the surfaces of forms, for the vertex method: how they are spread, and how they lie in memory.
#pragma once

#include <memory>
#include <vector>

#include "scree/compute/buffer.h"
#include "scree/data/forms.h"

namespace scree {

/// How vertices are spread.
enum class VertexSpacing {
  linear,       // equal steps of both angles of the parametric form (Barr 1981): dense at edges and poles, bare faces
  exponential,  // the same around the axis; along it steps that grow from the equator by e^(2 ln(1/e1)) in all, which
                // puts vertices on the side of cylinders (e1 < 1)
  radial,       // equal areas of an ellipsoid's sphere (Fibonacci's lattice), projected from the centre: even on faces
  normal,       // where the normals are spread so: dense where the surface is curved
  mixed         // half of the one, half of the other
};

/// A vertex at bounding radius 1, and the outward unit normal there.
struct SurfaceVertex {
  sc_vec point, normal;
};

/// The vertices of a form, without duplicates: side^2 of them; of the spacings by angles, which repeat the seam and the
/// poles, (side - 1)(side - 2) + 2. side >= 3.
std::vector<SurfaceVertex> surface_vertices(const Form& form, int side, VertexSpacing spacing);

/// Vertices in blocks of eight close ones. The last block is filled up with copies.
struct VertexBlocks {
  Buffer<double> points;   // [blocks][6][8]: x y z of the points, x y z of the normals
  Buffer<double> spheres;  // [eight at a time][4][8]: centre, radius around a block each; then around eight blocks each
  int count = 0, blocks = 0;
};

/// Brings vertices that are close together; the order depends on their places alone.
VertexBlocks blocks_of(std::vector<SurfaceVertex> vertices);

/// The vertices of all forms of a run.
struct SurfaceVertices {
  int side = 0;
  VertexSpacing spacing = VertexSpacing::linear;
  std::vector<VertexBlocks> of_form;
};

std::shared_ptr<const SurfaceVertices> make_vertices(const Forms& forms, int side, VertexSpacing spacing);

}  // namespace scree
