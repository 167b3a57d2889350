#include "scree/app/plane_watches.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace scree {
namespace {

CountingPlane plane_of(const PlaneKeys& keys) {
  CountingPlane out{keys.point, keys.normal, std::numeric_limits<double>::infinity(), keys.min, keys.max};
  const double length = std::hypot(keys.normal[0], keys.normal[1], keys.normal[2]);
  for (double& n : out.normal) n /= length;
  if (keys.radius) out.radius = *keys.radius;
  return out;
}

}  // namespace

PlaneWatches::PlaneWatches(const Case& c) {
  for (const PlaneKeys& keys : c.analysis.planes) watches_.emplace_back(plane_of(keys));
}

void PlaneWatches::begin(const Particles& particles, const Domain& domain, double dt) {
  if (begun_) return;
  for (PlaneWatch& watch : watches_) watch.look(particles, domain, dt, true);
  begun_ = true;
}

void PlaneWatches::note(const Particles& particles, const Domain& domain, std::int64_t fresh) {
  for (PlaneWatch& watch : watches_) watch.note(particles, domain, fresh);
}

void PlaneWatches::look(const Particles& particles, const Domain& domain, double dt) {
  for (PlaneWatch& watch : watches_) watch.look(particles, domain, dt, false);
}

std::vector<PlaneCount> PlaneWatches::counts(const Ranks& ranks) const {
  std::vector<PlaneCount> mine;
  for (const PlaneWatch& watch : watches_) mine.push_back(watch.count());
  Bytes bytes(sizeof(PlaneCount) * mine.size());
  if (!mine.empty()) std::memcpy(bytes.data(), mine.data(), bytes.size());
  std::vector<PlaneCount> all(mine.size());
  for (const Bytes& counted : ranks.gather(bytes))
    for (std::size_t k = 0; k < all.size(); ++k) {
      PlaneCount more;
      std::memcpy(static_cast<void*>(&more), counted.data() + k * sizeof more, sizeof more);
      all[k].along += more.along;
      all[k].against += more.against;
      all[k].mass.add(more.mass);
    }
  return all;
}

void PlaneWatches::restore(const Case& c, const Archive& archive, const Ranks& ranks) {
  for (std::size_t k = 0; k < watches_.size(); ++k) {
    const std::string name = "plane_" + c.analysis.planes[k].name;
    if (ranks.root() && archive.contains(name)) watches_[k].restore(plane_count_from(archive.get<std::int64_t>(name)));
  }
}

}  // namespace scree
