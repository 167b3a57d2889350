#include "scree/particles/keyed_contacts.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "scree/base/error.h"

namespace scree {
namespace {

/// Order of rows of two numbers.
std::vector<std::size_t> order_of(const std::vector<std::int64_t>& keys) {
  std::vector<std::size_t> order(keys.size() / 2);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    // Several places of one face stay in their order.
    return std::tuple(keys[2 * a], keys[2 * a + 1], a) < std::tuple(keys[2 * b], keys[2 * b + 1], b);
  });
  return order;
}

/// The rows of a table that `order` names, in that order.
template <class T>
std::vector<T> picked(const std::vector<T>& table, std::size_t rows, const std::vector<std::size_t>& order) {
  std::vector<T> out;
  if (table.empty()) return out;
  const std::size_t width = table.size() / rows;
  out.reserve(width * order.size());
  for (const std::size_t k : order) out.insert(out.end(), &table[width * k], &table[width * k] + width);
  return out;
}

/// The memory of contact c of a list that holds pairs or walls. Adding 0 makes -0 to 0: the sign of nothing would tell
/// which of the partners owned the pair.
template <class Contacts>
void append_memory(std::vector<double>& to, const Contacts& contacts, std::size_t c, double sign) {
  const auto &slide = contacts.slide, &roll = contacts.roll;
  for (int k = 0; k < 3; ++k) to.push_back(sign * slide[4 * c + k] + 0.0);
  to.push_back(slide[4 * c + 3]);
  for (int k = 0; k < 3; ++k) to.push_back(roll.empty() ? 0.0 : sign * roll[4 * c + k] + 0.0);
  to.push_back(roll.empty() ? 0.0 : roll[4 * c + 3]);
  to.push_back(contacts.active[c] == contact_code(true, true) ? 1.0 : 0.0);
}

}  // namespace

KeyedContacts keyed_pairs(const ParticleSystem& s, const std::function<bool(std::size_t)>& wanted) {
  KeyedContacts out;
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (!s.contacts.active[c] || (wanted && !wanted(c))) continue;
    const std::int64_t a = s.particles.id[s.contacts.pairs.owner[c]], b = s.particles.id[s.contacts.pairs.partner[c]];
    out.ids.push_back(std::min(a, b));
    out.ids.push_back(std::max(a, b));
    append_memory(out.memory, s.contacts, c, a < b ? 1 : -1);
    if (!s.contacts.remembers_shapes) continue;
    const double* shape = &s.contacts.shape[pair_memory * c];
    out.shape.insert(out.shape.end(), shape, shape + pair_scratch);
  }
  return in_order(out);
}

KeyedContacts keyed_walls(const ParticleSystem& s, const std::function<bool(std::size_t)>& wanted) {
  KeyedContacts out;
  for (std::size_t p = 0; p + 1 < s.wall_contacts.first.size(); ++p) {
    if (wanted && !wanted(p)) continue;
    for (std::int32_t w = s.wall_contacts.first[p]; w < s.wall_contacts.first[p + 1]; ++w) {
      if (!s.wall_contacts.active[w]) continue;
      out.ids.push_back(s.particles.id[p]);
      out.ids.push_back(s.wall_contacts.wall[w]);
      append_memory(out.memory, s.wall_contacts, w, 1);
      const double* couple = &s.wall_contacts.couple[3 * std::size_t(w)];
      out.couple.insert(out.couple.end(), couple, couple + 3);
      if (s.wall_contacts.shape.empty()) continue;
      const double* shape = &s.wall_contacts.shape[wall_memory * std::size_t(w)];
      out.shape.insert(out.shape.end(), shape, shape + wall_scratch);
    }
  }
  return in_order(out);
}

KeyedContacts rows_of(const KeyedContacts& contacts, const std::vector<std::size_t>& rows) {
  const std::size_t count = contacts.ids.size() / 2;
  return {picked(contacts.ids, count, rows), picked(contacts.memory, count, rows), picked(contacts.couple, count, rows),
          picked(contacts.shape, count, rows)};
}

KeyedContacts in_order(const KeyedContacts& contacts) { return rows_of(contacts, order_of(contacts.ids)); }

KeyedContacts in_order_once(KeyedContacts contacts) {
  const std::vector<std::int64_t>& ids = contacts.ids;
  std::vector<std::size_t> order = order_of(ids);
  const auto same = [&](std::size_t a, std::size_t b) {
    return ids[2 * a] == ids[2 * b] && ids[2 * a + 1] == ids[2 * b + 1];
  };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  return rows_of(contacts, order);
}

RowsById rows_of_held(const Particles& p) {
  RowsById row;
  row.reserve(p.held());
  for (std::size_t i = 0; i < p.held(); ++i) row[p.id[i]] = static_cast<std::int32_t>(i);
  return row;
}

void keep_held(KeyedContacts& pairs, const RowsById& rows) {
  std::vector<std::size_t> held;
  for (std::size_t c = 0; c < pairs.ids.size() / 2; ++c)
    if (rows.contains(pairs.ids[2 * c]) && rows.contains(pairs.ids[2 * c + 1])) held.push_back(c);
  pairs = rows_of(pairs, held);
}

PairContacts pairs_of(const SavedContacts& saved, const RowsById& row, bool rolling, bool shaped) {
  const auto& ids = saved.ids;
  const auto &memory = saved.memory, &shape = saved.shape;
  const std::size_t count = ids.size() / 2;
  PairContacts out;
  out.remembers_rolling = rolling;
  out.remembers_shapes = shaped;
  out.pairs.count = count;
  out.pairs.owner.resize(count);
  out.pairs.partner.resize(count);
  out.active.resize(count);
  out.slide.resize(4 * count);
  if (rolling) out.roll.resize(4 * count);
  if (shaped) out.shape.resize(pair_memory * count);
  for (std::size_t c = 0; c < count; ++c) {
    const auto a = row.find(ids[2 * c]), b = row.find(ids[2 * c + 1]);
    if (a == row.end() || b == row.end()) throw InputError("a contact names a particle that is not there");
    out.pairs.owner[c] = a->second;
    out.pairs.partner[c] = b->second;
    out.active[c] = contact_code(true, memory[9 * c + 8] != 0);
    std::copy_n(&memory[9 * c], 4, &out.slide[4 * c]);
    if (rolling) std::copy_n(&memory[9 * c + 4], 4, &out.roll[4 * c]);
    if (shaped) std::copy_n(&shape[pair_scratch * c], pair_scratch, &out.shape[pair_memory * c]);
  }
  return out;
}

WallContacts walls_of(const SavedContacts& saved, const RowsById& row, const Particles& p, std::size_t faces) {
  const auto& [ids, memory, couple, shape] = saved;
  std::vector<std::vector<std::size_t>> mine(p.size());
  for (std::size_t c = 0; c < ids.size() / 2; ++c) {
    const auto found = row.find(ids[2 * c]);
    if (found == row.end() || ids[2 * c + 1] >= static_cast<std::int64_t>(faces))
      throw InputError("a contact names a particle or a wall that is not there");
    mine[found->second].push_back(c);
  }
  WallContacts out;
  out.first.resize(p.size() + 1);
  out.wall.resize(ids.size() / 2);
  out.active.resize(ids.size() / 2);
  out.slide.resize(2 * ids.size());
  out.roll.resize(2 * ids.size());
  out.couple.resize(3 * (ids.size() / 2));
  out.gap.resize(ids.size() / 2);
  if (!shape.empty()) out.shape.resize(wall_memory * (ids.size() / 2));
  std::int32_t next = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const std::size_t c : mine[i]) {
      out.wall[next] = static_cast<std::int32_t>(ids[2 * c + 1]);
      out.active[next] = contact_code(true, memory[9 * c + 8] != 0);
      std::copy_n(&memory[9 * c], 4, &out.slide[4 * std::size_t(next)]);
      std::copy_n(&memory[9 * c + 4], 4, &out.roll[4 * std::size_t(next)]);
      if (!couple.empty()) std::copy_n(&couple[3 * c], 3, &out.couple[3 * std::size_t(next)]);
      if (!shape.empty())
        std::copy_n(&shape[wall_scratch * c], wall_scratch, &out.shape[wall_memory * std::size_t(next)]);
      ++next;
    }
    out.first[i + 1] = next;
  }
  return out;
}

}  // namespace scree
