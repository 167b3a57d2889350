#include "scree/output/slab.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "scree/base/copy_bytes.h"

namespace scree {
namespace {

constexpr std::int64_t slots = 4096;  // of equal width, among which major keys are counted

std::size_t row_bytes(const ArrayView& column) { return column.columns * element_size(column.element); }

/// Which rank gets the rows of a major key: equal parts, as far as whole slots allow.
class Partition {
 public:
  Partition(std::span<const RowKey> keys, const Ranks& ranks) : ranks_(ranks) {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> range{-far, -far};  // of -key and key; keys are far below 2^53
    for (const RowKey& key : keys) {
      range[0] = std::max(range[0], -static_cast<double>(key.major));
      range[1] = std::max(range[1], static_cast<double>(key.major));
    }
    ranks.find_largest(range);
    if (range[1] < -range[0]) return;
    lowest_ = static_cast<std::int64_t>(-range[0]);
    width_ = (static_cast<std::int64_t>(range[1]) - lowest_) / slots + 1;
    std::vector<std::int64_t> count(slots, 0);
    for (const RowKey& key : keys) ++count[slot_of(key)];
    ranks.add_up(count);
    total_ = std::accumulate(count.begin(), count.end(), std::int64_t{0});
    std::int64_t before = 0;
    for (const std::int64_t c : count) {
      rank_.push_back(static_cast<int>(before * ranks.count() / total_));
      before += c;
    }
  }

  int rank_of(const RowKey& key) const { return rank_[slot_of(key)]; }
  std::uint64_t total() const { return static_cast<std::uint64_t>(total_); }

 private:
  std::size_t slot_of(const RowKey& key) const { return static_cast<std::size_t>((key.major - lowest_) / width_); }

  const Ranks& ranks_;
  std::int64_t lowest_ = 0, width_ = 1, total_ = 0;
  std::vector<int> rank_;  // of each slot
};

/// Rows that have come together, column by column.
struct Rows {
  std::vector<RowKey> keys;
  std::vector<Bytes> columns;
};

void append(Bytes& to, const void* from, std::size_t size) {
  const std::size_t at = to.size();
  to.resize(at + size);
  copy_bytes(to.data() + at, from, size);
}

Bytes pack(std::span<const ArrayView> columns, std::span<const RowKey> keys, const std::vector<std::size_t>& rows) {
  Bytes out;
  const std::size_t count = rows.size();
  append(out, &count, sizeof count);
  for (const std::size_t row : rows) append(out, &keys[row], sizeof keys[row]);
  for (const ArrayView& column : columns) {
    const std::size_t width = row_bytes(column);
    const auto* from = static_cast<const std::byte*>(column.data);
    std::size_t at = out.size();
    out.resize(at + width * count);
    for (const std::size_t row : rows) {
      copy_bytes(out.data() + at, from + width * row, width);
      at += width;
    }
  }
  return out;
}

void unpack(const Bytes& message, std::span<const ArrayView> columns, Rows& to) {
  std::size_t count = 0;
  copy_bytes(&count, message.data(), sizeof count);
  const std::byte* from = message.data() + sizeof count;
  const std::size_t old = to.keys.size();
  to.keys.resize(old + count);
  copy_bytes(&to.keys[old], from, count * sizeof(RowKey));
  from += count * sizeof(RowKey);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    append(to.columns[k], from, row_bytes(columns[k]) * count);
    from += row_bytes(columns[k]) * count;
  }
}

/// Sends every row to the rank that wants it.
Rows exchange(std::span<const ArrayView> columns, std::span<const RowKey> keys, const Partition& partition,
              const Ranks& ranks) {
  std::vector<std::vector<std::size_t>> to(static_cast<std::size_t>(ranks.count()));
  for (std::size_t row = 0; row < keys.size(); ++row)
    to[static_cast<std::size_t>(partition.rank_of(keys[row]))].push_back(row);
  std::vector<Message> outgoing;
  for (int r = 0; r < ranks.count(); ++r)
    if (!to[static_cast<std::size_t>(r)].empty())
      outgoing.push_back({r, pack(columns, keys, to[static_cast<std::size_t>(r)])});
  const std::vector<Message> incoming = ranks.deliver(outgoing);
  Rows out;
  out.columns.resize(columns.size());
  for (const Message& message : incoming) unpack(message.bytes, columns, out);
  return out;
}

/// Rows in the order of their keys, as a slab that owns them.
Slab sorted(std::span<const ArrayView> columns, std::span<const RowKey> keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  const auto kept = std::make_shared<std::vector<Bytes>>();
  Slab out;
  for (const ArrayView& column : columns) {
    const std::size_t width = row_bytes(column);
    const auto* from = static_cast<const std::byte*>(column.data);
    Bytes values(width * order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      copy_bytes(values.data() + width * k, from + width * order[k], width);
    kept->push_back(std::move(values));
    out.columns.push_back({column.element, order.size(), column.columns, kept->back().data()});
  }
  out.owner = kept;
  return out;
}

}  // namespace

std::pair<std::uint64_t, std::uint64_t> equal_part(std::uint64_t rows, const Ranks& ranks) {
  const auto before = [&](int rank) {
    return rows * static_cast<std::uint64_t>(rank) / static_cast<std::uint64_t>(ranks.count());
  };
  return {before(ranks.rank()), before(ranks.rank() + 1) - before(ranks.rank())};
}

Slab slab_of(std::span<const ArrayView> columns, std::span<const RowKey> keys, const Ranks& ranks) {
  Slab out;
  if (ranks.alone()) {
    if (std::is_sorted(keys.begin(), keys.end()))
      out.columns.assign(columns.begin(), columns.end());
    else
      out = sorted(columns, keys);
    out.total = keys.size();
    return out;
  }
  const Partition partition(keys, ranks);
  const Rows rows = exchange(columns, keys, partition, ranks);
  std::vector<ArrayView> views;
  for (std::size_t k = 0; k < columns.size(); ++k)
    views.push_back({columns[k].element, rows.keys.size(), columns[k].columns, rows.columns[k].data()});
  out = sorted(views, rows.keys);
  std::vector<std::int64_t> counts(static_cast<std::size_t>(ranks.count()), 0);
  counts[static_cast<std::size_t>(ranks.rank())] = static_cast<std::int64_t>(rows.keys.size());
  ranks.add_up(counts);
  out.first =
      static_cast<std::uint64_t>(std::accumulate(counts.begin(), counts.begin() + ranks.rank(), std::int64_t{0}));
  out.total = partition.total();
  return out;
}

Slab cut_into_chunks(const ArrayView& column, std::uint64_t first, std::uint64_t total, std::uint64_t rows,
                     const Ranks& ranks) {
  Slab out;
  out.total = total;
  if (ranks.alone()) {
    out.columns = {column};
    return out;
  }
  const std::uint64_t chunks = (total + rows - 1) / rows, count = static_cast<std::uint64_t>(ranks.count());
  const auto owner = [&](std::uint64_t row) { return row / rows * count / chunks; };
  const std::size_t width = row_bytes(column);
  std::vector<Message> outgoing;
  for (std::uint64_t from = 0; from < column.rows;) {
    const std::uint64_t rank = owner(first + from);
    std::uint64_t to = from;
    while (to < column.rows && owner(first + to) == rank)
      to = std::min(column.rows, ((first + to) / rows + 1) * rows - first);
    outgoing.push_back({static_cast<int>(rank), Bytes(width * (to - from))});
    copy_bytes(outgoing.back().bytes.data(), static_cast<const std::byte*>(column.data) + width * from,
               outgoing.back().bytes.size());
    from = to;
  }
  const auto values = std::make_shared<Bytes>();
  for (const Message& message : ranks.deliver(outgoing)) append(*values, message.bytes.data(), message.bytes.size());
  const std::uint64_t mine = static_cast<std::uint64_t>(ranks.rank());
  out.first = (mine * chunks + count - 1) / count * rows;  // of the first chunk that is ours
  out.columns = {{column.element, values->size() / width, column.columns, values->data()}};
  out.owner = values;
  return out;
}

}  // namespace scree
