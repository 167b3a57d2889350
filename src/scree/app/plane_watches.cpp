#include "scree/app/plane_watches.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace scree {
namespace {

sc_counting_plane plane_of(const PlaneKeys& keys) {
  const auto vec = [](const std::array<double, 3>& v) { return sc_make_vec(v[0], v[1], v[2]); };
  const std::array<double, 3>& n = keys.normal;
  const double length = std::hypot(n[0], n[1], n[2]);
  return {vec(keys.point), sc_make_vec(n[0] / length, n[1] / length, n[2] / length),
          keys.radius.value_or(std::numeric_limits<double>::infinity()), vec(keys.min), vec(keys.max)};
}

}  // namespace

PlaneWatches::PlaneWatches(const Case& c) {
  for (const PlaneKeys& keys : c.analysis.planes) watches_.emplace_back(plane_of(keys));
}

std::vector<sc_counting_plane> PlaneWatches::planes() const {
  std::vector<sc_counting_plane> out;
  for (const PlaneWatch& watch : watches_) out.push_back(watch.plane());
  return out;
}

void PlaneWatches::begin(const Particles& particles, const Domain& domain) {
  if (begun_) return;
  note(particles, domain);
  begun_ = true;
}

void PlaneWatches::note(const Particles& particles, const Domain& domain) {
  for (PlaneWatch& watch : watches_) watch.note(particles, domain);
}

void PlaneWatches::look(const Particles& particles, const Domain& domain) {
  for (PlaneWatch& watch : watches_) watch.look(particles, domain);
}

void PlaneWatches::add(const std::vector<PlaneCount>& counts) {
  for (std::size_t k = 0; k < watches_.size(); ++k) watches_[k].add(counts[k]);
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
      all[k].add(more);
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
