#include "scree/mpi/together.h"

#include <bit>

#include "scree/base/copy_bytes.h"

namespace scree {

std::string text_of_root(const std::string& mine, const Ranks& ranks) {
  if (ranks.alone()) return mine;
  std::vector<Message> outgoing;
  for (int r = 1; ranks.root() && r < ranks.count(); ++r) {
    outgoing.push_back({r, Bytes(mine.size())});
    copy_bytes(outgoing.back().bytes.data(), mine.data(), mine.size());
  }
  const std::vector<Message> incoming = ranks.deliver(outgoing);
  if (ranks.root()) return mine;
  const Bytes& said = incoming.front().bytes;
  return {reinterpret_cast<const char*>(said.data()), said.size()};
}

void show_in_turn(const Bytes& mine, const Ranks& ranks, const std::function<void(const Bytes&)>& look) {
  if (ranks.root()) look(mine);
  if (ranks.alone()) return;
  std::vector<std::int64_t> sizes(static_cast<std::size_t>(ranks.count()), 0);
  sizes[static_cast<std::size_t>(ranks.rank())] = static_cast<std::int64_t>(mine.size());
  ranks.add_up(sizes);
  if (!ranks.root()) {
    std::vector<Message> none;
    return ranks.swap({{0, mine}}, none);
  }
  for (int r = 1; r < ranks.count(); ++r) {
    std::vector<Message> incoming{{r, Bytes(static_cast<std::size_t>(sizes[static_cast<std::size_t>(r)]))}};
    ranks.swap({}, incoming);
    look(incoming.front().bytes);
  }
}

// Pairs of ranks add, then pairs of pairs: the root has as many messages as there are doublings.
void add_up_exactly(std::span<ExactSum> mine, const Ranks& ranks) {
  const std::size_t size = mine.size_bytes();
  for (int step = 1; step < ranks.count(); step *= 2) {
    std::vector<Message> incoming;
    if (ranks.rank() & step) {
      Message message{ranks.rank() - step, Bytes(size)};
      copy_bytes(message.bytes.data(), mine.data(), size);
      return ranks.swap({message}, incoming);
    }
    if (ranks.rank() + step >= ranks.count()) continue;
    incoming.push_back({ranks.rank() + step, Bytes(size)});
    ranks.swap({}, incoming);
    for (std::size_t k = 0; k < mine.size(); ++k) {
      ExactSum theirs;
      copy_bytes(static_cast<void*>(&theirs), incoming.front().bytes.data() + k * sizeof theirs, sizeof theirs);
      mine[k].add(theirs);
    }
  }
}

double everywhere(ExactSum mine, const Ranks& ranks) {
  add_up_exactly({&mine, 1}, ranks);
  return std::bit_cast<double>(ranks.of_root(std::bit_cast<std::int64_t>(mine.value())));
}

}  // namespace scree
