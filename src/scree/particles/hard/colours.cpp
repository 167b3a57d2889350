#include "scree/particles/hard/colours.h"

#include <bit>
#include <numeric>
#include <tuple>

namespace scree {
namespace {

constexpr std::uint32_t colours = 64;  // the last one for what the others do not take

/// Steele, Lea and Flood 2014 (SplitMix64): a bijection that scatters.
std::uint64_t scatter(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t priority_of(const HardContact& c) {
  const auto part = [](std::int64_t x) { return static_cast<std::uint64_t>(x); };
  return scatter(scatter(scatter(part(c.low)) ^ part(c.high)) ^ (c.at_wall() ? 1 : 0));
}

}  // namespace

void colour_contacts(HardContacts& h) {
  const std::size_t count = h.all.size();
  std::vector<std::uint64_t> priority(count);
  for (std::size_t c = 0; c < count; ++c) priority[c] = priority_of(h.all[c]);
  std::vector<std::uint32_t> turn(count);
  std::iota(turn.begin(), turn.end(), 0u);
  // Places follow keys, so they decide between equal hashes.
  std::sort(turn.begin(), turn.end(),
            [&](std::uint32_t x, std::uint32_t y) { return std::tuple(priority[x], x) > std::tuple(priority[y], y); });
  std::vector<std::uint64_t> taken(h.bodies.size(), 0);
  std::vector<std::uint32_t> colour(count);
  const auto moves = [&](std::int32_t body) { return body >= 0 && h.bodies[body].inverse_mass > 0; };
  for (const std::uint32_t c : turn) {
    const HardContact& contact = h.all[c];
    std::uint64_t used = std::uint64_t{1} << (colours - 1);
    for (const std::int32_t body : {contact.a, contact.b})
      if (moves(body)) used |= taken[body];
    colour[c] = std::min<std::uint32_t>(static_cast<std::uint32_t>(std::countr_one(used)), colours - 1);
    if (colour[c] == colours - 1) continue;
    for (const std::int32_t body : {contact.a, contact.b})
      if (moves(body)) taken[body] |= std::uint64_t{1} << colour[c];
  }
  std::vector<std::uint32_t> members(colours + 1, 0);
  for (const std::uint32_t k : colour) ++members[k + 1];
  h.leftover = members[colours] > 0;
  for (std::uint32_t k = 0; k < colours; ++k) members[k + 1] += members[k];
  h.order.resize(count);
  std::vector<std::uint32_t> next = members;
  for (std::uint32_t c = 0; c < count; ++c) h.order[next[colour[c]]++] = c;
  // Colours fill from the first.
  std::uint32_t last = h.leftover ? colours : 0;
  while (last < colours && members[last] < count) ++last;
  members.resize(last + 1);
  h.colour_first = std::move(members);
}

}  // namespace scree
