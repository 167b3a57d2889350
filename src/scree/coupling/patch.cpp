#include "scree/coupling/patch.h"

#include "scree/base/copy_bytes.h"

namespace scree {
namespace {

/// Calls visit(i, j, k, cells in the row) for the rows of a box.
template <class Visit>
void for_each_row_of(const CellBox& box, Visit&& visit) {
  if (box.empty()) return;
  for (int k = box.low[2]; k < box.high[2]; ++k)
    for (int j = box.low[1]; j < box.high[1]; ++j) visit(box.low[0], j, k, box.high[0] - box.low[0]);
}

/// A box, and room for numbers of its cells.
Bytes parcel(const CellBox& box, std::size_t bytes_per_cell) {
  const std::size_t cells = box.empty() ? 0 : static_cast<std::size_t>(box.cells());
  Bytes out(sizeof box + cells * bytes_per_cell);
  copy_bytes(out.data(), &box, sizeof box);
  return out;
}

CellBox box_of(const Bytes& bytes) {
  CellBox box;
  copy_bytes(&box, bytes.data(), sizeof box);
  return box;
}

void add(const CellBox& part, const Deposits& from, Deposits& to) {
  for_each_row_of(part, [&](int i, int j, int k, int n) {
    const std::int64_t* x = &from.values[static_cast<std::size_t>(from.offset(i, j, k))];
    std::int64_t* y = &to.values[static_cast<std::size_t>(to.offset(i, j, k))];
    for (int e = 0; e < n * from.width; ++e) y[e] += x[e];
  });
}

/// Values of a box within the cells of this rank, cell by cell.
void read(const Mesh& m, const CellBox& part, const std::vector<const Field*>& fields, double* to) {
  for_each_row_of(part, [&](int i, int j, int k, int n) {
    const std::int64_t at = m.index(i - m.box.low[0], j - m.box.low[1], k - m.box.low[2]);
    for (std::size_t f = 0; f < fields.size(); ++f)
      for (int e = 0; e < n; ++e) to[static_cast<std::size_t>(e) * fields.size() + f] = (*fields[f])[at + e];
    to += static_cast<std::size_t>(n) * fields.size();
  });
}

void put(const CellBox& part, const double* from, CellValues& to) {
  for_each_row_of(part, [&](int i, int j, int k, int n) {
    copy_bytes(&to.values[static_cast<std::size_t>(to.offset(i, j, k))], from, sizeof(double) * n * to.width);
    from += static_cast<std::size_t>(n) * to.width;
  });
}

}  // namespace

CellBox CellExchange::part_of(int rank) const {
  const auto& b = mesh_.blocks;
  return share_of_grid(mesh_.region->grid, b, {rank % b[0], rank / b[0] % b[1], rank / b[0] / b[1]});
}

Deposits CellExchange::collect(const Deposits& mine) const {
  Deposits sum;
  sum.shape(mesh_.box, mine.width);
  std::vector<Message> out;
  const std::size_t per_cell = sizeof(std::int64_t) * static_cast<std::size_t>(mine.width);
  for (int r = 0; r < ranks_.count(); ++r) {
    const CellBox part = common(mine.box, part_of(r));
    if (part.empty()) continue;
    if (r == ranks_.rank()) {
      add(part, mine, sum);
      continue;
    }
    Bytes bytes = parcel(part, per_cell);
    std::byte* to = bytes.data() + sizeof part;
    for_each_row_of(part, [&](int i, int j, int k, int n) {
      copy_bytes(to, &mine.values[static_cast<std::size_t>(mine.offset(i, j, k))], per_cell * n);
      to += per_cell * n;
    });
    out.push_back({r, std::move(bytes)});
  }
  if (ranks_.alone()) return sum;
  for (const Message& m : ranks_.deliver(out)) {
    Deposits part;
    part.shape(box_of(m.bytes), mine.width);
    copy_bytes(part.values.data(), m.bytes.data() + sizeof(CellBox), part.values.size() * sizeof(std::int64_t));
    add(part.box, part, sum);
  }
  return sum;
}

CellValues CellExchange::fetch(const CellBox& box, const std::vector<const Field*>& fields) const {
  CellValues out;
  out.shape(box, static_cast<int>(fields.size()));
  std::vector<Message> wanted;
  const CellBox own = common(box, mesh_.box);
  if (!own.empty()) {
    std::vector<double> values(static_cast<std::size_t>(own.cells()) * fields.size());
    read(mesh_, own, fields, values.data());
    put(own, values.data(), out);
  }
  if (ranks_.alone()) return out;
  for (int r = 0; r < ranks_.count(); ++r)
    if (const CellBox part = common(box, part_of(r)); r != ranks_.rank() && !part.empty())
      wanted.push_back({r, parcel(part, 0)});
  std::vector<Message> answers;
  for (const Message& m : ranks_.deliver(wanted)) {
    const CellBox part = box_of(m.bytes);
    Bytes bytes = parcel(part, sizeof(double) * fields.size());
    std::vector<double> values(static_cast<std::size_t>(part.cells()) * fields.size());
    read(mesh_, part, fields, values.data());
    copy_bytes(bytes.data() + sizeof part, values.data(), values.size() * sizeof(double));
    answers.push_back({m.rank, std::move(bytes)});
  }
  for (const Message& m : ranks_.deliver(answers)) {
    std::vector<double> values((m.bytes.size() - sizeof(CellBox)) / sizeof(double));
    copy_bytes(values.data(), m.bytes.data() + sizeof(CellBox), values.size() * sizeof(double));
    put(box_of(m.bytes), values.data(), out);
  }
  return out;
}

}  // namespace scree
