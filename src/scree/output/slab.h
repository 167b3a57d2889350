// Tables whose rows lie on several ranks, brought into one order of which every rank has a part.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "scree/mpi/ranks.h"
#include "scree/output/element.h"

namespace scree {

/// Rows `first` and following of `total`, column by column. `owner` keeps the values alive where they are not the
/// caller's.
struct Slab {
  std::vector<ArrayView> columns;
  std::uint64_t first = 0, total = 0;
  std::shared_ptr<const void> owner;
};

/// First row and number of rows of this rank's equal part of a table.
std::pair<std::uint64_t, std::uint64_t> equal_part(std::uint64_t rows, const Ranks& ranks);

/// The order of a row among all rows; rows of equal keys lie on one rank and stay in their order.
struct RowKey {
  std::int64_t major = 0, minor = 0;
  auto operator<=>(const RowKey&) const = default;
};

/// Rows of columns of equal length, each with its key, in the order of the keys. Every rank gets about as many, those
/// with one major key together; rank by rank they follow each other. Of one process in order already the columns stay
/// where they are, which is the caller's. To be called by all ranks, with columns of the same kinds.
Slab slab_of(std::span<const ArrayView> columns, std::span<const RowKey> keys, const Ranks& ranks);

/// The part of a slab's column that chunks of `rows` rows want: each chunk is a whole on one rank, chunks in turn.
Slab cut_into_chunks(const ArrayView& column, std::uint64_t first, std::uint64_t total, std::uint64_t rows,
                     const Ranks& ranks);

}  // namespace scree
