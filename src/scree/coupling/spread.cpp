#include "scree/coupling/spread.h"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scree/compute/team.h"
#include "scree/physics/rotation.h"

namespace scree {
namespace {

constexpr double magic = 0x1.8p52;  // a number below 2^51 added to this ends in its nearest whole number
constexpr int bits_of_one = 50;     // of the largest particle
constexpr int bits_of_all = 61;     // of the sum
constexpr int corners = 8;

/// The nearest whole number.
inline std::int64_t whole(double x) {
  return std::bit_cast<std::int64_t>(x + magic) - std::bit_cast<std::int64_t>(magic);
}

/// The 27 cells of a point: offsets in a patch of one number per cell, and weights.
struct PointCells {
  std::array<std::int64_t, 27> offset;
  std::array<double, 27> weight;
  int heaviest = 0;
};

/// Leaves out cells that are no fluid; the others share what is left. False if there are none.
bool leave_out_blocked(const Spreading& s, const std::array<AxisShares, 3>& a, PointCells& p) {
  const std::int64_t nx = s.axis[0].cells(), ny = s.axis[1].cells();
  double open = 0;
  int at = 0;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i, ++at) {
        const std::int64_t c = (a[2].cell[k] * ny + a[1].cell[j]) * nx + a[0].cell[i];
        if (s.blocked[static_cast<std::size_t>(c)]) p.weight[at] = 0;
        open += p.weight[at];
      }
  if (open == 0) return false;
  for (double& w : p.weight) w /= open;
  return true;
}

template <class T>
bool find_cells(const Spreading& s, const Patch<T>& patch, sc_vec x, PointCells& p) {
  const std::array<AxisShares, 3> a = {s.axis[0].shares(x.x), s.axis[1].shares(x.y), s.axis[2].shares(x.z)};
  const std::int64_t sy = patch.stride_y(), sz = patch.stride_z();
  int at = 0;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j) {
      const std::int64_t row =
          (a[2].cell[k] - patch.box.low[2]) * sz + (a[1].cell[j] - patch.box.low[1]) * sy - patch.box.low[0];
      const double w = a[2].share[k] * a[1].share[j];
      for (int i = 0; i < 3; ++i, ++at) {
        p.offset[at] = row + a[0].cell[i];
        p.weight[at] = w * a[0].share[i];
      }
    }
  if (!s.blocked.empty() && !leave_out_blocked(s, a, p)) return false;
  p.heaviest = static_cast<int>(std::max_element(p.weight.begin(), p.weight.end()) - p.weight.begin());
  return true;
}

/// Calls visit(point, part) for what stands for a body.
template <class Visit>
void for_each_point(const Spreading& s, const Particles& p, std::size_t i, Visit&& visit) {
  const double* m = p.motion.row(i);
  const sc_vec x = sc_make_vec(m[0], m[1], m[2]);
  const std::int32_t form = p.shaped() ? p.form[i] : 0;
  if (form == 0 || s.points[form][0] == 0) return visit(x, 1.0);
  const double* q = p.orientation.row(i);
  const sc_mat turn = sc_quat_mat(sc_make_quat(q[0], q[1], q[2], q[3]));
  const Axes& half = s.points[form];
  for (int c = 0; c < corners; ++c) {
    const sc_vec own = sc_make_vec((c & 1 ? 1 : -1) * half[0], (c & 2 ? 1 : -1) * half[1], (c & 4 ? 1 : -1) * half[2]);
    visit(sc_add_scaled(x, m[lane::radius], sc_turn(turn, own)), 1.0 / corners);
  }
}

/// One particle's deposits of one quantity.
template <int Components>
void deposit(const PointCells& at, const double* value, double scale, int width, std::int64_t* to) {
  double q[Components];
  std::int64_t rest[Components];
  for (int c = 0; c < Components; ++c) {
    q[c] = value[c] * scale;
    rest[c] = whole(q[c]);
  }
  for (int n = 0; n < 27; ++n) {
    std::int64_t* cell = to + at.offset[n] * width;
    for (int c = 0; c < Components; ++c) {
      const std::int64_t part = whole(at.weight[n] * q[c]);
      cell[c] += part;
      rest[c] -= part;
    }
  }
  std::int64_t* cell = to + at.offset[at.heaviest] * width;
  for (int c = 0; c < Components; ++c) cell[c] += rest[c];
}

void spread_some(const Spreading& s, const Particles& p, const std::vector<const Quantity*>& quantities,
                 std::size_t begin, std::size_t end, Deposits& out) {
  PointCells cells;
  for (std::size_t i = begin; i < end; ++i)
    for_each_point(s, p, i, [&](sc_vec x, double part) {
      if (!find_cells(s, out, x, cells)) return;
      std::int64_t* to = out.values.data();
      for (const Quantity* q : quantities) {
        const double* value = &q->values[i * static_cast<std::size_t>(q->components)];
        if (q->components == 1)
          deposit<1>(cells, value, part * q->scale, out.width, to);
        else
          deposit<3>(cells, value, part * q->scale, out.width, to);
        to += q->components;
      }
    });
}

}  // namespace

Spreading::Spreading(const FluidRegion& region, const Forms& forms)
    : axis{SplineAxis(region.grid, 0), SplineAxis(region.grid, 1), SplineAxis(region.grid, 2)} {
  const Grid& g = region.grid;
  blocked.resize(static_cast<std::size_t>(g.all().cells()));
  std::size_t at = 0;
  for (int k = 0; k < g.cells(2); ++k)
    for (int j = 0; j < g.cells(1); ++j)
      for (int i = 0; i < g.cells(0); ++i) blocked[at++] = !region.is_fluid(i, j, k);
  if (std::ranges::none_of(blocked, [](std::uint8_t b) { return b != 0; })) blocked.clear();
  // The sphere comes first: it is a point.
  for (const Form& form : forms) {
    if (points.empty()) {
      points.push_back({});
      continue;
    }
    const Axes& i = form.inertia;
    // Mean squares along the axes from the moments of inertia about them.
    points.push_back({std::sqrt(0.5 * (i[1] + i[2] - i[0])), std::sqrt(0.5 * (i[2] + i[0] - i[1])),
                      std::sqrt(0.5 * (i[0] + i[1] - i[2]))});
  }
}

CellBox touched_cells(const Spreading& s, const Particles& p) {
  if (p.size() == 0) return {};
  CellBox box;
  for (int a = 0; a < 3; ++a) box.low[a] = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < p.size(); ++i)
    for_each_point(s, p, i, [&](sc_vec x, double) {
      const double at[3] = {x.x, x.y, x.z};
      for (int a = 0; a < 3; ++a)
        for (const int c : s.axis[a].shares(at[a]).cell) {
          box.low[a] = std::min(box.low[a], c);
          box.high[a] = std::max(box.high[a], c + 1);
        }
    });
  return box;
}

double scale_for(const Quantity& q, std::int64_t particles_of_all, const Ranks& ranks) {
  double largest = 0;
  for (const double x : q.values) largest = std::max(largest, std::abs(x));
  largest = ranks.largest(largest);
  if (largest == 0) return 1;
  const int room = bits_of_all - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(particles_of_all)));
  return std::ldexp(1.0, std::min(bits_of_one, room) - std::ilogb(largest) - 1);
}

void spread(const Spreading& s, const Particles& p, const std::vector<const Quantity*>& quantities, const CellBox& box,
            Deposits& out) {
  int width = 0;
  for (const Quantity* q : quantities) width += q->components;
  out.shape(box, width);
  const std::size_t n = p.size();
  if (n < 2 * static_cast<std::size_t>(least_share)) return spread_some(s, p, quantities, 0, n, out);
  const int threads = omp_get_max_threads();
  std::vector<Deposits> of_thread(static_cast<std::size_t>(threads));
#pragma omp parallel num_threads(threads)
  {
    const std::size_t t = static_cast<std::size_t>(omp_get_thread_num());
    const std::size_t hands = static_cast<std::size_t>(omp_get_num_threads());
    Deposits& mine = of_thread[t];
    mine.shape(box, width);
    spread_some(s, p, quantities, n * t / hands, n * (t + 1) / hands, mine);
#pragma omp barrier
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < out.values.size(); ++c)
      for (std::size_t h = 0; h < hands; ++h) out.values[c] += of_thread[h].values[c];
  }
}

void read_at(const Spreading& s, const Particles& p, const CellValues& values, std::vector<double>& out) {
  const int width = values.width;
  const std::int64_t n = static_cast<std::int64_t>(p.size());
  out.assign(static_cast<std::size_t>(n * width), 0.0);
#pragma omp parallel for schedule(static) if (n >= 2 * least_share)
  for (std::int64_t i = 0; i < n; ++i) {
    double* to = &out[static_cast<std::size_t>(i * width)];
    PointCells cells;
    for_each_point(s, p, static_cast<std::size_t>(i), [&](sc_vec x, double part) {
      if (!find_cells(s, values, x, cells)) return;
      for (int c = 0; c < 27; ++c) {
        const double w = part * cells.weight[c];
        const double* from = &values.values[static_cast<std::size_t>(cells.offset[c] * width)];
        for (int e = 0; e < width; ++e) to[e] += w * from[e];
      }
    });
  }
}

}  // namespace scree
