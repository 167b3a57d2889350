#include "scree/app/build_exchange.h"

#include <algorithm>

namespace scree {
namespace {

/// When the last particle is due, as far as the keys tell without the sizes [s].
double last_due(const Feed& feed, double end) {
  double last = std::min(feed.until, end);
  if (feed.mass_rate > 0) last = std::min(last, feed.from + feed.total_mass / feed.mass_rate);
  if (feed.number_rate > 0) last = std::min(last, feed.from + static_cast<double>(feed.total_count) / feed.number_rate);
  return last;
}

}  // namespace

std::vector<Outlet> build_outlets(const Case& c) {
  std::vector<Outlet> outlets;
  for (const OutletKeys& keys : c.outlets) {
    Outlet outlet;
    outlet.name = keys.name;
    outlet.is_face = keys.type == "face";
    outlet.min = keys.min;
    outlet.max = keys.max;
    if (outlet.is_face) {
      outlet.axis = keys.face[0] - 'x';
      outlet.upper = keys.face.ends_with("max");
    }
    outlets.push_back(outlet);
  }
  return outlets;
}

std::vector<Feed> build_feeds(const Case& c) {
  std::vector<Feed> feeds;
  for (std::size_t g = 0; g < c.particles.size(); ++g) {
    const ParticleKeys& keys = c.particles[g];
    if (keys.insert != "rate") continue;
    Feed feed;
    feed.group = static_cast<std::uint32_t>(g);
    feed.mass_rate = keys.mass_rate;
    feed.number_rate = keys.number_rate;
    feed.from = keys.from;
    if (keys.until) feed.until = *keys.until;
    if (keys.total_mass > 0) feed.total_mass = keys.total_mass;
    if (keys.total_count > 0) feed.total_count = static_cast<std::int64_t>(keys.total_count);
    feed.max_delay = keys.max_delay.value_or(0.1 * (last_due(feed, c.simulation.end) - feed.from));
    feeds.push_back(feed);
  }
  return feeds;
}

double expected_count(const Feed& feed, double mean_mass, double end) {
  const double time = std::max(0.0, std::min(feed.until, end) - feed.from);
  const double by_rate = time * (feed.mass_rate > 0 ? feed.mass_rate / mean_mass : feed.number_rate);
  return std::min({by_rate, feed.total_mass / mean_mass, static_cast<double>(feed.total_count)});
}

}  // namespace scree
