// Rows of particles as bytes, and back.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>

#include "scree/data/particles.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// Bytes of a row of a column.
template <class C>
inline constexpr std::size_t row_size = sizeof(typename std::remove_cvref_t<C>::value_type) *
                                        static_cast<std::size_t>(std::remove_cvref_t<C>::components);

/// Puts the fields of particles `rows` that `wanted(travels)` names at the end of `to`, field after field.
template <class Wanted>
void pack_rows(const Particles& particles, std::span<const std::int32_t> rows, Wanted&& wanted, Bytes& to) {
  particles.for_each_field([&](auto, const auto& column, Travels travels, auto...) {
    if (!wanted(travels)) return;
    constexpr std::size_t size = row_size<decltype(column)>;
    std::size_t at = to.size();
    to.resize(at + size * rows.size());
    for (const std::int32_t row : rows) {
      std::memcpy(to.data() + at, column.row(row), size);
      at += size;
    }
  });
}

/// Takes what pack_rows() put at `from` into `count` rows from `first` on; returns the place behind it.
template <class Wanted>
const std::byte* unpack_rows(Particles& particles, std::size_t first, std::size_t count, Wanted&& wanted,
                             const std::byte* from) {
  particles.for_each_field([&](auto, auto& column, Travels travels, auto...) {
    if (!wanted(travels)) return;
    constexpr std::size_t size = row_size<decltype(column)>;
    if (count > 0) std::memcpy(column.row(first), from, size * count);
    from += size * count;
  });
  return from;
}

/// Copies of the particles in `rows`, which may be copies of others, with all their fields.
inline Particles copies_of(const Particles& particles, const std::vector<std::int32_t>& rows) {
  const auto all = [](Travels) { return true; };
  Bytes bytes;
  pack_rows(particles, rows, all, bytes);
  Particles out = particles.none_alike();
  out.resize(rows.size());
  unpack_rows(out, 0, rows.size(), all, bytes.data());
  return out;
}

/// Bytes of one particle in pack_rows().
template <class Wanted>
std::size_t packed_size(const Particles& particles, Wanted&& wanted) {
  std::size_t size = 0;
  particles.for_each_field([&](auto, const auto& column, Travels travels, auto...) {
    if (wanted(travels)) size += row_size<decltype(column)>;
  });
  return size;
}

}  // namespace scree
