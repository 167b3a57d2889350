#include "scree/particles/hard/telling.h"

#include <algorithm>
#include <numeric>

namespace scree {

Telling tell_of_all(const Halo& halo) {
  Telling out;
  out.own = halo.rows;
  for (const Message& message : halo.outgoing) out.outgoing.push_back({message.rank, {}});
  for (std::size_t k = 0; k < halo.incoming.size(); ++k) {
    out.incoming.push_back({halo.incoming[k].rank, {}});
    out.copies.emplace_back(halo.count[k]);
    std::iota(out.copies[k].begin(), out.copies[k].end(), static_cast<std::int32_t>(halo.first[k]));
  }
  return out;
}

int owner_of_copy(const Halo& halo, std::int32_t row) {
  const auto behind = std::upper_bound(halo.first.begin(), halo.first.end(), static_cast<std::size_t>(row));
  return halo.incoming[static_cast<std::size_t>(behind - halo.first.begin()) - 1].rank;
}

}  // namespace scree
