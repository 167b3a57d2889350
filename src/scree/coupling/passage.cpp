#include "scree/coupling/passage.h"

#include <algorithm>

#include "scree/compute/launch.h"
#include "scree/coupling/deposit.h"

namespace scree {
namespace {

constexpr int most_cells = 6;  // of both ends of a way along one axis: three each that touch

/// Shares of a point along one axis at both ends of its way, in cells in a row, through periods.
struct AxisWay {
  int count = 0;
  std::array<int, most_cells> cell{};  // of the grid
  std::array<double, most_cells> before{}, gain{};
  std::array<double, most_cells> passed{};  // through the faces below the cells; nothing passes below the first
};

/// False if the way is too long.
bool find_way(const SplineAxis& axis, double from, double to, AxisWay& way) {
  from = axis.nearest_image(from, to);
  const AxisShares old = axis.shares(from), now = axis.shares(to);
  const int n = axis.cells();
  // Cells counted on through periods; at walls as they are folded.
  const auto place = [&](const AxisShares& s, double x, int k) {
    return axis.periodic() ? s.cell[1] + k - 1 + n * axis.periods_away(x) : s.cell[k];
  };
  const int first = std::min(place(old, from, 0), place(now, to, 0));
  way.count = std::max(place(old, from, 2), place(now, to, 2)) - first + 1;
  if (way.count > most_cells) return false;
  way.before = way.gain = {};
  for (int k = 0; k < 3; ++k) {
    way.before[place(old, from, k) - first] += old.share[k];
    way.gain[place(old, from, k) - first] -= old.share[k];
  }
  for (int k = 0; k < 3; ++k) way.gain[place(now, to, k) - first] += now.share[k];
  way.passed[0] = 0;
  for (int i = 0; i < way.count; ++i) way.cell[i] = ((first + i) % n + n) % n;
  for (int i = 1; i < way.count; ++i) way.passed[i] = way.passed[i - 1] - way.gain[i - 1];
  return true;
}

/// Mean over a straight way of the product of the shares along two axes.
double mean_share(const AxisWay& a, int i, const AxisWay& b, int j) {
  return (a.before[i] + 0.5 * a.gain[i]) * b.before[j] + (0.5 * a.before[i] + a.gain[i] / 3) * b.gain[j];
}

using Ways = std::array<AxisWay, 3>;

bool beside_blocked(const Spreading& s, const Ways& w) {
  if (s.blocked.empty()) return false;
  const std::int64_t nx = s.axis[0].cells(), ny = s.axis[1].cells();
  for (int k = 0; k < w[2].count; ++k)
    for (int j = 0; j < w[1].count; ++j)
      for (int i = 0; i < w[0].count; ++i)
        if (s.blocked[static_cast<std::size_t>((w[2].cell[k] * ny + w[1].cell[j]) * nx + w[0].cell[i])]) return true;
  return false;
}

/// What a point that stands for `amount`, scaled, has carried through the faces across one axis.
void deposit_axis(const Ways& w, int a, double amount, Deposits& out) {
  const int b = (a + 1) % 3, c = (a + 2) % 3;
  std::array<int, 3> cell{};
  for (int k = 0; k < w[c].count; ++k)
    for (int j = 0; j < w[b].count; ++j) {
      const double carried = amount * mean_share(w[b], j, w[c], k);
      if (carried == 0) continue;
      cell[b] = w[b].cell[j];
      cell[c] = w[c].cell[k];
      for (int i = 1; i < w[a].count; ++i) {
        cell[a] = w[a].cell[i];
        out.values[static_cast<std::size_t>(out.offset(cell[0], cell[1], cell[2]) + a)] +=
            whole(carried * w[a].passed[i]);
      }
    }
}

bool find_ways(const Spreading& s, sc_vec from, sc_vec to, Ways& ways) {
  return find_way(s.axis[0], from.x, to.x, ways[0]) && find_way(s.axis[1], from.y, to.y, ways[1]) &&
         find_way(s.axis[2], from.z, to.z, ways[2]) && !beside_blocked(s, ways);
}

/// False if what particle i has carried is not known. `ways` is room for those of its points.
bool spread_one(const Spreading& s, const Particles& p, const Quantity& volume, std::size_t i,
                std::array<Ways, most_points>& ways, Deposits& out) {
  if (p.met_at.row(i)[3] == 0) return false;
  const BodyPoints from = points_before(s, p, i), to = points_of(s, p, i);
  for (int n = 0; n < to.count; ++n)
    if (!find_ways(s, from.at[n], to.at[n], ways[n])) return false;
  const double amount = volume.values[i] * volume.scale * to.part();
  for (int n = 0; n < to.count; ++n)
    for (int a = 0; a < 3; ++a) deposit_axis(ways[n], a, amount, out);
  return true;
}

}  // namespace

std::vector<std::uint8_t> spread_passage(const Spreading& s, const Particles& p, const Quantity& volume,
                                         const CellBox& box, Deposits& out) {
  std::vector<std::uint8_t> known(p.size());
  out.shape(box, 3);
  in_parts(p.size(), out, [&](std::size_t begin, std::size_t end, Deposits& sums) {
    std::array<Ways, most_points> ways;
    for (std::size_t i = begin; i < end; ++i) known[i] = spread_one(s, p, volume, i, ways, sums);
  });
  return known;
}

void note_meeting(Particles& p) {
  launch(p.size(), [&](std::size_t i) {
    const double* m = p.motion.row(i);
    double* at = p.met_at.row(i);
    std::copy_n(m, 3, at);
    at[3] = 1;
    if (p.shaped()) std::copy_n(p.orientation.row(i), 4, p.met_turned.row(i));
  });
}

}  // namespace scree
