// What is done with whole fields.
#pragma once

#include <utility>

#include "scree/fluid/mesh.h"

namespace scree {

/// Calls visit(place in the arrays, {i, j, k}) for every cell of fluid of this rank, on the threads of the team; each
/// must write only what is its own.
template <class Visit>
void for_each_fluid(const Mesh& m, Visit&& visit) {
  for_each_row(m, [&](int j, int k) {
    for (int i = 0; i < m.n[0]; ++i)
      if (const std::int64_t c = m.index(i, j, k); m.fluid[c] > 0) visit(c, std::array<int, 3>{i, j, k});
  });
}

/// The same, one after the other.
template <class Visit>
void for_each_fluid_in_turn(const Mesh& m, Visit&& visit) {
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i)
        if (const std::int64_t c = m.index(i, j, k); m.fluid[c] > 0) visit(c, std::array<int, 3>{i, j, k});
}

/// Calls visit(place in the arrays, place in space) for every cell of fluid of this rank, one after the other.
template <class Visit>
void for_each_cell(const Mesh& m, Visit&& visit) {
  for_each_fluid_in_turn(m, [&](std::int64_t c, const auto& at) { visit(c, m.centre(at[0], at[1], at[2])); });
}

/// Calls visit(place in the arrays, volume) for every cell of fluid of this rank, one after the other.
template <class Visit>
void for_each_volume(const Mesh& m, Visit&& visit) {
  for_each_fluid_in_turn(m, [&](std::int64_t c, const auto& at) { visit(c, m.cell_volume(at[0], at[1], at[2])); });
}

/// The present becomes the old one, the old one the older one, and the estimate of the next one takes its place.
inline void shift(Field& now, Field& old, Field& older, double ratio) {
  std::swap(older, old);
  std::swap(old, now);
  const std::int64_t size = static_cast<std::int64_t>(now.size());
  const double *x = old.data(), *y = older.data();
  double* out = now.data();
#pragma omp parallel for simd schedule(static)
  for (std::int64_t i = 0; i < size; ++i) out[i] = (1 + ratio) * x[i] - ratio * y[i];
}

}  // namespace scree
