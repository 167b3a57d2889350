#include "scree/particles/hard/colours.h"

#include <bit>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

namespace scree {
namespace {

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

/// All contacts in the order in which they choose. Places follow keys, so they decide between equal hashes.
std::vector<std::uint32_t> order_of_choice(const HardContacts& h, Visits visits) {
  std::vector<std::uint32_t> turn(h.all.size());
  std::iota(turn.begin(), turn.end(), 0u);
  if (visits == Visits::by_key) return turn;
  std::vector<std::uint64_t> priority(h.all.size());
  for (std::size_t c = 0; c < priority.size(); ++c) priority[c] = priority_of(h.all[c]);
  std::sort(turn.begin(), turn.end(),
            [&](std::uint32_t x, std::uint32_t y) { return std::tuple(priority[x], x) > std::tuple(priority[y], y); });
  return turn;
}

/// Which colours the contacts of a body have, 64 to a word; few bodies have more than that.
class Taken {
 public:
  explicit Taken(std::size_t bodies) : first_(bodies, 0) {}

  std::size_t words(std::int32_t body) const {
    const auto found = more_.find(body);
    return found == more_.end() ? 1 : 1 + found->second.size();
  }
  std::uint64_t word(std::int32_t body, std::size_t w) const {
    if (w == 0) return first_[static_cast<std::size_t>(body)];
    return w < words(body) ? more_.at(body)[w - 1] : 0;
  }
  void take(std::int32_t body, std::uint32_t colour) {
    const std::uint64_t bit = std::uint64_t{1} << colour % 64;
    if (colour < 64) {
      first_[static_cast<std::size_t>(body)] |= bit;
      return;
    }
    std::vector<std::uint64_t>& words = more_[body];
    words.resize(std::max<std::size_t>(words.size(), colour / 64));
    words[colour / 64 - 1] |= bit;
  }

 private:
  std::vector<std::uint64_t> first_;
  std::unordered_map<std::int32_t, std::vector<std::uint64_t>> more_;
};

/// The colour of a contact whose bodies have those in the `words` words that used(k) gives: the lowest free one, or the
/// one after all of them.
template <class Used>
std::uint32_t choose(Visits visits, std::size_t words, Used&& used) {
  if (visits == Visits::by_key) {
    while (words > 0 && used(words - 1) == 0) --words;
    return words == 0 ? 0 : static_cast<std::uint32_t>(64 * words - std::countl_zero(used(words - 1)));
  }
  for (std::size_t w = 0; w < words; ++w)
    if (const std::uint64_t word = used(w); ~word) return static_cast<std::uint32_t>(64 * w + std::countr_one(word));
  return static_cast<std::uint32_t>(64 * words);
}

bool moves(const HardContacts& h, std::int32_t body) { return body >= 0 && h.bodies[body].inverse_mass > 0; }

std::vector<std::uint32_t> choose_alone(const HardContacts& h, Visits visits) {
  Taken taken(h.bodies.size());
  std::vector<std::uint32_t> colour(h.all.size());
  for (const std::uint32_t c : order_of_choice(h, visits)) {
    const std::int32_t bodies[2] = {h.all[c].a, h.all[c].b};
    std::size_t words = 0;
    for (const std::int32_t body : bodies)
      if (moves(h, body)) words = std::max(words, taken.words(body));
    colour[c] = choose(visits, words, [&](std::size_t w) {
      std::uint64_t used = 0;
      for (const std::int32_t body : bodies)
        if (moves(h, body)) used |= taken.word(body, w);
      return used;
    });
    for (const std::int32_t body : bodies)
      if (moves(h, body)) taken.take(body, colour[c]);
  }
  return colour;
}

/// The same on several ranks. Each knows all contacts of its own bodies. Where it is the turn of a contact for the own
/// body, the other rank is told the colours that this one has; a contact chooses when it is its turn on both sides.
class CommonChoice {
 public:
  CommonChoice(const HardContacts& h, const Halo& halo, Visits visits)
      : h_(h),
        halo_(halo),
        visits_(visits),
        taken_(h.bodies.size()),
        colour_(h.all.size(), none),
        told_(h.all.size(), 0) {
    queue_.resize(h.own);
    next_.assign(h.own, 0);
    for (const std::uint32_t c : order_of_choice(h, visits)) {
      for (const std::int32_t body : {h.all[c].a, h.all[c].b})
        if (is_own(body) && moves(h, body)) queue_[static_cast<std::size_t>(body)].push_back(c);
      waiting_.push_back(c);
    }
    left_ = static_cast<std::int64_t>(h.all.size());
  }

  std::vector<std::uint32_t> run() {
    for (;;) {
      while (!waiting_.empty()) {
        const std::uint32_t c = waiting_.back();
        waiting_.pop_back();
        look_at(c);
      }
      std::vector<std::int64_t> counts{left_, static_cast<std::int64_t>(outgoing_.size())};
      h_.ranks.add_up(counts);
      if (counts[0] == 0) return std::move(colour_);
      if (counts[1] == 0) throw std::logic_error("two ranks do not agree on who touches whom");
      hear();
    }
  }

 private:
  static constexpr std::uint32_t none = ~0u;

  bool is_own(std::int32_t body) const { return body >= 0 && static_cast<std::size_t>(body) < h_.own; }
  bool is_shared(const HardContact& c) const { return !c.at_wall() && !(is_own(c.a) && is_own(c.b)); }

  /// Whether all contacts of an own body that choose before this one have done so.
  bool is_turn(std::int32_t body, std::uint32_t c) const {
    if (!is_own(body) || !moves(h_, body)) return true;
    const auto at = static_cast<std::size_t>(body);
    return queue_[at][next_[at]] == c;
  }

  void look_at(std::uint32_t c) {
    const HardContact& contact = h_.all[c];
    if (colour_[c] != none || !is_turn(contact.a, c) || !is_turn(contact.b, c)) return;
    const auto heard = heard_.find(c);
    if (is_shared(contact) && !told_[c]) say(c);
    if (is_shared(contact) && heard == heard_.end()) return;
    std::size_t words = heard != heard_.end() ? heard->second.size() : 0;
    for (const std::int32_t body : {contact.a, contact.b})
      if (is_own(body) && moves(h_, body)) words = std::max(words, taken_.words(body));
    colour_[c] = choose(visits_, words, [&](std::size_t w) {
      std::uint64_t used = heard != heard_.end() && w < heard->second.size() ? heard->second[w] : 0;
      for (const std::int32_t body : {contact.a, contact.b})
        if (is_own(body) && moves(h_, body)) used |= taken_.word(body, w);
      return used;
    });
    --left_;
    for (const std::int32_t body : {contact.a, contact.b}) {
      if (!is_own(body) || !moves(h_, body)) continue;
      taken_.take(body, colour_[c]);
      const auto& queue = queue_[static_cast<std::size_t>(body)];
      if (const std::size_t next = ++next_[static_cast<std::size_t>(body)]; next < queue.size())
        waiting_.push_back(queue[next]);
    }
  }

  /// Tells the other rank of a contact: its key, and which colours the own body has.
  void say(std::uint32_t c) {
    const HardContact& contact = h_.all[c];
    const std::int32_t own = is_own(contact.a) ? contact.a : contact.b,
                       copy = is_own(contact.a) ? contact.b : contact.a;
    std::vector<std::uint64_t> words{static_cast<std::uint64_t>(contact.low), static_cast<std::uint64_t>(contact.high)};
    words.push_back(moves(h_, own) ? taken_.words(own) : 0);
    for (std::size_t w = 0; w < words[2]; ++w) words.push_back(taken_.word(own, w));
    std::vector<std::uint64_t>& all = outgoing_[owner_of_copy(halo_, copy)];
    all.insert(all.end(), words.begin(), words.end());
    told_[c] = 1;
  }

  void hear() {
    std::vector<Message> outgoing;
    for (const auto& [rank, words] : outgoing_) {
      outgoing.push_back({rank, Bytes(sizeof(std::uint64_t) * words.size())});
      std::memcpy(outgoing.back().bytes.data(), words.data(), outgoing.back().bytes.size());
    }
    outgoing_.clear();
    for (const Message& message : h_.ranks.deliver(outgoing)) {
      std::vector<std::uint64_t> words(message.bytes.size() / sizeof(std::uint64_t));
      std::memcpy(words.data(), message.bytes.data(), message.bytes.size());
      for (auto at = words.begin(); at != words.end();) {
        const std::uint32_t c = place_of(static_cast<std::int64_t>(at[0]), static_cast<std::int64_t>(at[1]));
        const auto count = static_cast<std::ptrdiff_t>(at[2]);
        heard_[c].assign(at + 3, at + 3 + count);
        waiting_.push_back(c);
        at += 3 + count;
      }
    }
  }

  std::uint32_t place_of(std::int64_t low, std::int64_t high) const {
    const auto found = std::lower_bound(
        h_.all.begin(), h_.all.end(), std::tuple(false, low, high),
        [](const HardContact& c, const auto& key) { return std::tuple(c.at_wall(), c.low, c.high) < key; });
    if (found == h_.all.end() || found->low != low || found->high != high)
      throw std::logic_error("another rank tells of a contact that is none here");
    return static_cast<std::uint32_t>(found - h_.all.begin());
  }

  const HardContacts& h_;
  const Halo& halo_;
  Visits visits_;
  Taken taken_;
  std::vector<std::uint32_t> colour_;
  std::vector<std::uint8_t> told_;
  std::vector<std::vector<std::uint32_t>> queue_;  // of every own body: its contacts in the order of choice
  std::vector<std::size_t> next_;                  // place in the queue of that whose turn it is
  std::vector<std::uint32_t> waiting_;             // contacts to look at
  std::unordered_map<std::uint32_t, std::vector<std::uint64_t>> heard_;  // colours of the other body
  std::map<int, std::vector<std::uint64_t>> outgoing_;
  std::int64_t left_ = 0;
};

void put_in_order(const std::vector<std::uint32_t>& colour, HardContacts& h) {
  const std::uint32_t colours = colour.empty() ? 0 : 1 + *std::max_element(colour.begin(), colour.end());
  h.colour_first.assign(colours + 1, 0);
  for (const std::uint32_t k : colour) ++h.colour_first[k + 1];
  for (std::uint32_t k = 0; k < colours; ++k) h.colour_first[k + 1] += h.colour_first[k];
  h.order.resize(colour.size());
  std::vector<std::uint32_t> next = h.colour_first;
  for (std::uint32_t c = 0; c < colour.size(); ++c) h.order[next[colour[c]]++] = c;
}

/// Before a colour, both bodies of every contact of two ranks in it, in the order of the contacts.
Telling before_colour(const HardContacts& h, const Halo& halo, std::size_t colour) {
  std::map<int, std::pair<std::vector<std::int32_t>, std::vector<std::int32_t>>> found;
  for (std::uint32_t k = h.colour_first[colour]; k < h.colour_first[colour + 1]; ++k) {
    const HardContact& c = h.all[h.order[k]];
    const auto own = static_cast<std::int32_t>(h.own);
    if (c.at_wall() || (c.a < own && c.b < own)) continue;
    auto& [mine, copies] = found[owner_of_copy(halo, std::max(c.a, c.b))];
    mine.push_back(std::min(c.a, c.b));
    copies.push_back(std::max(c.a, c.b));
  }
  Telling out;
  for (auto& [rank, rows] : found) {
    out.outgoing.push_back({rank, {}});
    out.incoming.push_back({rank, {}});
    out.own.push_back(std::move(rows.first));
    out.copies.push_back(std::move(rows.second));
  }
  return out;
}

}  // namespace

void colour_contacts(HardContacts& h, const Halo& halo, Visits visits) {
  put_in_order(h.ranks.alone() ? choose_alone(h, visits) : CommonChoice(h, halo, visits).run(), h);
  h.before_colour.clear();
  if (h.ranks.alone()) return;
  for (std::size_t k = 0; k + 1 < h.colour_first.size(); ++k) h.before_colour.push_back(before_colour(h, halo, k));
}

}  // namespace scree
