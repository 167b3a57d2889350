#include "scree/input/mesh_weld.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "scree/physics/touch/triangle.h"

namespace scree {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t h = 0;
    for (std::int64_t k : cell) h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
    return h;
  }
};

/// Vertices found so far, in cells much larger than the tolerance: nearly every place lies in one cell alone.
class Places {
 public:
  Places(sc_vec low, double tolerance) : low_(low), tolerance_(tolerance) {}

  /// The first vertex at this place, or a new one.
  int vertex_at(sc_vec x, std::vector<sc_vec>& vertices) {
    const Cell first = cell_of(x, -tolerance_), last = cell_of(x, tolerance_);
    int found = -1;
    for (std::int64_t i = first[0]; i <= last[0]; ++i)
      for (std::int64_t j = first[1]; j <= last[1]; ++j)
        for (std::int64_t k = first[2]; k <= last[2]; ++k) found = earliest(found, {i, j, k}, x, vertices);
    if (found >= 0) return found;
    cells_[cell_of(x, 0)].push_back(static_cast<int>(vertices.size()));
    vertices.push_back(x);
    return static_cast<int>(vertices.size()) - 1;
  }

 private:
  Cell cell_of(sc_vec x, double shift) const {
    const auto index = [&](double along) {
      return static_cast<std::int64_t>(std::floor((along + shift) / (1000 * tolerance_)));
    };
    return {index(x.x - low_.x), index(x.y - low_.y), index(x.z - low_.z)};
  }

  int earliest(int found, const Cell& cell, sc_vec x, const std::vector<sc_vec>& vertices) const {
    const auto here = cells_.find(cell);
    if (here == cells_.end()) return found;
    for (int i : here->second)
      if ((found < 0 || i < found) && sc_norm(sc_sub(vertices[i], x)) <= tolerance_) found = i;
    return found;
  }

  sc_vec low_;
  double tolerance_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<int> place(mesh.vertices.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (int corner : triangle) place[corner] = 1;
  int kept = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const bool used = place[i] != 0;
    place[i] = kept;
    if (used) mesh.vertices[kept++] = mesh.vertices[i];
  }
  mesh.vertices.resize(kept);
  for (auto& triangle : mesh.triangles)
    for (int& corner : triangle) corner = place[corner];
}

bool too_thin(const TriangleMesh& mesh, const std::array<int, 3>& t, double tolerance) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const sc_vec a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  const double longest = std::max({sc_norm(sc_sub(b, a)), sc_norm(sc_sub(c, b)), sc_norm(sc_sub(a, c))});
  return sc_norm(sc_triangle_area(a, b, c)) <= tolerance * longest;
}

}  // namespace

TriangleMesh weld(const TriangleMesh& loose) {
  TriangleMesh mesh;
  mesh.degenerate = loose.degenerate;
  mesh.duplicate = loose.duplicate;
  if (loose.triangles.empty()) return mesh;
  sc_vec low = loose.vertices[loose.triangles[0][0]], high = low;
  for (const auto& triangle : loose.triangles)
    for (int corner : triangle) {
      const sc_vec x = loose.vertices[corner];
      low = sc_make_vec(std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z));
      high = sc_make_vec(std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z));
    }
  const double tolerance = weld_share * std::max(sc_norm(sc_sub(high, low)), 1e-30);
  Places places(low, tolerance);
  std::vector<int> welded(loose.vertices.size(), -1);
  std::set<std::array<int, 3>> known;
  for (const auto& triangle : loose.triangles) {
    std::array<int, 3> corners;
    for (int k = 0; k < 3; ++k) {
      int& vertex = welded[triangle[k]];
      if (vertex < 0) vertex = places.vertex_at(loose.vertices[triangle[k]], mesh.vertices);
      corners[k] = vertex;
    }
    std::array<int, 3> sorted = corners;
    std::ranges::sort(sorted);
    if (too_thin(mesh, corners, tolerance))
      ++mesh.degenerate;
    else if (!known.insert(sorted).second)
      ++mesh.duplicate;
    else
      mesh.triangles.push_back(corners);
  }
  drop_unused_vertices(mesh);
  return mesh;
}

}  // namespace scree
