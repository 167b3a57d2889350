// Agglomerates by breadth-first walks over the bonds, from the smallest id up.
#include "scree/analysis/agglomerates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {
namespace {

using Image = std::array<std::int32_t, 3>;

/// The bonded particles in order of id, each with its neighbours as places in that order, ascending. Walking it gives
/// the same sequence whatever the order of particles and bonds.
struct BondGraph {
  std::vector<std::int32_t> particle;   // [nodes]: index of the particle
  std::vector<std::size_t> first;       // [nodes + 1]: neighbours of node u are first[u] ... first[u + 1] - 1
  std::vector<std::int32_t> neighbour;  // nodes
};

/// The particles that have a bond, in order of id.
std::vector<std::int32_t> bonded_particles(const Particles& particles, std::span<const Bond> bonds) {
  std::vector<std::uint8_t> bonded(particles.size(), 0);
  for (const Bond& bond : bonds) bonded[bond.first] = bonded[bond.second] = 1;
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < bonded.size(); ++i) {
    if (bonded[i]) found.push_back(static_cast<std::int32_t>(i));
  }
  std::sort(found.begin(), found.end(),
            [&](std::int32_t i, std::int32_t j) { return particles.id[i] < particles.id[j]; });
  return found;
}

/// Sorts each node's neighbours and drops those listed twice.
void sort_neighbours(BondGraph& graph) {
  std::size_t kept = 0, begin = 0;
  for (std::size_t u = 0; u < graph.particle.size(); ++u) {
    const auto row = graph.neighbour.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto row_end = graph.neighbour.begin() + static_cast<std::ptrdiff_t>(graph.first[u + 1]);
    std::sort(row, row_end);
    const auto unique_end = std::unique(row, row_end);
    begin = graph.first[u + 1];
    std::copy(row, unique_end, graph.neighbour.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += static_cast<std::size_t>(unique_end - row);
    graph.first[u + 1] = kept;
  }
  graph.neighbour.resize(kept);
}

BondGraph bond_graph(const Particles& particles, std::span<const Bond> bonds) {
  BondGraph graph;
  graph.particle = bonded_particles(particles, bonds);
  std::vector<std::int32_t> node(particles.size(), -1);
  for (std::size_t u = 0; u < graph.particle.size(); ++u) node[graph.particle[u]] = static_cast<std::int32_t>(u);

  graph.first.assign(graph.particle.size() + 1, 0);
  for (const Bond& bond : bonds) {
    ++graph.first[node[bond.first] + 1];
    ++graph.first[node[bond.second] + 1];
  }
  for (std::size_t u = 1; u < graph.first.size(); ++u) graph.first[u] += graph.first[u - 1];
  std::vector<std::size_t> next(graph.first.begin(), graph.first.end() - 1);
  graph.neighbour.resize(2 * bonds.size());
  for (const Bond& bond : bonds) {
    const std::int32_t u = node[bond.first], v = node[bond.second];
    graph.neighbour[next[u]++] = v;
    graph.neighbour[next[v]++] = u;
  }
  sort_neighbours(graph);
  return graph;
}

/// The periods to add to `to` so that it is the image nearest to `from`.
Image nearest_image(const double* from, const double* to, const Domain& domain) {
  Image image{};
  for (int axis = 0; axis < 3; ++axis) {
    const double difference = to[axis] - from[axis], half = domain.half_period(axis);
    image[axis] = difference > half ? -1 : difference < -half ? 1 : 0;
  }
  return image;
}

/// The nodes of one agglomerate in the order of the walk.
struct Walk {
  std::vector<std::int32_t> nodes;
  std::vector<Image> image;  // [all nodes]: periods to add to a position to unwrap it
  std::vector<std::uint8_t> seen;
  std::array<bool, 3> spans{};
};

/// Visits everything connected with `start`.
void walk_from(std::int32_t start, const BondGraph& graph, const Particles& particles, const Domain& domain,
               Walk& walk) {
  walk.nodes.assign(1, start);
  walk.spans = {};
  walk.seen[start] = 1;
  for (std::size_t done = 0; done < walk.nodes.size(); ++done) {
    const std::int32_t u = walk.nodes[done];
    const double* from = particles.motion.row(graph.particle[u]);
    for (std::size_t k = graph.first[u]; k < graph.first[u + 1]; ++k) {
      const std::int32_t v = graph.neighbour[k];
      Image image = nearest_image(from, particles.motion.row(graph.particle[v]), domain);
      for (int axis = 0; axis < 3; ++axis) image[axis] += walk.image[u][axis];
      if (!walk.seen[v]) {
        walk.seen[v] = 1;
        walk.image[v] = image;
        walk.nodes.push_back(v);
      }
      for (int axis = 0; axis < 3; ++axis) walk.spans[axis] = walk.spans[axis] || image[axis] != walk.image[v][axis];
    }
  }
}

/// The position of a node, unwrapped and relative to the first one of its agglomerate [m].
std::array<double, 3> unwrapped(std::int32_t node, const BondGraph& graph, const Particles& particles,
                                const Domain& domain, const Walk& walk) {
  const double* position = particles.motion.row(graph.particle[node]);
  const double* origin = particles.motion.row(graph.particle[walk.nodes.front()]);
  std::array<double, 3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = position[axis] - origin[axis] + walk.image[node][axis] * domain.period(axis);
  }
  return result;
}

double wrapped(double x, int axis, const Domain& domain) {
  if (!domain.periodic[axis]) return x;
  x -= domain.period(axis) * std::floor((x - domain.min[axis]) / domain.period(axis));
  return x < domain.max[axis] ? x : domain.min[axis];
}

/// Square of a particle's own radius of gyration: half the sum of its principal moments over its mass [m2]. That of the
/// sphere of its volume where the moments are not kept, for infinite mass.
double own_gyration(const Particles& p, std::size_t i) {
  if (p.shaped() && p.motion.row(i)[lane::inverse_mass] > 0) {
    const double* inverse = p.inertia.row(i);
    return 0.5 * (1 / inverse[0] + 1 / inverse[1] + 1 / inverse[2]) / p.mass[i];
  }
  const double radius = p.radius_by_volume(i);
  return 0.6 * radius * radius;
}

/// Size and shape of the agglomerate that `walk` has visited.
Agglomerate measure(const BondGraph& graph, const Particles& particles, const Domain& domain, const Walk& walk) {
  Agglomerate result;
  result.id = particles.id[graph.particle[walk.nodes.front()]];
  result.members = static_cast<std::int64_t>(walk.nodes.size());
  result.spans = walk.spans;
  std::array<double, 3> moment{};
  for (const std::int32_t u : walk.nodes) {
    const std::int32_t i = graph.particle[u];
    const double mass = particles.mass[i];
    const auto x = unwrapped(u, graph, particles, domain, walk);
    for (int axis = 0; axis < 3; ++axis) moment[axis] += mass * x[axis];
    result.mass += mass;
    result.mean_radius += particles.radius_by_volume(static_cast<std::size_t>(i));
    result.bonds += static_cast<std::int64_t>(graph.first[u + 1] - graph.first[u]);
  }
  result.bonds /= 2;
  result.mean_radius /= static_cast<double>(result.members);

  double second_moment = 0;
  for (const std::int32_t u : walk.nodes) {
    const std::int32_t i = graph.particle[u];
    const auto x = unwrapped(u, graph, particles, domain, walk);
    double squared = own_gyration(particles, static_cast<std::size_t>(i));
    for (int axis = 0; axis < 3; ++axis) {
      const double from_centre = x[axis] - moment[axis] / result.mass;
      squared += from_centre * from_centre;
    }
    second_moment += particles.mass[i] * squared;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  result.radius_of_gyration = result.spanning() ? nan : std::sqrt(second_moment / result.mass);
  const double* origin = particles.motion.row(graph.particle[walk.nodes.front()]);
  for (int axis = 0; axis < 3; ++axis) {
    result.centre[axis] = result.spans[axis] ? nan : wrapped(origin[axis] + moment[axis] / result.mass, axis, domain);
  }
  return result;
}

}  // namespace

Agglomerates find_agglomerates(const Particles& particles, const Domain& domain, std::span<const Bond> bonds) {
  Agglomerates result;
  result.label.assign(particles.size(), -1);
  result.size.assign(particles.size(), 1);
  const BondGraph graph = bond_graph(particles, bonds);
  Walk walk;
  walk.image.resize(graph.particle.size());
  walk.seen.assign(graph.particle.size(), 0);
  for (std::size_t start = 0; start < graph.particle.size(); ++start) {
    if (walk.seen[start]) continue;
    walk_from(static_cast<std::int32_t>(start), graph, particles, domain, walk);
    const Agglomerate found = measure(graph, particles, domain, walk);
    for (const std::int32_t u : walk.nodes) {
      result.label[graph.particle[u]] = found.id;
      result.size[graph.particle[u]] = static_cast<std::int32_t>(found.members);
    }
    result.list.push_back(found);
  }
  return result;
}

}  // namespace scree
