// How ranks keep each other's copies of bodies up to date within a step of the hard model.
//
// A contact of bodies of two ranks is computed by both of them. Before they visit it, each tells the other how its own
// body moves by then; both get the same bits.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "scree/mpi/halo.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// Own bodies of which others are told, and copies of which others tell.
struct Telling {
  std::vector<std::vector<std::int32_t>> own, copies;  // rows, of every message out and in
  std::vector<Message> outgoing, incoming;
};

/// Everybody who has copies elsewhere is told of.
Telling tell_of_all(const Halo& halo);

/// Lets every other rank have `width` numbers of each of its copies: read(own row, to) gives them, write(row of a copy,
/// from) takes them.
template <int width, class Read, class Write>
void tell(Telling& t, const Ranks& ranks, Read&& read, Write&& write) {
  if (t.outgoing.empty() && t.incoming.empty()) return;
  double numbers[width];
  for (std::size_t k = 0; k < t.outgoing.size(); ++k) {
    Bytes& bytes = t.outgoing[k].bytes;
    bytes.resize(sizeof numbers * t.own[k].size());
    std::byte* to = bytes.data();
    for (const std::int32_t row : t.own[k]) {
      read(row, numbers);
      std::memcpy(to, numbers, sizeof numbers);
      to += sizeof numbers;
    }
  }
  for (std::size_t k = 0; k < t.incoming.size(); ++k) t.incoming[k].bytes.resize(sizeof numbers * t.copies[k].size());
  ranks.swap(t.outgoing, t.incoming);
  for (std::size_t k = 0; k < t.incoming.size(); ++k) {
    const std::byte* from = t.incoming[k].bytes.data();
    for (const std::int32_t row : t.copies[k]) {
      std::memcpy(numbers, from, sizeof numbers);
      from += sizeof numbers;
      write(row, numbers);
    }
  }
}

/// Which rank the particle of a copy belongs to.
int owner_of_copy(const Halo& halo, std::int32_t row);

}  // namespace scree
