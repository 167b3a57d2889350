#include "scree/particles/wall_contacts.h"

#include <algorithm>
#include <utility>

namespace scree {
namespace {

/// Gap between the effect surface of particle p and a face [m].
double gap(const Particles& particles, std::size_t p, const sc_wall& face) {
  const double* m = particles.motion.row(p);
  sc_sphere_wall s{};
  s.position = sc_make_vec(m[lane::x], m[lane::y], m[lane::z]);
  s.radius = m[lane::radius];
  s.inverse_mass = m[lane::inverse_mass];
  s.excess = particles.effect_excess[p];
  return -sc_touch_wall(s, face).touch.reach;
}

}  // namespace

WallContacts find_wall_contacts(const Particles& particles, const Walls& walls, double skin) {
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
  WallContacts out;
  out.first.resize(n + 1);
  if (walls.size() == 0) return out;
  const auto for_each_near = [&](std::int64_t p, auto&& visit) {
    if (particles.motion.row(p)[lane::inverse_mass] == 0) return;
    for (std::size_t f = 0; f < walls.size(); ++f)
      if (gap(particles, p, walls.faces[f]) < skin) visit(static_cast<std::int32_t>(f));
  };
#pragma omp parallel for schedule(static)
  for (std::int64_t p = 0; p < n; ++p) for_each_near(p, [&](std::int32_t) { ++out.first[p + 1]; });
  for (std::int64_t p = 0; p < n; ++p) out.first[p + 1] += out.first[p];
  const std::size_t count = out.first[n];
  out.wall.resize(count);
  out.active.resize(count);
  out.slide.resize(4 * count);
  out.roll.resize(4 * count);
#pragma omp parallel for schedule(static)
  for (std::int64_t p = 0; p < n; ++p) {
    std::int32_t next = out.first[p];
    for_each_near(p, [&](std::int32_t f) { out.wall[next++] = f; });
  }
  return out;
}

void carry_over(WallContacts& fresh, const WallContacts& old, const std::vector<std::int32_t>& place) {
  for (std::size_t p = 0; p + 1 < old.first.size(); ++p)
    for (std::int32_t from = old.first[p]; from < old.first[p + 1]; ++from) {
      if (!old.active[from]) continue;
      const std::int32_t q = place[p];
      const auto* last = std::as_const(fresh.wall).begin() + fresh.first[q + 1];
      const auto* found = std::lower_bound(std::as_const(fresh.wall).begin() + fresh.first[q], last, old.wall[from]);
      if (found == last || *found != old.wall[from]) continue;  // parted in the step before
      const std::size_t to = found - fresh.wall.begin();
      fresh.active[to] = old.active[from];
      std::copy_n(&old.slide[4 * std::size_t(from)], 4, &fresh.slide[4 * to]);
      std::copy_n(&old.roll[4 * std::size_t(from)], 4, &fresh.roll[4 * to]);
    }
}

}  // namespace scree
