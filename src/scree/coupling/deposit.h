// What all that particles share out has in common: points that stand for bodies, whole numbers, and threads.
#pragma once

#include <omp.h>

#include <bit>

#include "scree/compute/team.h"
#include "scree/coupling/spread.h"
#include "scree/physics/rotation.h"

namespace scree {

/// The nearest whole number to one below 2^51.
inline std::int64_t whole(double x) {
  constexpr double magic = 0x1.8p52;  // added to this it ends in its nearest whole number
  return std::bit_cast<std::int64_t>(x + magic) - std::bit_cast<std::int64_t>(magic);
}

constexpr std::size_t most_points = 8;

/// The points that stand for a body.
struct BodyPoints {
  std::array<sc_vec, most_points> at;
  int count = 1;

  double part() const { return 1.0 / count; }
};

/// Of particle i at a place with an orientation (w x y z).
inline BodyPoints points_of(const Spreading& s, const Particles& p, std::size_t i, const double* place,
                            const double* turned) {
  BodyPoints out;
  const sc_vec x = sc_make_vec(place[0], place[1], place[2]);
  const std::int32_t form = p.shaped() ? p.form[i] : 0;
  out.at[0] = x;
  if (form == 0 || s.points[form][0] == 0) return out;
  out.count = static_cast<int>(out.at.size());
  const sc_mat turn = sc_quat_mat(sc_make_quat(turned[0], turned[1], turned[2], turned[3]));
  const Axes& half = s.points[form];
  for (int c = 0; c < out.count; ++c) {
    const sc_vec own = sc_make_vec((c & 1 ? 1 : -1) * half[0], (c & 2 ? 1 : -1) * half[1], (c & 4 ? 1 : -1) * half[2]);
    out.at[c] = sc_add_scaled(x, p.motion.row(i)[lane::radius], sc_turn(turn, own));
  }
  return out;
}

/// Where it is now.
inline BodyPoints points_of(const Spreading& s, const Particles& p, std::size_t i) {
  return points_of(s, p, i, p.motion.row(i), p.shaped() ? p.orientation.row(i) : nullptr);
}

/// Where it was at the fluid's last step, which must have met it.
inline BodyPoints points_before(const Spreading& s, const Particles& p, std::size_t i) {
  return points_of(s, p, i, p.met_at.row(i), p.met_turned.row(i));
}

/// Calls visit(point, part) for what stands for a body.
template <class Visit>
void for_each_point(const Spreading& s, const Particles& p, std::size_t i, Visit&& visit) {
  const BodyPoints points = points_of(s, p, i);
  for (int c = 0; c < points.count; ++c) visit(points.at[c], points.part());
}

/// Calls some(begin, end, sums) for parts of n particles on all threads, and adds up what they deposit.
template <class Some>
void in_parts(std::size_t n, Deposits& out, Some&& some) {
  if (n < 2 * static_cast<std::size_t>(least_share)) return some(std::size_t{0}, n, out);
  const int threads = omp_get_max_threads();
  std::vector<Deposits> of_thread(static_cast<std::size_t>(threads));
#pragma omp parallel num_threads(threads)
  {
    const std::size_t t = static_cast<std::size_t>(omp_get_thread_num());
    const std::size_t hands = static_cast<std::size_t>(omp_get_num_threads());
    Deposits& mine = of_thread[t];
    mine.shape(out.box, out.width);
    some(n * t / hands, n * (t + 1) / hands, mine);
#pragma omp barrier
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < out.values.size(); ++c)
      for (std::size_t h = 0; h < hands; ++h) out.values[c] += of_thread[h].values[c];
  }
}

}  // namespace scree
