#include "scree/coupling/spread.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scree/coupling/deposit.h"

namespace scree {
namespace {

constexpr int bits_of_one = 50;  // of the largest particle
constexpr int bits_of_all = 61;  // of the sum
/// The 27 cells of a point: offsets in a patch of one number per cell, and weights.
struct PointCells {
  std::array<std::int64_t, 27> offset;
  std::array<double, 27> weight;

  int heaviest() const { return static_cast<int>(std::ranges::max_element(weight) - weight.begin()); }
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
  return s.blocked.empty() || leave_out_blocked(s, a, p);
}

/// One particle's deposits of one quantity.
template <int Components>
void deposit(const PointCells& at, int heaviest, const double* value, double scale, int width, std::int64_t* to) {
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
  std::int64_t* cell = to + at.offset[heaviest] * width;
  for (int c = 0; c < Components; ++c) cell[c] += rest[c];
}

void spread_some(const Spreading& s, const Particles& p, const std::vector<const Quantity*>& quantities,
                 std::size_t begin, std::size_t end, Deposits& out) {
  PointCells cells;
  for (std::size_t i = begin; i < end; ++i)
    for_each_point(s, p, i, [&](sc_vec x, double part) {
      if (!find_cells(s, out, x, cells)) return;
      const int heaviest = cells.heaviest();
      std::int64_t* to = out.values.data();
      for (const Quantity* q : quantities) {
        const double* value = &q->values[i * static_cast<std::size_t>(q->components)];
        if (q->components == 1)
          deposit<1>(cells, heaviest, value, part * q->scale, out.width, to);
        else
          deposit<3>(cells, heaviest, value, part * q->scale, out.width, to);
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
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto include = [&](const BodyPoints& points) {
      for (int n = 0; n < points.count; ++n) {
        const double at[3] = {points.at[n].x, points.at[n].y, points.at[n].z};
        for (int a = 0; a < 3; ++a)
          for (const int c : s.axis[a].shares(at[a]).cell) {
            box.low[a] = std::min(box.low[a], c);
            box.high[a] = std::max(box.high[a], c + 1);
          }
      }
    };
    include(points_of(s, p, i));
    if (p.coupled() && p.met_at.row(i)[3] != 0) include(points_before(s, p, i));
  }
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
  in_parts(p.size(), out, [&](std::size_t begin, std::size_t end, Deposits& sums) {
    spread_some(s, p, quantities, begin, end, sums);
  });
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
