// What a surface of triangles is like: whether it is closed, and what is wrong with it.
#pragma once

#include <string>
#include <vector>

#include "scree/input/mesh.h"

namespace scree {

/// Open edges that hang together: the border of a hole, or of the surface.
struct MeshRim {
  int edges = 0;
  sc_vec low{}, high{};  // corners of the box around it [m]
};

struct MeshReport {
  int triangles = 0, vertices = 0;
  int pieces = 0;                     // parts that share no vertex
  sc_vec low{}, high{};               // corners of the box around it [m]
  double area = 0;                    // [m^2]
  double volume = 0;                  // enclosed; of use where the surface is closed and wound one way [m^3]
  int open_edges = 0;                 // with one triangle
  std::vector<MeshRim> rims;          // of these edges, the longest first
  int crowded_edges = 0;              // with more than two
  int flipped_edges = 0;              // with two that are wound against each other
  int degenerate = 0, duplicate = 0;  // triangles left out, see TriangleMesh

  bool closed() const { return open_edges == 0 && crowded_edges == 0; }
};

/// Looks at a welded mesh, in metres.
MeshReport report_mesh(const TriangleMesh& mesh);

/// The report in words: a line of what it is, then a line for everything that is unusual.
std::string describe(const MeshReport& report);

}  // namespace scree
