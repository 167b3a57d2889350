#include "scree/particles/system.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scree/base/audit.h"
#include "scree/particles/audit.h"
#include "scree/particles/migration.h"
#include "scree/particles/neighbours.h"
#include "scree/particles/reach.h"
#include "scree/particles/vertex_views.h"

namespace scree {
namespace {

double greatest_travel(const Particles& p, const Domain& domain, const Buffer<double>& from) {
  double greatest2 = 0;
  const std::int64_t n = static_cast<std::int64_t>(p.size());
#pragma omp parallel for schedule(static) reduction(max : greatest2) if (n >= 2 * least_share)
  for (std::int64_t i = 0; i < n; ++i) {
    double d2 = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = domain.nearest(k, p.motion.row(i)[k] - from[3 * i + k]);
      d2 += d * d;
    }
    greatest2 = std::max(greatest2, d2);
  }
  return std::sqrt(greatest2);
}

/// A list that lasts long costs candidates that do not touch in every step, a short one costs making: hold the balance.
/// The lists change no bits, so the skin may follow the motion.
void adapt_skin(ContactLists& lists, const ParticleSystem& s, double mean_radius) {
  if (lists.rebuilds == 0 || lists.passes == 0) return;
  const auto acts = [](std::uint8_t code) { return code != 0; };
  std::vector<std::int64_t> counts{
      static_cast<std::int64_t>(s.particles.size()), static_cast<std::int64_t>(s.contacts.pairs.count),
      static_cast<std::int64_t>(std::count_if(s.contacts.active.begin(), s.contacts.active.end(), acts))};
  lists.ranks.add_up(counts);
  if (counts[0] == 0) return;
  const double n = static_cast<double>(counts[0]);
  const double candidates = static_cast<double>(counts[1]) / n, acting = static_cast<double>(counts[2]) / n;
  // Measured, in nanoseconds per particle: making the lists, and looking at a candidate, which is dear where few share
  // a vector.
  const double making = (280 + 80 * candidates) / static_cast<double>(lists.passes);
  const double looking = (candidates - acting) * (7 + 16 / (1 + candidates));
  if (making > 1.5 * looking) lists.skin *= 1.4;
  if (looking > 1.5 * making) lists.skin /= 1.4;
  lists.skin = std::clamp(lists.skin, 0.08 * mean_radius, 1.0 * mean_radius);
}

/// How far apart bodies may be and still act on each other, and a first skin where there is none.
void measure_reach(ContactLists& lists, const ParticleSystem& s, const Sizes& sizes) {
  lists.margin = margin_of(s, sizes);
  if (lists.skin == 0) lists.skin = 0.1 * sizes.mean_radius;
}

/// Where carry_over() finds a particle that is gone.
constexpr std::int32_t nowhere = -1;

/// The new places of `count` particles that were put in order.
std::vector<std::int32_t> places_in(const std::vector<std::uint32_t>& order, std::size_t count) {
  std::vector<std::int32_t> place(count, nowhere);
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<std::int32_t>(i);
  return place;
}

/// Whether a pair belongs to the rank of the partner: that which has the lower id.
bool counts_elsewhere(const Particles& p, std::int32_t owner, std::int32_t partner) {
  return std::size_t(partner) >= p.size() && p.id[partner] < p.id[owner];
}

/// Those of the particles that are in the block of this rank.
Particles in_own_block(Particles p, const ContactLists& lists) {
  if (lists.ranks.alone()) return p;
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (lists.blocks.owner(p.motion.row(i)) == lists.ranks.rank()) rows.push_back(static_cast<std::uint32_t>(i));
  p.permute(rows);
  return p;
}

/// Puts the contacts that came with particles into the new lists; returns the new places of those that the old lists
/// name.
std::vector<std::int32_t> unpack_luggage(ParticleSystem& s, ContactLists& lists, PairContacts& pairs,
                                         WallContacts& walls) {
  const RowsById rows = rows_of_held(s.particles);
  std::vector<std::int32_t> identity(s.particles.held()), place;
  std::iota(identity.begin(), identity.end(), 0);
  keep_held(lists.luggage.pairs, rows);
  carry_over(pairs, pairs_of(lists.luggage.pairs, rows, pairs.remembers_rolling, pairs.remembers_shapes), identity);
  carry_over(walls, walls_of(lists.luggage.walls, rows, s.particles, s.walls.size()), identity);
  lists.luggage = {};
  for (const std::int64_t id : lists.listed_ids) {
    const auto found = rows.find(id);
    place.push_back(found == rows.end() ? nowhere : found->second);
  }
  lists.listed_ids.assign(s.particles.id.values.begin(), s.particles.id.values.end());
  lists.counted_elsewhere.clear();
  for (std::size_t c = 0; c < pairs.pairs.count; ++c)
    if (counts_elsewhere(s.particles, pairs.pairs.owner[c], pairs.pairs.partner[c]))
      lists.counted_elsewhere.push_back(static_cast<std::int32_t>(c));
  lists.ghosts_current = true;
  return place;
}

/// Moves particles between ranks so that each has those of its block, with equal shares of the work.
void change_owners(ParticleSystem& s, ContactLists& lists, std::vector<std::uint8_t>& gone) {
  const auto& first = s.contacts.pairs.first;
  std::vector<std::int32_t> load(s.particles.size(), 1);
  // A particle costs about as much to move as three candidates cost to look at.
  for (std::size_t i = 0; i < load.size() && i + 1 < first.size(); ++i) load[i] = 3 + first[i + 1] - first[i];
  balance(lists.blocks, s.domain, s.particles, load, lists.ranks);
  migrate(s, lists.blocks, lists.ranks, gone, lists.luggage);
}

/// Puts in order who is here from now on. Particles marked in `gone`, if it is not empty, are not; of those that come
/// each goes to the rank in whose block it is.
void make_lists(ParticleSystem& s, ContactLists& lists, const Team& team, std::vector<std::uint8_t> gone,
                const Particles& fresh, const Sizes& sizes) {
  Particles& p = s.particles;
  if (!gone.empty()) gone.resize(p.size());
  // The first time everybody is where he belongs, and his luggage is not to travel again.
  if (!lists.ranks.alone() && lists.made) change_owners(s, lists, gone);
  if (fresh.size() > 0) p.append(in_own_block(fresh, lists));
  // Cells of about a diameter keep neighbours in space close in memory.
  std::vector<std::uint32_t> order = storage_order(p, s.domain, 2 * sizes.mean_radius + lists.skin);
  if (!gone.empty()) std::erase_if(order, [&](std::uint32_t i) { return i < gone.size() && gone[i]; });
  const std::size_t before = p.size();
  p.permute(order);
  const std::size_t n = p.size();
  // Searches look from effect surface to effect surface; necks, which know nothing of these, reach beyond, and so does
  // what acts between shapes.
  const double reach = lists.skin + reach_beyond_effects(s, sizes);
  if (!lists.ranks.alone()) lists.halo = make_halo(p, lists.blocks, s.domain, sizes.effect_radius, reach, lists.ranks);
  PairContacts pairs = with_no_memory(find_candidates(p, s.domain, reach), s.contacts);
  WallContacts walls = find_wall_contacts(p, s.walls, reach);
  const std::vector<std::int32_t> place =
      lists.ranks.alone() ? places_in(order, before) : unpack_luggage(s, lists, pairs, walls);
  carry_over(pairs, s.contacts, place);
  carry_over(walls, s.wall_contacts, place);
  s.contacts = std::move(pairs);
  s.wall_contacts = std::move(walls);
  lists.plan = plan_sweep(s.contacts.pairs, s.wall_contacts, p, team.hands(n));
  lists.slots.slots.resize(slot_size(s) * std::size_t(lists.plan.slots));
  lists.slots.full = p.shaped() ? no_marks(lists.plan) : Buffer<std::uint8_t>();
  if (s.contacts.remembers_rolling && !p.shaped()) lists.slots.couples.resize(4 * std::size_t(lists.plan.slots));
  lists.listed_at.resize(3 * n);
  for (std::size_t i = 0; i < n; ++i) std::copy_n(p.motion.row(i), 3, &lists.listed_at[3 * i]);
}

/// By how much two particles, or a particle and a wall, may have approached since the lists were made [m].
double approached(const ContactLists& lists) {
  return lists.travelled + std::max(lists.travelled, lists.walls_travelled);
}

}  // namespace

double fastest_square(const Particles& p) {
  double fastest2 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double* v = p.motion.row(i) + lane::vx;
    fastest2 = std::max(fastest2, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  return fastest2;
}

std::size_t slot_size(const ParticleSystem& s) { return s.particles.shaped() ? shape_slot : sphere_slot; }

double longest_range(const ParticleSystem& s) {
  const Sizes sizes = sizes_of(s.particles);
  return 2 * sizes.radius + reach_beyond_bodies(s, sizes);
}

ContactLists prepare_lists(const ParticleSystem& s, double skin) {
  ContactLists lists;
  lists.kernels = sweep_kernels(s.laws, s.materials.count(), s.particles.shaped());
  for (const Form& form : s.forms) {
    lists.shapes.resize(lists.shapes.size() + 1);
    lists.shapes[lists.shapes.size() - 1] = form.shape;
  }
  if (s.vertices)
    for (const VertexBlocks& blocks : s.vertices->of_form) lists.vertices.push_back(view_of(blocks));
  lists.skin = skin;
  lists.adapts = skin == 0;
  measure_reach(lists, s, sizes_of(s.particles, lists.ranks));
  return lists;
}

namespace {

void renew_lists(ParticleSystem& s, ContactLists& lists, const Team& team, const std::vector<std::uint8_t>& gone,
                 const Particles& fresh) {
  const Sizes sizes = sizes_of(s.particles, lists.ranks, fresh);
  if (lists.adapts) adapt_skin(lists, s, sizes.mean_radius);
  measure_reach(lists, s, sizes);
  make_lists(s, lists, team, gone, fresh, sizes);
  if constexpr (auditing) audit_lists(s, lists);
  lists.travelled = lists.walls_travelled = 0;
  lists.passes = 0;
  ++lists.rebuilds;
  lists.made = true;
}

}  // namespace

bool refresh_lists(ParticleSystem& s, ContactLists& lists, const Team& team) {
  const int ranges = team.hands(s.particles.size());
  if (lists.made && static_cast<int>(lists.plan.ranges.size()) == ranges) {
    if (approached(lists) <= lists.skin) return false;
    // The sum of the fastest steps overestimates: most of the time nobody has really gone that far.
    lists.travelled = lists.ranks.largest(greatest_travel(s.particles, s.domain, lists.listed_at));
    if (1.25 * approached(lists) <= lists.skin) return false;
  }
  renew_lists(s, lists, team, {}, s.particles.none_alike());
  return true;
}

void forget_lists(const ParticleSystem& s, ContactLists& lists) {
  lists.plan.ranges.clear();
  lists.listed_ids.assign(s.particles.id.values.begin(), s.particles.id.values.end());
  lists.ghosts_current = true;
}

void update_ghosts(ParticleSystem& s, ContactLists& lists) {
  if (lists.ranks.alone() || lists.ghosts_current) return;
  renew_ghosts(s.particles, lists.halo, lists.ranks);
  lists.ghosts_current = true;
}

bool counts_here(const ParticleSystem& s, std::size_t c) {
  return !counts_elsewhere(s.particles, s.contacts.pairs.owner[c], s.contacts.pairs.partner[c]);
}

void change_population(ParticleSystem& s, ContactLists& lists, const std::vector<std::uint8_t>& gone,
                       const Particles& fresh, const Team& team) {
  renew_lists(s, lists, team, gone, fresh);
}

void note_travel(ContactLists& lists, double distance) {
  // Rounding in the sum must not hide a move.
  lists.travelled += distance * (1 + 1e-12);
  ++lists.passes;
}

void note_wall_travel(ContactLists& lists, double distance) { lists.walls_travelled += distance * (1 + 1e-12); }

SweepView view_of(ParticleSystem& s, ContactLists& lists, const sc_move& move, const sc_contact_time& time,
                  const sc_field* field) {
  Particles& p = s.particles;
  SweepView v{};
  v.motion = p.motion.values.data();
  v.spin = p.spin.values.data();
  v.effect_excess = p.effect_excess.values.data();
  v.material = p.material.values.data();
  v.image = p.image.values.data();
  v.loss = p.loss.values.data();
  v.work = p.work.values.data();
  v.impulse = p.impulse.values.data();
  v.angular_impulse = p.angular_impulse.values.data();
  v.drag_impulse = p.coupled() ? p.drag_impulse.values.data() : nullptr;
  if (p.shaped())
    v.shapes = {lists.shapes.data(),
                p.id.values.data(),
                p.form.values.data(),
                p.orientation.values.data(),
                p.angular_momentum.values.data(),
                p.inertia.values.data(),
                s.contacts.shape.data(),
                s.contacts.apart.data(),
                lists.slots.full.data(),
                lists.plan.mark_first.data(),
                lists.plan.mark.data(),
                lists.vertices.empty() ? nullptr : lists.vertices.data()};
  v.first = s.contacts.pairs.first.data();
  v.owner = s.contacts.pairs.owner.data();
  v.partner = s.contacts.pairs.partner.data();
  v.active = s.contacts.active.data();
  v.slide = s.contacts.slide.data();
  v.roll = s.contacts.remembers_rolling ? s.contacts.roll.data() : nullptr;
  WallContacts& w = s.wall_contacts;
  v.walls = {w.first.data(),
             w.wall.data(),
             w.active.data(),
             w.slide.data(),
             w.roll.data(),
             s.walls.faces.data(),
             s.walls.poses.data(),
             w.gap.data(),
             nullptr,
             p.shaped() ? w.shape.data() : nullptr};
  v.slot = lists.plan.slot.data();
  v.gather_first = lists.plan.gather_first.data();
  v.gather = lists.plan.gather.data();
  v.deferred = lists.plan.deferred.data();
  v.slots = lists.slots.slots.data();
  v.couples = s.contacts.remembers_rolling && !p.shaped() ? lists.slots.couples.data() : nullptr;
  v.laws = s.laws;
  v.law = s.materials.law.data();
  v.materials = s.materials.count();
  v.time = time;
  v.margin = lists.margin;
  for (int k = 0; k < 3; ++k) {
    v.period[k] = s.domain.period(k);
    v.half_period[k] = s.domain.half_period(k);
    v.low[k] = s.domain.low(k);
    v.high[k] = s.domain.high(k);
  }
  v.half_period[3] = std::numeric_limits<double>::infinity();
  v.shortest_period = s.domain.shortest_period();
  v.move = move;
  const sc_vec& g = move.gravity;
  v.field = field;
  v.book_gravity = !s.domain.any_periodic() && (g.x != 0 || g.y != 0 || g.z != 0);
  v.others = field || sc_dot(move.rotation, move.rotation) > 0;
  return v;
}

SweepFindings pass(ParticleSystem& s, ContactLists& lists, const SweepView& view) {
  if (lists.ranks.alone()) return sweep(lists.kernels, view, lists.plan);
  update_ghosts(s, lists);
  lists.ghosts_current = false;
  std::vector<std::uint8_t> acted;
  for (const std::int32_t c : lists.counted_elsewhere) acted.push_back(s.contacts.active[c]);
  SweepFindings found = sweep(lists.kernels, view, lists.plan);
  for (std::size_t k = 0; k < acted.size(); ++k) {
    const std::size_t c = std::size_t(lists.counted_elsewhere[k]);
    if (!s.contacts.active[c]) continue;
    --found.contacts;
    if (acted[k]) continue;
    --found.impacts;
    found.impact_speed -= static_cast<std::int64_t>(s.contacts.slide[4 * c + 3] / speed_quantum);
  }
  return found;
}

}  // namespace scree
