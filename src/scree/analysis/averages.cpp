#include "scree/analysis/averages.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/particles/contact_forces.h"
#include "scree/particles/sizes.h"

namespace scree {
namespace {

using Point = std::array<double, 3>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Point point_of(const double* p) { return {p[0], p[1], p[2]}; }
Point point_of(const sc_vec& v) { return {v.x, v.y, v.z}; }

/// Rows of cells that one thread fills.
struct Rows {
  std::int64_t first, last;
};

/// Whether anything that is spread from the box around a point and a way from it can reach the rows.
bool reaches(const CellGrid3& grid, Rows rows, const Point& x, const Point& way) {
  std::array<std::int64_t, 2> low, high;
  for (int n = 0; n < 2; ++n) {
    const int axis = n + 1;
    const double from = (x[axis] - grid.min[axis]) / grid.spacing(axis), to = from + way[axis] / grid.spacing(axis);
    low[n] = static_cast<std::int64_t>(std::floor(std::min(from, to))) - 2;
    high[n] = static_cast<std::int64_t>(std::floor(std::max(from, to))) + 2;
    if (grid.periodic[axis] && (low[n] < 0 || high[n] >= grid.cells[axis])) return true;
    low[n] = std::clamp<std::int64_t>(low[n], 0, grid.cells[axis] - 1);
    high[n] = std::clamp<std::int64_t>(high[n], 0, grid.cells[axis] - 1);
  }
  return low[1] * grid.cells[1] + low[0] < rows.last && high[1] * grid.cells[1] + high[0] >= rows.first;
}

/// Adds `what` to a range of the sums of every cell that a spread reaches.
template <std::size_t Count>
void add_spread(Averages& to, const CoarseGrain& grain, Rows rows, const Spread& spread, int first,
                const std::array<double, Count>& what) {
  grain.deliver(spread, rows.first, rows.last, [&](std::int64_t cell, double share) {
    double* sums = &to.sums[sum_of::count * static_cast<std::size_t>(cell) + first];
    for (std::size_t n = 0; n < Count; ++n) sums[n] += share * what[n];
  });
}

bool moves_freely(const Particles& p, std::int32_t i) { return p.motion.row(i)[lane::inverse_mass] > 0; }

void add_particle(Averages& to, const CoarseGrain& grain, Rows rows, const Particles& p, std::uint32_t i) {
  const double* m = p.motion.row(i);
  const Point x = point_of(m);
  if (!moves_freely(p, static_cast<std::int32_t>(i)) || !grain.contains(x) || !reaches(to.grid, rows, x, {})) return;
  const double mass = p.mass[i], volume = sphere_volume(2 * p.radius_by_volume(i));
  const Point v = point_of(m + lane::vx);
  const std::array<double, sum_of::contact> what = {1.0,
                                                    volume,
                                                    mass,
                                                    mass * v[0],
                                                    mass * v[1],
                                                    mass * v[2],
                                                    mass * v[0] * v[0],
                                                    mass * v[0] * v[1],
                                                    mass * v[0] * v[2],
                                                    mass * v[1] * v[1],
                                                    mass * v[1] * v[2],
                                                    mass * v[2] * v[2]};
  add_spread(to, grain, rows, grain.point(x), 0, what);
}

/// A contact seen by the averages: the material's side of it.
struct Carried {
  Point start, way;
  std::array<double, 9> stress;  // minus force on the start times way
  bool at_boundary;
  Point force;  // on the material
};

/// A contact between free particles as it is; at a boundary from the centre of the free one to the contact point.
Carried carried_by(const Particles& p, const ContactForce& c) {
  const bool first_free = moves_freely(p, c.first), second_free = !c.at_wall() && moves_freely(p, c.second);
  Carried out{};
  out.at_boundary = !(first_free && second_free);
  sc_vec way = c.branch, force = c.force;
  if (out.at_boundary) way = c.arm;
  out.start = point_of(p.motion.row(c.first));
  if (!first_free) {
    way = sc_sub(c.arm, c.branch);
    force = sc_scale(-1, c.force);
    out.start = point_of(p.motion.row(c.second));
  }
  out.way = point_of(way);
  out.force = point_of(force);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) out.stress[3 * a + b] = -out.force[a] * out.way[b];
  return out;
}

/// Spreads a contact from `start`, which may be a periodic image of the place of its particle.
void add_contact_at(Averages& to, const CoarseGrain& grain, Rows rows, const Carried& c, const Point& start,
                    std::vector<Spread>& pieces) {
  if (!reaches(to.grid, rows, start, c.way)) return;
  grain.line(start, c.way, pieces);
  for (const Spread& piece : pieces) add_spread(to, grain, rows, piece, sum_of::contact, c.stress);
  if (!c.at_boundary) return;
  const Point end = grain.at_border({start[0] + c.way[0], start[1] + c.way[1], start[2] + c.way[2]});
  if (grain.contains(end)) add_spread(to, grain, rows, grain.point(end), sum_of::wall_force, c.force);
}

/// Spreads a contact, and its images where it leaves the domain through a periodic face that the grid does not know.
void add_contact(Averages& to, const CoarseGrain& grain, Rows rows, const Domain& domain, const Carried& c,
                 std::vector<Spread>& pieces) {
  std::array<double, 3> shift{};
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.periodic[axis] || to.grid.periodic[axis]) continue;
    const double end = c.start[axis] + c.way[axis];
    shift[axis] = end >= domain.max[axis] ? -domain.period(axis) : end < domain.min[axis] ? domain.period(axis) : 0;
  }
  for (int image = 0; image < 8; ++image) {
    Point start = c.start;
    bool wanted = true;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(image >> axis & 1)) continue;
      wanted = wanted && shift[axis] != 0;
      start[axis] += shift[axis];
    }
    if (wanted) add_contact_at(to, grain, rows, c, start, pieces);
  }
}

}  // namespace

Averages start_averages(const CellGrid3& grid) { return {grid, 0, std::vector<double>(sum_of::count * grid.size())}; }

void add_sample(Averages& averages, const Sample& sample) {
  const ParticleSystem& s = sample.system;
  const CoarseGrain grain(averages.grid);
  const std::vector<std::uint32_t> order = order_by_id(s.particles);
  std::vector<Carried> contacts;
  for (const ContactForce& c : contact_forces(sample)) contacts.push_back(carried_by(s.particles, c));
  const std::int64_t rows = std::int64_t{averages.grid.cells[1]} * averages.grid.cells[2];
  const std::int64_t parts = std::min<std::int64_t>(rows, omp_get_max_threads());
#pragma omp parallel for schedule(static, 1)
  for (std::int64_t part = 0; part < parts; ++part) {
    const Rows mine{rows * part / parts, rows * (part + 1) / parts};
    std::vector<Spread> pieces;
    for (const std::uint32_t i : order) add_particle(averages, grain, mine, s.particles, i);
    for (const Carried& c : contacts) add_contact(averages, grain, mine, s.domain, c, pieces);
  }
  ++averages.samples;
}

std::vector<AverageField> fields_of(const Averages& a) {
  std::vector<AverageField> out = {
      {"number_density", "1/m3", "Particles per volume.", 1, {}},
      {"solid_fraction", "1", "Volume of particles per volume.", 1, {}},
      {"density", "kg/m3", "Mass of particles per volume.", 1, {}},
      {"velocity", "m/s", "Mean over the mass; nan where there is none.", 3, {}},
      {"solid_flux", "kg/(m2 s)", "Mass that flows through a unit of area per time.", 3, {}},
      {"temperature",
       "m2/s2",
       "Granular temperature: a third of the mean square of the velocity about its mean.",
       1,
       {}},
      {"kinetic_stress", "Pa", "Density times the mean of v' v', v' the velocity about its mean.", 9, {}},
      {"contact_stress", "Pa", "Of the contacts, positive when pressed; rows: force, columns: direction.", 9, {}},
      {"wall_force", "N/m3", "Force of walls and bodies of infinite mass on the particles, per volume.", 3, {}}};
  const double scale = 1 / (a.grid.cell_volume() * static_cast<double>(a.samples));
  for (std::size_t cell = 0; cell < a.grid.size(); ++cell) {
    const double* sums = &a.sums[sum_of::count * cell];
    const auto density = [&](int n) { return scale * sums[n]; };
    const double mass = density(sum_of::mass);
    const auto put = [&](int field, double value) { out[field].values.push_back(value); };
    put(0, density(sum_of::number));
    put(1, density(sum_of::solid));
    put(2, mass);
    Point v;
    for (int k = 0; k < 3; ++k) {
      v[k] = sums[sum_of::mass] > 0 ? sums[sum_of::momentum + k] / sums[sum_of::mass] : nan;
      put(3, v[k]);
      put(4, density(sum_of::momentum + k));
    }
    double trace = 0;
    static constexpr int symmetric[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
    for (int n = 0; n < 9; ++n) {
      const double drift = mass > 0 ? mass * v[n / 3] * v[n % 3] : 0;
      const double kinetic = density(sum_of::flow + symmetric[n]) - drift;
      if (n % 4 == 0) trace += kinetic;
      put(6, kinetic);
      put(7, density(sum_of::contact + n));
    }
    put(5, mass > 0 ? trace / (3 * mass) : nan);
    for (int k = 0; k < 3; ++k) put(8, density(sum_of::wall_force + k));
  }
  return out;
}

}  // namespace scree
