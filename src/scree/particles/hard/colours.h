// The order in which sweeps visit contacts: colours, so that threads may share the contacts of one.
#pragma once

#include <algorithm>
#include <cstdint>

#include "scree/particles/hard/contacts.h"

namespace scree {

/// How sweeps go through the contacts.
enum class Visits {
  coloured,  // as many as possible at once
  by_key     // each body's in the order of their keys, as if all were visited one after the other in that order
};

/// Colours the contacts. Visits::coloured: of two contacts of one body that can move, the one whose key has the higher
/// hash chooses first, the lowest colour that is free (the outcome of Jones and Plassmann 1993 with these priorities).
/// A function of the keys of all ranks alone, as random as the hash, so that sweeps have no preferred direction.
/// Visits::by_key: contacts choose in the order of their keys, the colour after those of both bodies.
void colour_contacts(HardContacts& contacts, const Halo& halo, Visits visits);

/// Calls visit(k) for all places k of `order`, colour after colour, and before(colour) before each; returns the largest
/// of the numbers that visit() returns.
template <class Before, class Visit>
double visit_places(HardContacts& h, Before&& before, Visit&& visit) {
  double largest = 0;
  const std::size_t colours = h.colour_first.size() - 1;
  for (std::size_t k = 0; k < colours; ++k) {
    before(k);
    const std::int64_t begin = h.colour_first[k], end = h.colour_first[k + 1];
    const int hands = h.team.hands(static_cast<std::size_t>(end - begin));
#pragma omp parallel for schedule(static) reduction(max : largest) num_threads(hands) if (hands > 1)
    for (std::int64_t i = begin; i < end; ++i) largest = std::max(largest, visit(static_cast<std::size_t>(i)));
  }
  return largest;
}

/// The same where a visit needs nothing of copies of other ranks' bodies.
template <class Visit>
double visit_places(HardContacts& h, Visit&& visit) {
  return visit_places(
      h, [](std::size_t) {}, visit);
}

/// The same with copies whose velocities are those of their originals before their contact is visited; the largest of
/// this rank's numbers.
template <class Visit>
double sweep_places(HardContacts& h, Visit&& visit) {
  const auto before = [&h](std::size_t colour) {
    if (!h.before_colour.empty()) tell_velocities(h, h.before_colour[colour]);
  };
  return visit_places(h, before, visit);
}

/// visit_places() with the contacts there.
template <class Visit>
double visit_all(HardContacts& h, Visit&& visit) {
  return visit_places(h, [&](std::size_t k) { return visit(h.all[h.order[k]]); });
}

}  // namespace scree
