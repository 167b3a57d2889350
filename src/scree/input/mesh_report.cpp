#include "scree/input/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "scree/physics/touch/triangle.h"

namespace scree {
namespace {

constexpr std::size_t most_rims = 4;  // that are described

/// An edge of a triangle; `forward` tells which way the triangle runs along it.
struct Edge {
  int low, high;
  bool forward;
};

std::vector<Edge> edges_of(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair{e.low, e.high}; });
  return edges;
}

/// Sets of numbers that grow together.
class Union {
 public:
  explicit Union(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) { parent_[root(a)] = root(b); }

 private:
  std::vector<int> parent_;
};

std::vector<MeshRim> rims_of(const TriangleMesh& mesh, const std::vector<Edge>& open) {
  Union together(mesh.vertices.size());
  for (const Edge& edge : open) together.join(edge.low, edge.high);
  std::map<int, MeshRim> rims;  // by root
  for (const Edge& edge : open) {
    const sc_vec a = mesh.vertices[edge.low], b = mesh.vertices[edge.high];
    MeshRim& rim = rims.try_emplace(together.root(edge.low), MeshRim{0, a, a}).first->second;
    ++rim.edges;
    for (const sc_vec& x : {a, b}) {
      rim.low = sc_make_vec(std::min(rim.low.x, x.x), std::min(rim.low.y, x.y), std::min(rim.low.z, x.z));
      rim.high = sc_make_vec(std::max(rim.high.x, x.x), std::max(rim.high.y, x.y), std::max(rim.high.z, x.z));
    }
  }
  std::vector<MeshRim> out;
  for (const auto& [root, rim] : rims) out.push_back(rim);
  std::ranges::stable_sort(out, std::ranges::greater{}, &MeshRim::edges);
  return out;
}

void count_edges(const TriangleMesh& mesh, MeshReport& report) {
  const std::vector<Edge> edges = edges_of(mesh);
  std::vector<Edge> open;
  for (std::size_t first = 0, end; first < edges.size(); first = end) {
    end = first + 1;
    while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
    const std::size_t count = end - first;
    if (count == 1) open.push_back(edges[first]);
    report.crowded_edges += count > 2;
    report.flipped_edges += count == 2 && edges[first].forward == edges[first + 1].forward;
  }
  report.open_edges = static_cast<int>(open.size());
  report.rims = rims_of(mesh, open);
}

int count_pieces(const TriangleMesh& mesh) {
  Union together(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (int corner : t) together.join(corner, t[0]);
  std::vector<int> roots;
  for (const auto& t : mesh.triangles) roots.push_back(together.root(t[0]));
  std::ranges::sort(roots);
  return static_cast<int>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

std::string counted(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

MeshReport report_mesh(const TriangleMesh& mesh) {
  MeshReport report;
  report.triangles = static_cast<int>(mesh.triangles.size());
  report.vertices = static_cast<int>(mesh.vertices.size());
  report.degenerate = mesh.degenerate;
  report.duplicate = mesh.duplicate;
  if (mesh.triangles.empty()) return report;
  report.low = report.high = mesh.vertices[mesh.triangles[0][0]];
  const sc_vec origin = report.low;
  for (const auto& t : mesh.triangles) {
    const sc_vec a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const sc_vec area = sc_triangle_area(a, b, c);
    report.area += 0.5 * sc_norm(area);
    report.volume += sc_dot(sc_sub(a, origin), area) / 6;
    for (const sc_vec& x : {a, b, c}) {
      report.low = sc_make_vec(std::min(report.low.x, x.x), std::min(report.low.y, x.y), std::min(report.low.z, x.z));
      report.high =
          sc_make_vec(std::max(report.high.x, x.x), std::max(report.high.y, x.y), std::max(report.high.z, x.z));
    }
  }
  report.volume = std::abs(report.volume);
  report.pieces = count_pieces(mesh);
  count_edges(mesh, report);
  return report;
}

std::string describe(const MeshReport& r) {
  const sc_vec size = sc_sub(r.high, r.low);
  std::string text =
      fmt::format("{}, {}, {}; {:.4g} x {:.4g} x {:.4g} m from ({:.4g}, {:.4g}, {:.4g}), area {:.4g} m^2, {}",
                  counted(r.triangles, "triangle", "triangles"), counted(r.vertices, "vertex", "vertices"),
                  counted(r.pieces, "piece", "pieces"), size.x, size.y, size.z, r.low.x, r.low.y, r.low.z, r.area,
                  r.closed() ? "closed" : "open");
  if (r.closed() && r.flipped_edges == 0) text += fmt::format(", volume {:.4g} m^3", r.volume);
  const auto add = [&](int count, std::string_view one, std::string_view many) {
    if (count > 0) text += "\n" + counted(count, one, many);
  };
  add(r.open_edges, "edge has one triangle only: the surface ends there",
      "edges have one triangle only: the surface ends there");
  for (std::size_t k = 0; k < std::min(r.rims.size(), most_rims); ++k) {
    const MeshRim& rim = r.rims[k];
    const sc_vec middle = sc_scale(0.5, sc_add(rim.low, rim.high)), length = sc_sub(rim.high, rim.low);
    text +=
        fmt::format("\nrim of {}, {:.4g} x {:.4g} x {:.4g} m about ({:.4g}, {:.4g}, {:.4g})",
                    counted(rim.edges, "edge", "edges"), length.x, length.y, length.z, middle.x, middle.y, middle.z);
  }
  if (r.rims.size() > most_rims)
    text += "\n" + counted(static_cast<int>(r.rims.size() - most_rims), "more rim", "more rims");
  add(r.crowded_edges, "edge has more than two triangles", "edges have more than two triangles");
  add(r.flipped_edges, "edge has triangles wound against each other", "edges have triangles wound against each other");
  add(r.degenerate, "triangle without area was left out", "triangles without area were left out");
  add(r.duplicate, "triangle that was there already was left out", "triangles that were there already were left out");
  return text;
}

}  // namespace scree
