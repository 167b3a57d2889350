#include "scree/fluid/halo.h"

#include <cstring>

namespace scree {
namespace {

/// The cells [from, from + layers) along axis a, over all that has been renewed of the other axes.
struct Slab {
  std::array<int, 3> low{}, high{};

  std::int64_t cells() const { return std::int64_t{high[0] - low[0]} * (high[1] - low[1]) * (high[2] - low[2]); }
};

Slab slab(const Mesh& m, int a, int from, int layers) {
  Slab s;
  for (int b = 0; b < 3; ++b) {
    // Axes are renewed in order: those before are complete with their ghosts.
    s.low[b] = b < a ? -Mesh::ghosts : 0;
    s.high[b] = m.n[b] + (b < a ? Mesh::ghosts : 0);
  }
  s.low[a] = from;
  s.high[a] = from + layers;
  return s;
}

template <class Copy>
void for_each_piece(const Mesh& m, const Slab& s, Copy&& copy) {
  for (int k = s.low[2]; k < s.high[2]; ++k)
    for (int j = s.low[1]; j < s.high[1]; ++j) copy(m.index(s.low[0], j, k), s.high[0] - s.low[0]);
}

Bytes pack(const Mesh& m, const Slab& s, std::span<Field* const> fields) {
  Bytes out(static_cast<std::size_t>(s.cells()) * fields.size() * sizeof(double));
  std::byte* to = out.data();
  for (const Field* field : fields)
    for_each_piece(m, s, [&](std::int64_t at, int n) {
      std::memcpy(to, field->data() + at, n * sizeof(double));
      to += n * sizeof(double);
    });
  return out;
}

void unpack(const Mesh& m, const Slab& s, const Bytes& bytes, std::span<Field* const> fields) {
  const std::byte* from = bytes.data();
  for (Field* field : fields)
    for_each_piece(m, s, [&](std::int64_t at, int n) {
      std::memcpy(field->data() + at, from, n * sizeof(double));
      from += n * sizeof(double);
    });
}

/// This rank alone has all cells along a periodic axis.
void wrap(const Mesh& m, int a, int layers, std::span<Field* const> fields) {
  const int n = m.n[a];
  for (int layer = 1; layer <= layers; ++layer)
    for (const int to : {-layer, n - 1 + layer}) {
      const int from = (to % n + n) % n;
      const std::int64_t step = (from - to) * m.stride[a];
      for (Field* field : fields) {
        double* f = field->data();
        for_each_piece(m, slab(m, a, to, 1), [&](std::int64_t at, int count) {
          for (int i = 0; i < count; ++i) f[at + i] = f[at + i + step];
        });
      }
    }
}

void swap_with_neighbours(const Mesh& m, const Ranks& ranks, int a, int layers, std::span<Field* const> fields) {
  const bool periodic = m.region->grid.periodic[a];
  const auto neighbour = [&](int way) {
    std::array<int, 3> place = m.place;
    place[a] += way;
    if (place[a] < 0 || place[a] >= m.blocks[a]) {
      if (!periodic) return -1;
      place[a] = (place[a] + m.blocks[a]) % m.blocks[a];
    }
    return rank_at(m.blocks, place);
  };
  const int below = neighbour(-1), above = neighbour(1);
  std::vector<Message> out, in;
  // Two neighbours may be one rank: what it sends first, from its lower end, belongs above.
  if (below >= 0) out.push_back({below, pack(m, slab(m, a, 0, layers), fields)});
  if (above >= 0) out.push_back({above, pack(m, slab(m, a, m.n[a] - layers, layers), fields)});
  const Slab over = slab(m, a, m.n[a], layers), under = slab(m, a, -layers, layers);
  const std::size_t bytes = static_cast<std::size_t>(over.cells()) * fields.size() * sizeof(double);
  if (above >= 0) in.push_back({above, Bytes(bytes)});
  if (below >= 0) in.push_back({below, Bytes(bytes)});
  ranks.swap(out, in);
  std::size_t next = 0;
  if (above >= 0) unpack(m, over, in[next++].bytes, fields);
  if (below >= 0) unpack(m, under, in[next].bytes, fields);
}

}  // namespace

void renew_ghosts(const Mesh& mesh, const Ranks& ranks, int layers, std::span<Field* const> fields) {
  for (int a = 0; a < 3; ++a) {
    if (mesh.blocks[a] > 1)
      swap_with_neighbours(mesh, ranks, a, layers, fields);
    else if (mesh.region->grid.periodic[a])
      wrap(mesh, a, layers, fields);
  }
}

}  // namespace scree
