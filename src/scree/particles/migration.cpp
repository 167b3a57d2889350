#include "scree/particles/migration.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "scree/base/error.h"
#include "scree/mpi/rows.h"

namespace scree {
namespace {

bool everything(Travels) { return true; }

template <class T>
void pack_table(const std::vector<T>& table, Bytes& to) {
  const std::size_t count = table.size(), at = to.size();
  to.resize(at + sizeof count + count * sizeof(T));
  std::memcpy(to.data() + at, &count, sizeof count);
  if (count > 0) std::memcpy(to.data() + at + sizeof count, table.data(), count * sizeof(T));
}

/// Appends the table at `from`; returns the place behind it.
template <class T>
const std::byte* unpack_table(std::vector<T>& table, const std::byte* from) {
  std::size_t count = 0;
  std::memcpy(&count, from, sizeof count);
  const std::size_t old = table.size();
  table.resize(old + count);
  if (count > 0) std::memcpy(table.data() + old, from + sizeof count, count * sizeof(T));
  return from + sizeof count + count * sizeof(T);
}

void pack_contacts(const KeyedContacts& contacts, Bytes& to) {
  pack_table(contacts.ids, to);
  pack_table(contacts.memory, to);
  pack_table(contacts.couple, to);
  pack_table(contacts.shape, to);
}

const std::byte* unpack_contacts(KeyedContacts& contacts, const std::byte* from) {
  from = unpack_table(contacts.ids, from);
  from = unpack_table(contacts.memory, from);
  from = unpack_table(contacts.couple, from);
  return unpack_table(contacts.shape, from);
}

/// Particles with the contacts they take part in.
struct Parcel {
  std::vector<std::int32_t> rows;
  Luggage luggage;
};

Bytes pack_parcel(const Particles& particles, const Parcel& parcel) {
  Bytes out;
  const std::size_t count = parcel.rows.size();
  out.resize(sizeof count);
  std::memcpy(out.data(), &count, sizeof count);
  pack_rows(particles, parcel.rows, everything, out);
  pack_contacts(parcel.luggage.pairs, out);
  pack_contacts(parcel.luggage.walls, out);
  return out;
}

/// Appends what has come to particles and luggage.
void unpack_parcel(const Bytes& parcel, Particles& particles, Luggage& luggage) {
  std::size_t count = 0;
  std::memcpy(&count, parcel.data(), sizeof count);
  const std::size_t first = particles.size();
  particles.resize(first + count);
  const std::byte* at = unpack_rows(particles, first, count, everything, parcel.data() + sizeof count);
  at = unpack_contacts(luggage.pairs, at);
  unpack_contacts(luggage.walls, at);
}

/// Who has read which ids, where all are in their order from rank to rank.
class Readers {
 public:
  Readers(const Particles& p, const Ranks& ranks) : lowest_(static_cast<std::size_t>(ranks.count()), -1) {
    if (p.size() > 0) lowest_[static_cast<std::size_t>(ranks.rank())] = static_cast<double>(p.id[0]);
    ranks.find_largest(lowest_);
  }

  int of(std::int64_t id) const {
    int found = 0;
    for (std::size_t r = 0; r < lowest_.size(); ++r)
      if (lowest_[r] >= 0 && lowest_[r] <= static_cast<double>(id)) found = static_cast<int>(r);
    return found;
  }

 private:
  std::vector<double> lowest_;  // of each rank; -1 if it has none
};

/// Sends contacts to the ranks that `wanted(row)` names for each, twice the same or none of them too.
template <class Wanted>
KeyedContacts send(const KeyedContacts& contacts, const Ranks& ranks, Wanted&& wanted) {
  std::vector<std::vector<std::size_t>> rows(static_cast<std::size_t>(ranks.count()));
  for (std::size_t c = 0; c < contacts.ids.size() / 2; ++c)
    for (const int rank : wanted(c)) {
      auto& to = rows[static_cast<std::size_t>(rank)];
      if (to.empty() || to.back() != c) to.push_back(c);
    }
  std::vector<Message> outgoing;
  for (int r = 0; r < ranks.count(); ++r) {
    const auto& to = rows[static_cast<std::size_t>(r)];
    if (to.empty()) continue;
    outgoing.push_back({r, {}});
    pack_contacts(rows_of(contacts, to), outgoing.back().bytes);
  }
  KeyedContacts out;
  for (const Message& message : ranks.deliver(outgoing)) unpack_contacts(out, message.bytes.data());
  return out;
}

}  // namespace

// Where a particle belongs knows who has read it: contacts go there first.
Luggage bring_home(ParticleSystem& s, const Luggage& read, const Blocks& blocks, const Ranks& ranks) {
  Particles& p = s.particles;
  const Readers readers(p, ranks);
  const std::vector<std::int64_t>&pair = read.pairs.ids, &wall = read.walls.ids;
  Luggage passing, home;
  passing.pairs = send(read.pairs, ranks, [&](std::size_t c) {
    return std::array{readers.of(pair[2 * c]), readers.of(pair[2 * c + 1])};
  });
  passing.walls = send(read.walls, ranks, [&](std::size_t c) { return std::array{readers.of(wall[2 * c])}; });
  const RowsById rows = rows_of_held(p);
  const auto owners = [&](std::span<const std::int64_t> ids) {
    std::vector<int> out;
    for (const std::int64_t id : ids)
      if (const auto row = rows.find(id); row != rows.end())
        out.push_back(blocks.owner(p.motion.row(static_cast<std::size_t>(row->second))));
    return out;
  };
  const auto ids_of = [](const KeyedContacts& contacts, std::size_t c, std::size_t count) {
    return std::span(contacts.ids).subspan(2 * c, count);
  };
  home.pairs =
      in_order_once(send(passing.pairs, ranks, [&](std::size_t c) { return owners(ids_of(passing.pairs, c, 2)); }));
  home.walls = send(passing.walls, ranks, [&](std::size_t c) { return owners(ids_of(passing.walls, c, 1)); });
  std::vector<std::vector<std::int32_t>> to(static_cast<std::size_t>(ranks.count()));
  for (std::size_t i = 0; i < p.size(); ++i)
    to[static_cast<std::size_t>(blocks.owner(p.motion.row(i)))].push_back(static_cast<std::int32_t>(i));
  std::vector<Message> outgoing;
  for (int r = 0; r < ranks.count(); ++r)
    if (auto& parcel = to[static_cast<std::size_t>(r)]; !parcel.empty())
      outgoing.push_back({r, pack_parcel(p, {std::move(parcel), {}})});
  Particles here = p.none_alike();
  for (const Message& message : ranks.deliver(outgoing)) unpack_parcel(message.bytes, here, home);
  p = std::move(here);
  s.contacts = with_no_memory({}, s.contacts);
  s.wall_contacts = {};
  return home;
}

Luggage keep_share(ParticleSystem& s, const Blocks& blocks, const Ranks& ranks) {
  Particles& p = s.particles;
  const auto here = [&](std::size_t i) { return blocks.owner(p.motion.row(i)) == ranks.rank(); };
  Luggage luggage;
  luggage.pairs = keyed_pairs(s, [&](std::size_t c) {
    return here(std::size_t(s.contacts.pairs.owner[c])) || here(std::size_t(s.contacts.pairs.partner[c]));
  });
  luggage.walls = keyed_walls(s, here);
  std::vector<std::uint32_t> own;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (here(i)) own.push_back(static_cast<std::uint32_t>(i));
  p.permute(own);
  p = Particles(p);  // columns keep their memory, a copy has only what it needs
  s.contacts = with_no_memory({}, s.contacts);
  s.wall_contacts = {};
  return luggage;
}

namespace {

/// Where each particle belongs; those marked in `gone` stay.
std::vector<int> owners_of(const Particles& p, const Blocks& blocks, int here, const std::vector<std::uint8_t>& gone) {
  std::vector<int> to(p.size(), here);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (gone.empty() || i >= gone.size() || !gone[i]) to[i] = blocks.owner(p.motion.row(i));
  return to;
}

/// Sends particles to the ranks in `to`, each with the luggage that `luggage_for(rank)` gives, and marks them in
/// `gone`; adds those that come.
template <class LuggageFor>
void send_off(Particles& p, const std::vector<int>& to, const Ranks& ranks, std::vector<std::uint8_t>& gone,
              Luggage& luggage, LuggageFor&& luggage_for) {
  std::vector<int> partners;
  for (const int rank : to)
    if (rank != ranks.rank()) partners.push_back(rank);
  std::sort(partners.begin(), partners.end());
  partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
  std::vector<Message> outgoing;
  for (const int partner : partners) {
    Parcel parcel;
    for (std::size_t i = 0; i < to.size(); ++i)
      if (to[i] == partner) parcel.rows.push_back(static_cast<std::int32_t>(i));
    parcel.luggage = luggage_for(partner);
    outgoing.push_back({partner, pack_parcel(p, parcel)});
  }
  const std::vector<Message> incoming = ranks.deliver(outgoing);
  if (!partners.empty()) gone.resize(p.size(), 0);
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i] != ranks.rank()) gone[i] = 1;
  for (const Message& message : incoming) unpack_parcel(message.bytes, p, luggage);
}

}  // namespace

void migrate(ParticleSystem& s, const Blocks& blocks, const Ranks& ranks, std::vector<std::uint8_t>& gone,
             Luggage& luggage) {
  const std::vector<int> to = owners_of(s.particles, blocks, ranks.rank(), gone);
  send_off(s.particles, to, ranks, gone, luggage, [&](int partner) {
    const auto goes = [&](std::size_t i) { return i < to.size() && to[i] == partner; };
    const Candidates& pairs = s.contacts.pairs;
    return Luggage{
        keyed_pairs(
            s, [&](std::size_t c) { return goes(std::size_t(pairs.owner[c])) || goes(std::size_t(pairs.partner[c])); }),
        keyed_walls(s, goes)};
  });
}

void migrate(Particles& p, const Luggage& leaving, const Blocks& blocks, const Ranks& ranks,
             std::vector<std::uint8_t>& gone, Luggage& luggage) {
  const std::vector<int> to = owners_of(p, blocks, ranks.rank(), gone);
  std::unordered_map<std::int64_t, int> rank_of;
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i] != ranks.rank()) rank_of[p.id[i]] = to[i];
  const auto of = [&](const KeyedContacts& contacts, int partner, int sides) {
    std::vector<std::size_t> rows;
    for (std::size_t c = 0; c < contacts.ids.size() / 2; ++c)
      for (int side = 0; side < sides; ++side) {
        const auto found = rank_of.find(contacts.ids[2 * c + static_cast<std::size_t>(side)]);
        if (found == rank_of.end() || found->second != partner) continue;
        rows.push_back(c);
        break;
      }
    return rows_of(contacts, rows);
  };
  send_off(p, to, ranks, gone, luggage, [&](int partner) {
    return Luggage{of(leaving.pairs, partner, 2), of(leaving.walls, partner, 1)};
  });
}

KeyedContacts gather_shared_pairs(const ParticleSystem& mine, const Ranks& ranks) {
  const std::size_t own = mine.particles.size();
  Bytes packed;
  pack_contacts(keyed_pairs(mine, [&](std::size_t c) { return std::size_t(mine.contacts.pairs.partner[c]) >= own; }),
                packed);
  KeyedContacts all;
  for (const Bytes& bytes : ranks.gather(packed)) unpack_contacts(all, bytes.data());
  return all;
}

void gather_system(const ParticleSystem& mine, const Ranks& ranks, ParticleSystem& whole) {
  const Candidates& pairs = mine.contacts.pairs;
  const Particles& p = mine.particles;
  const auto n = static_cast<std::int32_t>(p.size());
  Parcel parcel;
  parcel.rows.resize(p.size());
  std::iota(parcel.rows.begin(), parcel.rows.end(), 0);
  // A pair of two ranks is sent by that of the lower id.
  parcel.luggage.pairs = keyed_pairs(
      mine, [&](std::size_t c) { return pairs.partner[c] < n || p.id[pairs.owner[c]] < p.id[pairs.partner[c]]; });
  parcel.luggage.walls = keyed_walls(mine);
  const std::vector<Bytes> all = ranks.gather(pack_parcel(p, parcel));
  if (!ranks.root()) return;
  whole.domain = mine.domain;
  whole.laws = mine.laws;
  whole.materials = mine.materials;
  whole.walls = mine.walls;
  whole.forms = mine.forms;
  whole.vertices = mine.vertices;
  whole.hard = mine.hard;
  whole.particles = p.none_alike();
  Luggage luggage;
  for (const Bytes& bytes : all) unpack_parcel(bytes, whole.particles, luggage);
  whole.particles.permute(order_by_id(whole.particles));
  const RowsById rows = rows_of_held(whole.particles);
  whole.contacts = pairs_of(luggage.pairs, rows, mine.contacts.remembers_rolling, p.shaped());
  whole.wall_contacts = walls_of(luggage.walls, rows, whole.particles, mine.walls.size());
}

}  // namespace scree
