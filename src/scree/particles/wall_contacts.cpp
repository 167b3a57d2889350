#include "scree/particles/wall_contacts.h"

#include <omp.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "scree/particles/shapes.h"
#include "scree/particles/sweep_view.h"
#include "scree/physics/touch/body_wall.h"

namespace scree {
namespace {

/// Calls visit(face) for all faces near particle p, by rising number; `scratch` is for use in here.
template <class Visit>
void for_each_near(const Particles& particles, std::size_t p, const Walls& walls, double skin,
                   std::vector<std::int32_t>& scratch, Visit&& visit) {
  const double* m = particles.motion.row(p);
  if (m[lane::inverse_mass] == 0) return;
  const double reach = m[lane::radius] + particles.effect_excess[p] + skin;
  scratch.clear();
  for_each_face_near(walls, sc_make_vec(m[lane::x], m[lane::y], m[lane::z]), reach,
                     [&](std::size_t face, const sc_wall_gap&) { scratch.push_back(static_cast<std::int32_t>(face)); });
  std::sort(scratch.begin(), scratch.end());
  for (const std::int32_t face : scratch) {
    const int places = is_sphere(particles, p) ? 1 : sc_wall_places(walls.faces[face].kind);
    for (int k = 0; k < places; ++k) visit(face);
  }
}

}  // namespace

WallContacts find_wall_contacts(const Particles& particles, const Walls& walls, double skin) {
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
  WallContacts out;
  out.first.resize(n + 1);
  if (walls.size() == 0) return out;
  // Every thread searches for a run of particles; runs follow each other as their threads do.
  std::vector<std::vector<std::int32_t>> found(omp_get_max_threads());
#pragma omp parallel
  {
    std::vector<std::int32_t>& mine = found[omp_get_thread_num()];
    std::vector<std::int32_t> scratch;
#pragma omp for schedule(static)
    for (std::int64_t p = 0; p < n; ++p)
      for_each_near(particles, p, walls, skin, scratch, [&](std::int32_t face) {
        mine.push_back(face);
        ++out.first[p + 1];
      });
  }
  for (std::int64_t p = 0; p < n; ++p) out.first[p + 1] += out.first[p];
  const std::size_t count = out.first[n];
  out.wall.resize(count);
  out.active.resize(count);
  out.slide.resize(4 * count);
  out.roll.resize(4 * count);
  out.couple.resize(3 * count);
  out.gap.resize(count);
  if (particles.shaped()) out.shape.resize(wall_memory * count);
  std::int32_t* next = out.wall.begin();
  for (const std::vector<std::int32_t>& run : found) next = std::copy(run.begin(), run.end(), next);
  return out;
}

void carry_over(WallContacts& fresh, const WallContacts& old, const std::vector<std::int32_t>& place) {
  const auto owners = static_cast<std::int32_t>(fresh.first.size() - 1);
  for (std::size_t p = 0; p + 1 < old.first.size(); ++p)
    for (std::int32_t from = old.first[p]; from < old.first[p + 1]; ++from) {
      if (!old.active[from]) continue;
      const std::int32_t q = place[p];
      if (q < 0 || q >= owners) continue;
      const auto* last = std::as_const(fresh.wall).begin() + fresh.first[q + 1];
      const auto* found = std::lower_bound(std::as_const(fresh.wall).begin() + fresh.first[q], last, old.wall[from]);
      // The first place of the face that nobody has yet.
      while (found != last && *found == old.wall[from] && fresh.active[found - fresh.wall.begin()]) ++found;
      if (found == last || *found != old.wall[from]) continue;  // parted in the step before
      const std::size_t to = found - fresh.wall.begin();
      fresh.active[to] = old.active[from];
      std::copy_n(&old.slide[4 * std::size_t(from)], 4, &fresh.slide[4 * to]);
      std::copy_n(&old.roll[4 * std::size_t(from)], 4, &fresh.roll[4 * to]);
      std::copy_n(&old.couple[3 * std::size_t(from)], 3, &fresh.couple[3 * to]);
      if (!fresh.shape.empty() && !old.shape.empty())
        std::copy_n(&old.shape[wall_memory * std::size_t(from)], wall_memory, &fresh.shape[wall_memory * to]);
    }
}

}  // namespace scree
