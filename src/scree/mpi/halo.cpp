#include "scree/mpi/halo.h"

#include "scree/mpi/rows.h"

namespace scree {
namespace {

bool in_every_step(Travels travels) { return travels == Travels::always; }
bool with_copies(Travels travels) { return travels != Travels::on_migration; }

}  // namespace

Halo make_halo(Particles& particles, const Blocks& blocks, const Domain& domain, double largest, double skin,
               const Ranks& ranks) {
  Halo halo;
  for (const int partner : blocks.near_ranks(ranks.rank(), 2 * largest + skin, domain)) {
    std::vector<std::int32_t> rows;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const double* m = particles.motion.row(i);
      const double range = m[lane::radius] + particles.effect_excess[i] + largest + skin;
      if (blocks.is_near(m, partner, range, domain)) rows.push_back(static_cast<std::int32_t>(i));
    }
    if (rows.empty()) continue;
    Message message{partner, {}};
    pack_rows(particles, rows, with_copies, message.bytes);
    halo.outgoing.push_back(std::move(message));
    halo.rows.push_back(std::move(rows));
  }
  const std::vector<Message> found = ranks.deliver(halo.outgoing);
  const std::size_t full = packed_size(particles, with_copies), moving = packed_size(particles, in_every_step);
  std::size_t next = particles.size();
  for (const Message& message : found) {
    halo.first.push_back(next);
    halo.count.push_back(message.bytes.size() / full);
    halo.incoming.push_back({message.rank, Bytes(moving * halo.count.back())});
    next += halo.count.back();
  }
  particles.resize_ghosts(next - particles.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    unpack_rows(particles, halo.first[k], halo.count[k], with_copies, found[k].bytes.data());
  return halo;
}

Particles copies_everywhere(const Particles& particles, const std::vector<std::int32_t>& rows, const Ranks& ranks) {
  Bytes mine;
  pack_rows(particles, rows, with_copies, mine);
  std::vector<Message> outgoing;
  if (!rows.empty())
    for (int r = 0; r < ranks.count(); ++r) outgoing.push_back({r, mine});
  Particles out = particles.none_alike();
  const std::size_t size = packed_size(particles, with_copies);
  for (const Message& message : ranks.deliver(outgoing)) {
    const std::size_t first = out.size(), count = message.bytes.size() / size;
    out.resize(first + count);
    unpack_rows(out, first, count, with_copies, message.bytes.data());
  }
  return out;
}

void renew_ghosts(Particles& particles, Halo& halo, const Ranks& ranks) {
  for (std::size_t k = 0; k < halo.outgoing.size(); ++k) {
    halo.outgoing[k].bytes.clear();
    pack_rows(particles, halo.rows[k], in_every_step, halo.outgoing[k].bytes);
  }
  ranks.swap(halo.outgoing, halo.incoming);
  for (std::size_t k = 0; k < halo.incoming.size(); ++k)
    unpack_rows(particles, halo.first[k], halo.count[k], in_every_step, halo.incoming[k].bytes.data());
}

}  // namespace scree
