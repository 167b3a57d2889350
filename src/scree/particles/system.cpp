#include "scree/particles/system.h"

#include <algorithm>
#include <cmath>

#include "scree/base/audit.h"
#include "scree/particles/audit.h"
#include "scree/particles/neighbours.h"
#include "scree/particles/vertex_views.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

double largest_radius(const Particles& p) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, p.motion.row(i)[lane::radius]);
  return largest;
}

double mean_radius(const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p.motion.row(i)[lane::radius];
  return p.size() ? sum / static_cast<double>(p.size()) : 0;
}

double largest_effect_excess(const Particles& p) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, p.effect_excess[i]);
  return largest;
}

/// The largest effective radius of a contact. Against a wall that of a sphere is its own.
double largest_contact_radius(const ParticleSystem& s) {
  double largest = largest_radius(s.particles);
  if (!s.particles.shaped()) return largest;
  for (std::size_t i = 0; i < s.particles.size(); ++i)
    largest = std::max(largest, sc_largest_contact_radius(s.particles.radius_by_volume(i)));
  return largest;
}

/// How far a JKR neck may be drawn out [m].
double longest_neck(const ParticleSystem& s) {
  if (s.laws.cohesion != SC_COHESION_JKR) return 0;
  const double radius = largest_contact_radius(s);
  double longest = 0;
  for (const sc_pair_law& law : s.materials.law) longest = std::max(longest, sc_longest_neck(s.laws, law, radius));
  return longest;
}

/// How far apart two shapes may be over how far their overlap is below zero. A gap g makes the growth distance at least
/// 1 + g/(R_A + R_B) with the bounding radii, and the overlap goes with that times the support of both bodies along
/// some direction, which is no less than the sum of the radii of the spheres inside.
double gap_over_overlap(const ParticleSystem& s) {
  double most = 1;
  for (const Form& form : s.forms) most = std::max(most, 1 / form.shape.inscribed);
  return (1 + 1e-9) * most;
}

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
void adapt_skin(ContactLists& lists, const ParticleSystem& s) {
  if (lists.rebuilds == 0 || lists.passes == 0 || s.particles.size() == 0) return;
  const double n = static_cast<double>(s.particles.size());
  const auto acts = [](std::uint8_t code) { return code != 0; };
  const auto acting = static_cast<double>(std::count_if(s.contacts.active.begin(), s.contacts.active.end(), acts));
  const double candidates = static_cast<double>(s.contacts.pairs.count) / n;
  // Measured, in nanoseconds per particle: making the lists, and looking at a candidate, which is dear where few share
  // a vector.
  const double making = (280 + 80 * candidates) / static_cast<double>(lists.passes);
  const double looking = (candidates - acting / n) * (7 + 16 / (1 + candidates));
  if (making > 1.5 * looking) lists.skin *= 1.4;
  if (looking > 1.5 * making) lists.skin /= 1.4;
  const double radius = mean_radius(s.particles);
  lists.skin = std::clamp(lists.skin, 0.08 * radius, 1.0 * radius);
}

/// How far apart bodies may be and still act on each other, and a first skin where there is none.
void measure_reach(ContactLists& lists, const ParticleSystem& s) {
  lists.margin = std::max(reach_beyond_bodies(s), 2 * largest_effect_excess(s.particles));
  if (lists.skin == 0) lists.skin = 0.1 * mean_radius(s.particles);
}

/// Where carry_over() finds a particle that is gone.
constexpr std::int32_t nowhere = -1;

/// Particles marked in `gone`, if it is not empty, are left out from here on.
void make_lists(ParticleSystem& s, ContactLists& lists, const Team& team, const std::vector<std::uint8_t>& gone) {
  Particles& p = s.particles;
  // Cells of about a diameter keep neighbours in space close in memory.
  std::vector<std::uint32_t> order = storage_order(p, s.domain, 2 * mean_radius(p) + lists.skin);
  if (!gone.empty()) std::erase_if(order, [&](std::uint32_t i) { return i < gone.size() && gone[i]; });
  std::vector<std::int32_t> place(p.size(), nowhere);
  p.permute(order);
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) place[order[i]] = static_cast<std::int32_t>(i);
  // Searches look from effect surface to effect surface; necks, which know nothing of these, reach beyond, and so does
  // what acts between shapes.
  const double between_effects = s.laws.cohesion == SC_COHESION_LINEAR ? 2 * largest_effect_excess(p) : 0;
  const double reach = lists.skin + (reach_beyond_bodies(s) - between_effects);
  s.contacts = carry_over(find_candidates(p, s.domain, reach), s.contacts, place);
  WallContacts walls = find_wall_contacts(p, s.walls, reach);
  carry_over(walls, s.wall_contacts, place);
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

double reach_beyond_bodies(const ParticleSystem& s) {
  const double overlap =
      s.laws.cohesion == SC_COHESION_LINEAR ? 2 * largest_effect_excess(s.particles) : longest_neck(s);
  return s.particles.shaped() ? gap_over_overlap(s) * overlap : overlap;
}

std::size_t slot_size(const ParticleSystem& s) { return s.particles.shaped() ? shape_slot : sphere_slot; }

double longest_range(const ParticleSystem& s) { return 2 * largest_radius(s.particles) + reach_beyond_bodies(s); }

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
  measure_reach(lists, s);
  return lists;
}

namespace {

void renew_lists(ParticleSystem& s, ContactLists& lists, const Team& team, const std::vector<std::uint8_t>& gone) {
  make_lists(s, lists, team, gone);
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
    lists.travelled = greatest_travel(s.particles, s.domain, lists.listed_at);
    if (1.25 * approached(lists) <= lists.skin) return false;
  }
  if (lists.adapts) adapt_skin(lists, s);
  renew_lists(s, lists, team, {});
  return true;
}

void change_population(ParticleSystem& s, ContactLists& lists, const std::vector<std::uint8_t>& gone,
                       const Particles& fresh, const Team& team) {
  if (lists.adapts) adapt_skin(lists, s);
  s.particles.append(fresh);
  measure_reach(lists, s);
  renew_lists(s, lists, team, gone);
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

}  // namespace scree
