// The order in which sweeps visit contacts: colours, so that threads may share the contacts of one.
#pragma once

#include <algorithm>
#include <cstdint>

#include "scree/particles/hard/contacts.h"

namespace scree {

/// Colours the contacts: of two contacts of one body that can move, the one whose key has the higher hash chooses
/// first, the lowest colour that is free (the outcome of Jones and Plassmann 1993 with these priorities). A function of
/// the keys alone, as random as the hash, so that sweeps have no preferred direction.
void colour_contacts(HardContacts& contacts);

/// Calls visit(k) for all places k of `order`, colour after colour; returns the largest of the numbers that it returns.
template <class Visit>
double visit_places(HardContacts& h, Visit&& visit) {
  double largest = 0;
  const std::size_t colours = h.colour_first.size() - 1;
  for (std::size_t k = 0; k < colours; ++k) {
    const std::int64_t begin = h.colour_first[k], end = h.colour_first[k + 1];
    const int hands = h.leftover && k + 1 == colours ? 1 : h.team.hands(static_cast<std::size_t>(end - begin));
#pragma omp parallel for schedule(static) reduction(max : largest) num_threads(hands) if (hands > 1)
    for (std::int64_t i = begin; i < end; ++i) largest = std::max(largest, visit(static_cast<std::size_t>(i)));
  }
  return largest;
}

/// The same with the contacts there.
template <class Visit>
double visit_all(HardContacts& h, Visit&& visit) {
  return visit_places(h, [&](std::size_t k) { return visit(h.all[h.order[k]]); });
}

}  // namespace scree
