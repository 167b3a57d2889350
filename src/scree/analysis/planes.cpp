#include "scree/analysis/planes.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "scree/base/error.h"

namespace scree {
namespace {

static_assert(std::is_trivially_copyable_v<PlaneCount> && sizeof(PlaneCount) % sizeof(std::int64_t) == 0);

// Below so many particles a team of threads costs more than it saves.
constexpr std::int64_t worth_sharing = 4096;

/// Distance of a point behind the plane, to the nearest image [m].
double depth(const CountingPlane& plane, const Domain& domain, const double* x) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += plane.normal[k] * domain.nearest(k, x[k] - plane.point[k]);
  return sum;
}

/// Whether a particle that is now `after` behind the plane has changed sides by passing it, and not by coming closer
/// to another image of it: that lies half a period away.
bool passed(const CountingPlane& plane, const Domain& domain, double after) {
  double nearest_image = 0;
  for (int k = 0; k < 3; ++k) nearest_image += std::abs(plane.normal[k]) * domain.period(k);
  return nearest_image == 0 || std::abs(after) < 0.25 * nearest_image;
}

/// Whether the way that ends at x, behind the plane by `after`, met the plane in its disc and box.
bool within(const CountingPlane& plane, const Domain& domain, const double* x, const double* v, double after) {
  double speed = 0;
  for (int k = 0; k < 3; ++k) speed += plane.normal[k] * v[k];
  const double since = speed != 0 && after / speed > 0 ? after / speed : 0;
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    double place = x[k] - since * v[k];
    const double from_point = domain.nearest(k, place - plane.point[k]);
    square += from_point * from_point;
    if (place < domain.min[k]) place += domain.period(k);
    if (place >= domain.max[k]) place -= domain.period(k);
    // Along the normal the place is the plane's own, and rounding must not decide.
    if (std::abs(plane.normal[k]) < 1 && (place < plane.min[k] || place > plane.max[k])) return false;
  }
  return square <= plane.radius * plane.radius;
}

}  // namespace

/// Room for the sides of all.
void PlaneWatch::make_room(const Particles& particles) {
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
  std::int64_t last = -1;
#pragma omp parallel for schedule(static) reduction(max : last) if (n >= worth_sharing)
  for (std::int64_t i = 0; i < n; ++i) last = std::max(last, particles.id[i]);
  if (last >= static_cast<std::int64_t>(side_.size())) side_.resize(static_cast<std::size_t>(last) + 1);
}

void PlaneWatch::note(const Particles& particles, const Domain& domain, std::int64_t fresh) {
  make_room(particles);
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
#pragma omp parallel for schedule(static) if (n >= worth_sharing)
  for (std::int64_t i = 0; i < n; ++i)
    if (particles.id[i] < fresh)
      side_[particles.id[i]] = depth(plane_, domain, particles.motion.row(i)) < 0 ? before : behind;
}

void PlaneWatch::look(const Particles& particles, const Domain& domain, double dt, bool first) {
  make_room(particles);
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
#pragma omp parallel if (n >= worth_sharing)
  {
    PlaneCount mine;
#pragma omp for schedule(static)
    for (std::int64_t i = 0; i < n; ++i) {
      const double *x = particles.motion.row(i), *v = x + lane::vx;
      if (x[lane::inverse_mass] == 0) continue;
      std::uint8_t& side = side_[particles.id[i]];
      const double after = depth(plane_, domain, x);
      if (side == unseen) {
        double start[3];
        for (int k = 0; k < 3; ++k) start[k] = x[k] - (first ? 0 : dt) * v[k];
        side = depth(plane_, domain, start) < 0 ? before : behind;
      }
      const Side now = after < 0 ? before : behind;
      if (now == side) continue;
      side = now;
      if (!passed(plane_, domain, after) || !within(plane_, domain, x, v, after)) continue;
      ++(now == behind ? mine.along : mine.against);
      mine.mass.add(now == behind ? particles.mass[i] : -particles.mass[i]);
    }
#pragma omp critical(scree_plane_watch)
    {
      count_.along += mine.along;
      count_.against += mine.against;
      if (mine.along || mine.against) count_.mass.add(mine.mass);
    }
  }
}

std::vector<std::int64_t> numbers_of(const PlaneCount& count) {
  std::vector<std::int64_t> out(sizeof(PlaneCount) / sizeof(std::int64_t));
  std::memcpy(out.data(), &count, sizeof count);
  return out;
}

PlaneCount plane_count_from(std::span<const std::int64_t> numbers) {
  PlaneCount out;
  if (numbers.size_bytes() != sizeof out) throw InputError("the count of a plane comes from another version");
  std::memcpy(static_cast<void*>(&out), numbers.data(), sizeof out);
  return out;
}

}  // namespace scree
