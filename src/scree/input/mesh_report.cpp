#include "scree/input/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scree/physics/touch/triangle.h"

namespace scree {
namespace {

/// An edge of a triangle; `forward` tells which way the triangle runs along it.
struct Edge {
  int low, high;
  bool forward;
};

std::vector<Edge> edges_of(const Mesh& mesh) {
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

void count_edges(const Mesh& mesh, MeshReport& report) {
  const std::vector<Edge> edges = edges_of(mesh);
  for (std::size_t first = 0, end; first < edges.size(); first = end) {
    end = first + 1;
    while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
    const std::size_t count = end - first;
    report.open_edges += count == 1;
    report.crowded_edges += count > 2;
    report.flipped_edges += count == 2 && edges[first].forward == edges[first + 1].forward;
  }
}

int count_pieces(const Mesh& mesh) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles)
    for (int corner : t) parent[root(corner)] = root(t[0]);
  std::vector<int> roots;
  for (const auto& t : mesh.triangles) roots.push_back(root(t[0]));
  std::ranges::sort(roots);
  return static_cast<int>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

std::string counted(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

MeshReport report_mesh(const Mesh& mesh) {
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
  add(r.crowded_edges, "edge has more than two triangles", "edges have more than two triangles");
  add(r.flipped_edges, "edge has triangles wound against each other", "edges have triangles wound against each other");
  add(r.degenerate, "triangle without area was left out", "triangles without area were left out");
  add(r.duplicate, "triangle that was there already was left out", "triangles that were there already were left out");
  return text;
}

}  // namespace scree
