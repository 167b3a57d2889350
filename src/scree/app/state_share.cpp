#include "scree/app/state_share.h"

#include <utility>

#include "scree/base/copy_bytes.h"
#include "scree/base/hash.h"
#include "scree/mpi/together.h"

namespace scree {
namespace {

template <class T>
ArrayView view_of_table(const std::vector<T>& table, std::uint64_t columns) {
  return array_view(table.data(), table.size() / columns, columns);
}

/// Puts a slab of a table that `owner` keeps alive.
void put_in_order(Archive& out, const std::vector<std::string>& names, const std::vector<ArrayView>& columns,
                  const std::vector<RowKey>& keys, std::shared_ptr<const void> owner, const Ranks& ranks) {
  Slab slab = slab_of(columns, keys, ranks);
  if (!slab.owner) slab.owner = std::move(owner);
  out.put_shared(names, slab);
}

/// Puts the particles; returns how many there are on all ranks.
std::int64_t put_particles(Archive& out, Particles particles, const Ranks& ranks) {
  const auto p = std::make_shared<const Particles>(std::move(particles));
  std::vector<std::string> names;
  std::vector<ArrayView> columns;
  std::vector<RowKey> keys;
  for (std::size_t i = 0; i < p->size(); ++i) keys.push_back({p->id[i], 0});
  p->for_each_field([&](std::string_view name, const auto& column, Travels, bool saved, auto) {
    if (!saved) return;
    names.emplace_back(name);
    columns.push_back(array_view(column.values.data(), p->size(), column.components));
  });
  put_in_order(out, names, columns, keys, p, ranks);
  return ranks.total(static_cast<std::int64_t>(p->size()));
}

void put_contacts(Archive& out, const std::string& of, KeyedContacts contacts, bool shaped, int scratch,
                  const Ranks& ranks) {
  const auto kept = std::make_shared<const KeyedContacts>(std::move(contacts));
  std::vector<std::string> names{of + "_ids", of + "_memory"};
  std::vector<ArrayView> columns{view_of_table(kept->ids, 2), view_of_table(kept->memory, 9)};
  if (of == "wall") {
    names.push_back(of + "_couple");
    columns.push_back(view_of_table(kept->couple, 3));
  }
  if (shaped) {
    names.push_back(of + "_shape");
    columns.push_back(view_of_table(kept->shape, static_cast<std::uint64_t>(scratch)));
  }
  std::vector<RowKey> keys;
  for (std::size_t c = 0; c < kept->ids.size(); c += 2) keys.push_back({kept->ids[c], kept->ids[c + 1]});
  put_in_order(out, names, columns, keys, kept, ranks);
}

void append(Bytes& to, const void* from, std::size_t size) {
  const std::size_t at = to.size();
  to.resize(at + size);
  copy_bytes(to.data() + at, from, size);
}

/// -0 and 0 are the same state.
void append_plain(Bytes& to, std::span<const double> values) {
  for (const double x : values) {
    const double plain = x + 0.0;
    append(to, &plain, sizeof plain);
  }
}

/// What the hash sees of this rank's particles.
Bytes particles_for_hash(const Archive& archive) {
  const bool shaped = archive.contains("form");
  const auto id = archive.get<std::int64_t>("id");
  const auto motion = archive.get<double>("motion", 8), spin = archive.get<double>("spin", 4);
  std::span<const std::int32_t> form;
  std::span<const double> orientation, momentum, heat;
  if (archive.contains("heat")) heat = archive.get<double>("heat", 2);
  if (shaped) {
    form = archive.get<std::int32_t>("form");
    orientation = archive.get<double>("orientation", 4);
    momentum = archive.get<double>("angular_momentum", 4);
  }
  Bytes out;
  for (std::size_t i = 0; i < id.size(); ++i) {
    append(out, &id[i], sizeof id[i]);
    append_plain(out, motion.subspan(8 * i, 8));
    append_plain(out, spin.subspan(4 * i, 4));
    if (!heat.empty()) append_plain(out, heat.subspan(2 * i, 2));
    if (!shaped) continue;
    append(out, &form[i], sizeof form[i]);
    append_plain(out, orientation.subspan(4 * i, 4));
    // The way of the surface, which comes after, serves the lists, which change nothing.
    append_plain(out, momentum.subspan(4 * i, 3));
  }
  return out;
}

}  // namespace

StateShare share_of(const ParticleSystem& system) {
  StateShare out;
  out.particles = system.particles;
  out.particles.resize_ghosts(0);
  out.pairs = keyed_pairs(system, [&](std::size_t c) { return counts_here(system, c); });
  out.walls = keyed_walls(system);
  return out;
}

Archive archive_of(StateShare share, const Ranks& ranks) {
  Archive out = std::move(share.head);
  const bool shaped = share.particles.shaped();
  out.set("particles", put_particles(out, std::move(share.particles), ranks));
  put_contacts(out, "pair", std::move(share.pairs), shaped, pair_scratch, ranks);
  put_contacts(out, "wall", std::move(share.walls), shaped, wall_scratch, ranks);
  return out;
}

std::string hash_of(const Archive& archive, double time, const Ranks& ranks) {
  Sha256 hash;
  const auto add = [&](const Bytes& mine) {
    show_in_turn(mine, ranks, [&](const Bytes& bytes) { hash.update(bytes.data(), bytes.size()); });
  };
  time += 0.0;
  hash.update(&time, sizeof time);
  add(particles_for_hash(archive));
  const bool shaped = archive.contains("form");
  for (const auto& [of, scratch] : {std::pair<std::string, int>{"pair", pair_scratch}, {"wall", wall_scratch}}) {
    Bytes ids, memory, shape;
    const auto keys = archive.get<std::int64_t>(of + "_ids", 2);
    append(ids, keys.data(), keys.size_bytes());
    append_plain(memory, archive.get<double>(of + "_memory", 9));
    if (shaped) append_plain(shape, archive.get<double>(of + "_shape", static_cast<std::uint64_t>(scratch)));
    for (const Bytes* mine : {&ids, &memory, &shape}) add(*mine);
  }
  return hash.hex();
}

}  // namespace scree
