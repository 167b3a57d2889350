#include "scree/analysis/planes.h"

#include <omp.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "scree/base/error.h"
#include "scree/particles/box.h"

namespace scree {
namespace {

static_assert(std::is_trivially_copyable_v<PlaneCount> && sizeof(PlaneCount) % sizeof(std::int64_t) == 0);

// Below so many particles a team of threads costs more than it saves.
constexpr std::int64_t worth_sharing = 4096;

sc_vec three(const double* v) { return sc_make_vec(v[0], v[1], v[2]); }

std::uint8_t side_of(const sc_counting_plane& plane, const sc_box& box, const double* x) {
  return static_cast<std::uint8_t>(sc_side_of_plane(plane, box, three(x)));
}

}  // namespace

void PlaneWatch::note(const Particles& particles, const Domain& domain) {
  const sc_box box = box_of(domain);
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
  std::int64_t last = -1;
#pragma omp parallel for schedule(static) reduction(max : last) if (n >= worth_sharing)
  for (std::int64_t i = 0; i < n; ++i) last = std::max(last, particles.id[i]);
  if (last >= static_cast<std::int64_t>(side_.size())) side_.resize(static_cast<std::size_t>(last) + 1);
#pragma omp parallel for schedule(static) if (n >= worth_sharing)
  for (std::int64_t i = 0; i < n; ++i) side_[particles.id[i]] = side_of(plane_, box, particles.motion.row(i));
}

void PlaneWatch::look(const Particles& particles, const Domain& domain) {
  const sc_box box = box_of(domain);
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
#pragma omp parallel if (n >= worth_sharing)
  {
    PlaneCount mine;
#pragma omp for schedule(static)
    for (std::int64_t i = 0; i < n; ++i) {
      const double *x = particles.motion.row(i), *v = x + lane::vx;
      if (x[lane::inverse_mass] == 0) continue;
      const std::uint8_t side = side_of(plane_, box, x), before = side_[particles.id[i]];
      if (side == before) continue;
      side_[particles.id[i]] = side;
      const int passing = sc_passing(plane_, box, before, three(x), three(v));
      if (passing != 0) mine.add(passing, particles.mass[i]);
    }
#pragma omp critical(scree_plane_watch)
    count_.add(mine);
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
