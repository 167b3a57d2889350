#include "scree/particles/feed.h"

#include <fmt/format.h>

#include <algorithm>

#include "scree/base/error.h"
#include "scree/particles/insert_check.h"
#include "scree/particles/insert_random.h"
#include "scree/particles/insert_region.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

/// The next particle of a feed, and when half of it is due.
struct Next {
  double diameter = 0, mass = 0;  // [m], [kg]
  double due = 0;                 // [s]
};

Next next_of(const FeedContext& k, const FeedState& state) {
  Next next;
  next.diameter = draw_diameter(k.group.sizes, k.setting.seed, k.feed.group, static_cast<std::uint64_t>(state.count));
  next.mass = k.group.density * sphere_volume(next.diameter);
  next.due = k.feed.from + (k.feed.mass_rate > 0 ? (state.mass + 0.5 * next.mass) / k.feed.mass_rate
                                                 : (static_cast<double>(state.count) + 0.5) / k.feed.number_rate);
  return next;
}

bool is_due(const Feed& feed, const FeedState& state, const Next& next, double time) {
  return state.count < feed.total_count && state.mass + 0.5 * next.mass <= feed.total_mass &&
         next.due <= std::min(time, feed.until);
}

void take_in(FeedState& state, const Next& next) {
  ++state.count;
  state.mass += next.mass;
  state.tries = 0;
}

/// Effect radii of those that are due, as many as can be looked at in one go.
std::vector<double> due_radii(const FeedContext& k, FeedState state) {
  constexpr std::size_t most = 100000;
  std::vector<double> radii;
  for (Next next = next_of(k, state); radii.size() < most && is_due(k.feed, state, next, k.time);) {
    radii.push_back(radius_around(k.group.shape, next.diameter) + 0.5 * k.group.effect_gap);
    take_in(state, next);
    next = next_of(k, state);
  }
  return radii;
}

double reach_of(const Particles& p, std::size_t i) { return p.motion.row(i)[lane::radius] + p.effect_excess[i]; }

/// A body grown, keeping its shape, until it holds its effect surface, `excess` [m] outside it: that is within a body
/// grown by as much over the radius of a ball in it, here that in the octahedron between its poles.
std::optional<sc_body_shape> grown(std::optional<sc_body_shape> body, double excess) {
  if (body) body->radius += excess * sc_norm(body->form.inverse_axes);
  return body;
}

/// Particle i with its effect surface; empty where all are spheres.
std::optional<sc_body_shape> effect_body(const Particles& p, std::size_t i, const Forms& forms) {
  if (forms.empty()) return {};
  return grown(body_shape(p, i, forms), p.effect_excess[i]);
}

/// The part of the domain that newcomers can touch: the region and `margin` around it; periods stay whole.
Domain surroundings(const ParticleGroup& group, const Domain& domain, double margin) {
  Domain box = domain;
  for (int k = 0; k < 3; ++k) {
    if (domain.periodic[k]) continue;
    box.min[k] = group.region_min[k] - margin;
    box.max[k] = group.region_max[k] + margin;
  }
  return box;
}

/// The places of those particles that bodies with effect radii up to `largest` may touch within the region.
std::vector<std::int32_t> near_region(const FeedContext& k, double largest, const Particles& p,
                                      const std::vector<std::uint8_t>& gone) {
  std::vector<std::int32_t> near;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!gone.empty() && gone[i]) continue;
    const Domain box = surroundings(k.group, k.setting.domain, largest + reach_of(p, i));
    const double* x = p.motion.row(i);
    bool inside = true;
    for (int a = 0; a < 3; ++a) inside = inside && (box.periodic[a] || (x[a] >= box.min[a] && x[a] <= box.max[a]));
    if (inside) near.push_back(static_cast<std::int32_t>(i));
  }
  return near;
}

/// What is there already around the region, with room for those with the radii `due`.
OccupiedSpace occupied(const FeedContext& k, std::vector<double> due, const Newcomers& newcomers) {
  const double largest = *std::max_element(due.begin(), due.end());
  std::vector<std::pair<const Particles*, std::size_t>> near;
  double widest = 0;
  const auto look = [&](const Particles& p, const std::vector<std::uint8_t>& gone) {
    for (const std::int32_t i : near_region(k, largest, p, gone)) {
      widest = std::max(widest, largest + reach_of(p, i));
      near.emplace_back(&p, i);
      due.push_back(reach_of(p, i));
    }
  };
  look(k.present, k.gone);
  look(newcomers.particles, {});
  OccupiedSpace space(surroundings(k.group, k.setting.domain, widest), due);
  for (const auto& [p, i] : near) {
    const double* x = p->motion.row(i);
    space.add({x[0], x[1], x[2]}, reach_of(*p, i), effect_body(*p, i, k.setting.forms));
  }
  return space;
}

[[noreturn]] void report_delay(const FeedContext& k, const FeedState& state, const Next& next) {
  FeedState would = state;
  std::int64_t waiting = 0;
  for (Next w = next; waiting < 1000000 && is_due(k.feed, would, w, k.time); w = next_of(k, would)) {
    take_in(would, w);
    ++waiting;
  }
  throw PhysicsError(fmt::format(
      "t = {:.9g} s: the insertion of group '{}' cannot keep its rate: {} particles ({:.4g} kg) wait for room in the "
      "region from ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g}) m, the first for {:.4g} s; max_delay allows {:.4g} s. "
      "Lower "
      "the rate, enlarge the region, give the particles a velocity out of it, or raise max_delay",
      k.time, k.group.name, waiting, would.mass - state.mass, k.group.region_min[0], k.group.region_min[1],
      k.group.region_min[2], k.group.region_max[0], k.group.region_max[1], k.group.region_max[2],
      std::min(k.time, k.feed.until) - next.due, k.feed.max_delay));
}

/// Tries places for a particle; true, and its place in `newcomer`, if one is free, which is then taken.
bool find_room(const FeedContext& k, OccupiedSpace& space, FeedState& state, Newcomer& newcomer) {
  const double excess = 0.5 * k.group.effect_gap, reach = radius_around(k.group.shape, newcomer.diameter) + excess;
  const std::optional<sc_body_shape> plain = body_of(k.group, k.feed.group, newcomer, k.setting),
                                     body = grown(plain, excess);
  const PlaceRange range = range_of_places(k.group, newcomer, plain, k.setting);
  for (std::uint64_t attempt = 0; attempt < k.group.attempts; ++attempt) {
    newcomer.position =
        random_place(range, k.feed.group, newcomer.number, static_cast<std::uint32_t>(state.tries++), k.setting);
    if (!clear_of_walls(k.setting.walls, newcomer.position, reach, body)) continue;
    if (!space.is_free(newcomer.position, reach, body)) continue;
    space.add(newcomer.position, reach, body);
    return true;
  }
  return false;
}

}  // namespace

std::optional<std::vector<std::int32_t>> in_the_way(const FeedContext& k, const FeedState& state) {
  const std::vector<double> due = due_radii(k, state);
  if (due.empty()) return {};
  return near_region(k, *std::max_element(due.begin(), due.end()), k.present, k.gone);
}

std::optional<Domain> room_of_due(const FeedContext& k, const FeedState& state) {
  const std::vector<double> due = due_radii(k, state);
  if (due.empty()) return {};
  // Sums of the same radii in another order must not shut anybody out.
  return surroundings(k.group, k.setting.domain, (1 + 1e-9) * *std::max_element(due.begin(), due.end()));
}

void feed(const FeedContext& k, FeedState& state, Newcomers& newcomers) {
  const std::vector<double> due = due_radii(k, state);
  if (due.empty()) return;
  OccupiedSpace space = occupied(k, due, newcomers);
  std::vector<Newcomer> found;
  while (found.size() < due.size()) {
    const Next next = next_of(k, state);
    Newcomer newcomer{static_cast<std::uint64_t>(state.count), next.diameter, {}};
    if (!find_room(k, space, state, newcomer)) {
      if (std::min(k.time, k.feed.until) - next.due > k.feed.max_delay) report_delay(k, state, next);
      break;
    }
    found.push_back(newcomer);
    take_in(state, next);
  }
  Particles& p = newcomers.particles;
  const std::size_t first = p.size();
  p.resize(first + found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    write_particle(p, first + i, k.group, k.feed.group, found[i], k.setting);
    p.id[first + i] = newcomers.next_id++;
  }
}

}  // namespace scree
