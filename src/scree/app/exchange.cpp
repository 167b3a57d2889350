#include "scree/app/exchange.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "scree/app/build_exchange.h"
#include "scree/app/build_particles.h"
#include "scree/base/error.h"
#include "scree/particles/insert_random.h"

namespace scree {
namespace {

/// Plain structs of eight-byte members, without gaps between them, as whole numbers, and back.
template <class T>
std::vector<std::int64_t> as_words(const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::int64_t) == 0);
  std::vector<std::int64_t> words(count * sizeof(T) / sizeof(std::int64_t));
  if (count > 0) std::memcpy(words.data(), values, count * sizeof(T));
  return words;
}

template <class T>
void from_words(const Archive& archive, const char* name, T* values, std::size_t count) {
  const auto words = archive.get<std::int64_t>(name);
  if (words.size() * sizeof(std::int64_t) != count * sizeof(T))
    throw InputError(archive.origin + ": wrong number of " + name +
                     ": it comes from another case or another version of the program");
  if (count > 0) std::memcpy(static_cast<void*>(values), words.data(), count * sizeof(T));
}

/// Tells before the run if the largest particles of a feed, turned as its first ones, are wider than the region.
void refuse_what_does_not_fit(const Feed& feed, const ParticleGroup& group, const InsertionSetting& setting) {
  const std::int64_t turns = group.shape.shape.is_sphere ? 1 : std::min<std::int64_t>(feed.total_count, 1000);
  for (std::int64_t number = 0; number < turns; ++number) {
    const Newcomer newcomer{static_cast<std::uint64_t>(number), max_diameter(group.sizes), {}};
    range_of_places(group, newcomer, body_of(group, feed.group, newcomer, setting), setting);
  }
}

}  // namespace

Exchange::Exchange(const Case& c, std::int64_t next_id)
    : every_(static_cast<std::int64_t>(c.simulation.exchange_every)),
      seed_(c.simulation.seed),
      feeds_(build_feeds(c)),
      states_(feeds_.size()),
      outlets_(build_outlets(c)),
      outlet_counts_(outlets_.size()),
      next_id_(next_id) {
  if (feeds_.empty()) return;
  const std::vector<ParticleGroup> all = build_groups(c, Takeover::skip);
  InsertionSetting setting;
  setting.domain = {c.domain.min, c.domain.max, c.domain.periodic};
  setting.seed = seed_;
  setting.forms = forms_of(all);
  for (const Feed& feed : feeds_) {
    groups_.push_back(all[feed.group]);
    refuse_what_does_not_fit(feed, groups_.back(), setting);
  }
}

std::vector<sc_region> Exchange::regions(const Domain& domain, double time) const {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<sc_region> out;
  for (const Outlet& outlet : outlets_) {
    sc_region r{{-far, -far, -far}, {far, far, far}};
    if (outlet.is_face) {
      (outlet.upper ? r.min : r.max)[outlet.axis] = (outlet.upper ? domain.max : domain.min)[outlet.axis];
    } else {
      std::copy_n(outlet.min.data(), 3, r.min);
      std::copy_n(outlet.max.data(), 3, r.max);
    }
    out.push_back(r);
  }
  InsertionSetting setting;
  setting.domain = domain;
  setting.seed = seed_;
  for (std::size_t f = 0; f < feeds_.size(); ++f) {
    const auto room = room_of_due({feeds_[f], groups_[f], setting, time, {}, {}}, states_[f]);
    if (!room) continue;
    sc_region r;
    for (int k = 0; k < 3; ++k) {
      r.min[k] = domain.periodic[k] ? -far : room->min[k];
      r.max[k] = domain.periodic[k] ? far : room->max[k];
    }
    out.push_back(r);
  }
  return out;
}

/// All ranks find the same newcomers: each of them looks at those of all that may be in the way.
Newcomers Exchange::newcomers(const ParticleSystem& system, const Ranks& ranks, Fields& fields, double time,
                              const std::vector<std::uint8_t>& gone, std::vector<FeedState>& states) const {
  InsertionSetting setting;
  setting.domain = system.domain;
  setting.walls = &system.walls;
  setting.seed = seed_;
  setting.forms = system.forms;
  setting.fluid = [&](const std::array<double, 3>& x) { return flow_velocity(fields, x.data(), time); };
  Newcomers out;
  out.particles = system.particles.none_alike();
  out.next_id = next_id_;
  for (std::size_t f = 0; f < feeds_.size(); ++f) {
    const auto near = in_the_way({feeds_[f], groups_[f], setting, time, system.particles, gone}, states[f]);
    if (!near) continue;
    const Particles present = copies_everywhere(system.particles, *near, ranks);
    feed({feeds_[f], groups_[f], setting, time, present, {}}, states[f], out);
  }
  return out;
}

/// Lets the particles marked in `taken` go; returns what they take away and how many each outlet takes, as bytes.
Bytes Exchange::take_out(ParticleSystem& system, ContactLists& lists, const std::vector<std::uint8_t>& taken,
                         const sc_field* field, const Moment& moment) const {
  Passage passage;
  std::vector<OutletCount> counts(outlets_.size());
  if (!taken.empty()) {
    let_out(system, lists, taken, moment, field, passage);
    for (std::size_t i = 0; i < system.particles.size(); ++i)
      if (taken[i]) {
        OutletCount& outlet = counts[taken[i] - 1];
        ++outlet.count;
        outlet.mass.add(system.particles.mass[i]);
      }
  }
  Bytes out(sizeof passage + counts.size() * sizeof(OutletCount));
  std::memcpy(out.data(), &passage, sizeof passage);
  if (!counts.empty()) std::memcpy(out.data() + sizeof passage, counts.data(), counts.size() * sizeof(OutletCount));
  return out;
}

/// Adds what take_out() gave on every rank.
void Exchange::enter_books(const std::vector<Bytes>& gone) {
  for (const Bytes& bytes : gone) {
    Passage passage;
    std::memcpy(static_cast<void*>(&passage), bytes.data(), sizeof passage);
    passage_.add(passage);
    for (std::size_t o = 0; o < outlet_counts_.size(); ++o) {
      OutletCount more;
      std::memcpy(static_cast<void*>(&more), bytes.data() + sizeof passage + o * sizeof more, sizeof more);
      outlet_counts_[o].count += more.count;
      outlet_counts_[o].mass.add(more.mass);
    }
  }
}

bool Exchange::run(ParticleSystem& system, ContactLists& lists, Fields& fields, const sc_field* field,
                   const Moment& moment, const Team& team) {
  update_ghosts(system, lists);
  const std::vector<std::uint8_t> taken = find_leavers(system.particles, system.domain, outlets_);
  std::vector<FeedState> states = states_;
  Newcomers coming = newcomers(system, lists.ranks, fields, moment.now, taken, states);
  const bool changed = !lists.ranks.all(taken.empty() && coming.particles.size() == 0);
  states_ = std::move(states);
  next_id_ = coming.next_id;
  if (!changed) return false;
  enter_books(lists.ranks.gather(take_out(system, lists, taken, field, moment)));
  Buffer<sc_field> around;
  const bool local = act_locally(fields);
  if (local) evaluate(fields, coming.particles, moment.now, lists.kernels, around);
  Passage let;
  let_in(coming.particles, system.domain, moment, local ? around.data() : nullptr, let);
  if (lists.ranks.root()) passage_.add(let);
  change_population(system, lists, taken, coming.particles, team);
  return true;
}

void Exchange::save(Archive& archive) const {
  archive.set("next_id", next_id_);
  if (!active()) return;
  archive.put("feeds", as_words(states_.data(), states_.size()));
  archive.put("outlets", as_words(outlet_counts_.data(), outlet_counts_.size()));
  archive.put("passage", as_words(&passage_, 1));
}

void Exchange::restore(const Archive& archive) {
  next_id_ = archive.integer("next_id");
  if (!active()) return;
  from_words(archive, "feeds", states_.data(), states_.size());
  from_words(archive, "outlets", outlet_counts_.data(), outlet_counts_.size());
  from_words(archive, "passage", &passage_, 1);
}

}  // namespace scree
