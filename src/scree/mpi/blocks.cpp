#include "scree/mpi/blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {
namespace {

/// Slices of an axis in which loads are counted.
constexpr int slices = 1024;

std::array<int, 3> place_of(const Blocks& b, int rank) {
  return {rank / (b.counts[1] * b.counts[2]), rank / b.counts[2] % b.counts[1], rank % b.counts[2]};
}

struct Interval {
  double low, high;
};

/// Distance of two intervals, to the nearest image.
double distance(Interval a, Interval b, double period) {
  const auto apart = [&](double shift) { return std::max({b.low - (a.high + shift), a.low + shift - b.high, 0.0}); };
  return period == 0 ? apart(0) : std::min({apart(0), apart(period), apart(-period)});
}

/// The interval of block k along an axis: beyond all bounds at the ends, but along periodic axes.
Interval interval(const Blocks& b, const Domain& domain, int axis, int k) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool periodic = domain.periodic[axis];
  const double low = k > 0 ? b.cuts[axis][k - 1] : (periodic ? domain.min[axis] : -infinity);
  const double high = k + 1 < b.counts[axis] ? b.cuts[axis][k] : (periodic ? domain.max[axis] : infinity);
  return {low, high};
}

/// Planes after which equal shares of the load are complete, in the middle of nothing if there is no load.
void cut(std::vector<double>& cuts, const std::int64_t* load, double low, double width) {
  std::int64_t all = 0;
  for (int s = 0; s < slices; ++s) all += load[s];
  if (all == 0) return;
  const int count = static_cast<int>(cuts.size()) + 1;
  std::int64_t below = 0;
  int slice = 0;
  for (int k = 0; k + 1 < count; ++k) {
    const double wanted = static_cast<double>(all) * (k + 1) / count;
    while (slice < slices && static_cast<double>(below + load[slice]) <= wanted) below += load[slice++];
    const double rest = slice < slices && load[slice] > 0
                            ? (wanted - static_cast<double>(below)) / static_cast<double>(load[slice])
                            : 0.0;
    cuts[k] = low + width * (slice + rest);
  }
}

}  // namespace

BlockCounts least_surface(int count, const std::array<double, 3>& lengths) {
  BlockCounts best{1, 1, count};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= count; ++i)
    for (int j = 1; count % i == 0 && j <= count / i; ++j) {
      if (count / i % j != 0) continue;
      const BlockCounts c{i, j, count / i / j};
      double surface = 0;
      for (int k = 0; k < 3; ++k) surface += (c[k] - 1) * lengths[(k + 1) % 3] * lengths[(k + 2) % 3];
      if (surface >= least) continue;
      least = surface;
      best = c;
    }
  return best;
}

int Blocks::owner(const double* x) const {
  int rank = 0;
  for (int k = 0; k < 3; ++k) {
    const auto& c = cuts[k];
    rank = rank * counts[k] + static_cast<int>(std::upper_bound(c.begin(), c.end(), x[k]) - c.begin());
  }
  return rank;
}

std::array<std::array<double, 2>, 3> Blocks::bounds(int rank, const Domain& domain) const {
  const std::array<int, 3> place = place_of(*this, rank);
  std::array<std::array<double, 2>, 3> out;
  for (int k = 0; k < 3; ++k) {
    const Interval i = interval(*this, domain, k, place[k]);
    out[k] = {i.low, i.high};
  }
  return out;
}

bool Blocks::is_near(const double* x, int rank, double range, const Domain& domain) const {
  const std::array<int, 3> place = place_of(*this, rank);
  double d2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = distance({x[k], x[k]}, interval(*this, domain, k, place[k]), domain.period(k));
    d2 += d * d;
  }
  return d2 < range * range;
}

std::vector<int> Blocks::near_ranks(int rank, double range, const Domain& domain) const {
  const std::array<int, 3> own = place_of(*this, rank);
  std::vector<int> out;
  for (int other = 0; other < total(); ++other) {
    const std::array<int, 3> place = place_of(*this, other);
    double d2 = 0;
    for (int k = 0; k < 3; ++k) {
      const double d =
          distance(interval(*this, domain, k, own[k]), interval(*this, domain, k, place[k]), domain.period(k));
      d2 += d * d;
    }
    if (other != rank && d2 < range * range) out.push_back(other);
  }
  return out;
}

Blocks equal_blocks(int count, const Domain& domain) {
  Blocks out;
  out.counts = least_surface(count, {domain.length(0), domain.length(1), domain.length(2)});
  for (int k = 0; k < 3; ++k)
    for (int i = 1; i < out.counts[k]; ++i) out.cuts[k].push_back(domain.min[k] + domain.length(k) * i / out.counts[k]);
  return out;
}

void balance(Blocks& blocks, const Domain& domain, const Particles& particles, const std::vector<std::int32_t>& load,
             const Ranks& ranks) {
  std::vector<std::int64_t> found(3 * slices, 0);
  const auto slice_of = [&](int axis, double x) {
    const double s = (x - domain.min[axis]) / domain.length(axis) * slices;
    return static_cast<int>(std::clamp(s, 0.0, slices - 1.0));
  };
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (int k = 0; k < 3; ++k) found[slices * k + slice_of(k, particles.motion.row(i)[k])] += load[i];
  ranks.add_up(found);
  for (int k = 0; k < 3; ++k) cut(blocks.cuts[k], &found[slices * k], domain.min[k], domain.length(k) / slices);
}

}  // namespace scree
