#include "scree/particles/neighbours.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scree/particles/cell_grid.h"

namespace scree {
namespace {

using Bounds = std::array<std::array<double, 3>, 2>;

Bounds bounds_of(const Particles& particles) {
  Bounds b{{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}}};
  for (std::size_t i = 0; i < particles.held(); ++i)
    for (int k = 0; k < 3; ++k) {
      b[0][k] = std::min(b[0][k], particles.motion.row(i)[k]);
      b[1][k] = std::max(b[1][k], particles.motion.row(i)[k]);
    }
  return b;
}

double reach_of(const Particles& p, std::size_t i) { return p.motion.row(i)[lane::radius] + p.effect_excess[i]; }

/// Particles of one octave of size, in their own grid.
struct Level {
  double reach = 0;  // largest effect radius
  Buffer<std::int32_t> which;
  CellLattice lattice;
  CellMembers cells;
};

struct Levels {
  std::vector<Level> level;  // falling size
  Buffer<std::int32_t> level_of;
};

Levels sort_by_size(const Particles& p, const Domain& domain, double skin) {
  double largest = 0;
  for (std::size_t i = 0; i < p.held(); ++i) largest = std::max(largest, reach_of(p, i));
  constexpr int octaves = 64;
  const auto octave = [&](std::size_t i) {
    return std::min(octaves - 1, static_cast<int>(std::log2(largest / reach_of(p, i))));
  };
  std::array<std::size_t, octaves> members{};
  for (std::size_t i = 0; i < p.held(); ++i) ++members[octave(i)];
  Levels out;
  std::array<int, octaves> place{};
  for (int o = 0; o < octaves; ++o)
    if (members[o]) {
      place[o] = static_cast<int>(out.level.size());
      out.level.emplace_back().which.resize(members[o]);
    }
  out.level_of.resize(p.held());
  std::vector<std::size_t> next(out.level.size(), 0);
  for (std::size_t i = 0; i < p.held(); ++i) {
    const int l = place[octave(i)];
    out.level_of[i] = l;
    out.level[l].which[next[l]++] = static_cast<std::int32_t>(i);
    out.level[l].reach = std::max(out.level[l].reach, reach_of(p, i));
  }
  const Bounds b = bounds_of(p);
  for (Level& l : out.level) {
    l.lattice = CellLattice(domain, b[0], b[1], 2 * l.reach + skin, 2 * static_cast<std::int64_t>(l.which.size()) + 64);
    l.cells = sort_into_cells(l.lattice, p.motion.values.data(), 8, l.which);
  }
  return out;
}

/// Calls found(j) for every partner j that particle i is responsible for: partners of its own level stored later, and
/// all partners of the levels of larger particles.
template <class Found>
void search(const Particles& p, const Domain& domain, double skin, const Levels& levels, std::int32_t i,
            Found&& found) {
  const double* xi = p.motion.row(i);
  const std::int32_t owners = static_cast<std::int32_t>(p.size());
  const int own = levels.level_of[i];
  for (int m = 0; m <= own; ++m) {
    const Level& level = levels.level[m];
    level.lattice.for_each_run(xi, reach_of(p, i) + level.reach + skin, [&](std::int64_t c0, std::int64_t c1) {
      for (std::int32_t k = level.cells.first[c0]; k < level.cells.first[c1]; ++k) {
        const std::int32_t j = level.cells.member[k];
        if ((m == own && j <= i) || std::min(i, j) >= owners) continue;
        const double* xj = p.motion.row(j);
        double d2 = 0;
        for (int a = 0; a < 3; ++a) {
          const double d = domain.nearest(a, xj[a] - xi[a]);
          d2 += d * d;
        }
        const double range = reach_of(p, i) + reach_of(p, j) + skin;
        if (d2 < range * range && (xi[lane::inverse_mass] > 0 || xj[lane::inverse_mass] > 0)) found(j);
      }
    });
  }
}

struct Pair {
  std::int32_t owner, partner;
};

}  // namespace

std::vector<std::uint32_t> storage_order(const Particles& particles, const Domain& domain, double width) {
  if (particles.size() == 0) return {};
  Buffer<std::int32_t> all(particles.size());
  std::iota(all.begin(), all.end(), 0);
  const Bounds b = bounds_of(particles);
  const CellLattice lattice(domain, b[0], b[1], width, 4 * static_cast<std::int64_t>(particles.size()) + 64);
  const CellMembers cells = sort_into_cells(lattice, particles.motion.values.data(), 8, all);
  return {cells.member.begin(), cells.member.end()};
}

Candidates find_candidates(const Particles& particles, const Domain& domain, double skin) {
  const std::int32_t n = static_cast<std::int32_t>(particles.size());
  const std::int32_t held = static_cast<std::int32_t>(particles.held());
  Candidates out;
  out.first.resize(particles.size() + 1);
  out.owner.resize(candidate_padding);
  out.partner.resize(candidate_padding);
  if (n == 0) return out;
  const Levels levels = sort_by_size(particles, domain, skin);
  std::vector<std::vector<Pair>> found(omp_get_max_threads());
#pragma omp parallel for schedule(static)
  for (std::int32_t i = 0; i < held; ++i) {
    auto& mine = found[omp_get_thread_num()];
    search(particles, domain, skin, levels, i, [&](std::int32_t j) {
      mine.push_back({std::min(i, j), std::max(i, j)});
    });
  }
  for (const auto& list : found)
    for (const Pair& pair : list) ++out.first[pair.owner + 1];
  for (std::int32_t i = 0; i < n; ++i) out.first[i + 1] += out.first[i];
  out.count = out.first[n];
  out.owner.resize(out.count + candidate_padding);
  out.partner.resize(out.count + candidate_padding);
  Buffer<std::int32_t> next = out.first;
  for (const auto& list : found)
    for (const Pair& pair : list) {
      const std::int32_t c = next[pair.owner]++;
      out.owner[c] = pair.owner;
      out.partner[c] = pair.partner;
    }
#pragma omp parallel for schedule(static)
  for (std::int32_t i = 0; i < n; ++i)
    std::sort(out.partner.begin() + out.first[i], out.partner.begin() + out.first[i + 1]);
  return out;
}

}  // namespace scree
