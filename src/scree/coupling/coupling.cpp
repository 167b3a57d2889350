#include "scree/coupling/coupling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scree/base/exact_sum.h"
#include "scree/compute/launch.h"
#include "scree/coupling/beyond_mean.h"
#include "scree/coupling/crowding.h"
#include "scree/coupling/forces.h"
#include "scree/coupling/heat.h"
#include "scree/coupling/passage.h"
#include "scree/data/form_surface.h"
#include "scree/fluid/halo.h"
#include "scree/physics/math.h"
#include "scree/physics/vec.h"

namespace scree {
namespace {

using Vector = std::array<double, 3>;

double volume_of(const Particles& p, std::size_t i) {
  const double r = p.radius_by_volume(i);
  return 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

/// What the particles say to the fluid in a step, and what is known of them on the way.
struct Exchanged {
  Quantity volume{{}, 1, 1}, motion{{}, 3, 1}, drag{{}, 1, 1}, push{{}, 3, 1}, surplus{{}, 3, 1};
  Quantity stream{{}, 3, 1};   // drag times the velocity of the fluid that each meets at the start of the step
  std::vector<double> kappa;   // of each particle [kg/s]
  std::vector<double> lift;    // of each particle, three numbers: forces that go with the slip as drag does [N]
  std::vector<double> rubbed;  // the same, by friction within the fluid [N]
  Vector returned{};           // in the cells of this rank [N s]
  CellBox box;
  std::int64_t count = 0;  // of particles on all ranks
};

/// The impulse of the fluid on a particle since its last step [N s]. One that forces of others hold or move as
/// prescribed has received what was promised, and what the fluid does that goes along: whoever holds it pays for it.
Vector received(const Particles& p, std::size_t i) {
  const bool held = p.motion.row(i)[lane::inverse_mass] == 0;
  const double *got = held ? p.expected.row(i) : p.drag_impulse.row(i), *pull = p.pull.row(i);
  const double acted = p.mass[i] * p.drag_impulse.row(i)[3];
  return {got[0] + acted * pull[0], got[1] + acted * pull[1], got[2] + acted * pull[2]};
}

/// What each particle has received beyond what the fluid has counted on, into `surplus`; and which part of its drag at
/// the start of a step it feels in the mean of the step: the fluid counts on this next time.
void take_stock(const FluidCoupling& c, Particles& p, Quantity& surplus) {
  const double dt = c.settings.fluid_step();
  surplus.values.resize(3 * p.size());
  launch(p.size(), [&](std::size_t i) {
    const Vector got = received(p, i);
    const double *drag = p.drag_impulse.row(i), *stream = p.stream.row(i), *before = p.before.row(i);
    const double* v = p.motion.row(i) + lane::vx;
    double* promised = p.expected.row(i);
    for (int a = 0; a < 3; ++a) surplus.values[3 * i + a] = got[a] - promised[a];
    // What drag has done, without the force that the added mass takes; and what it would have by the slip at the start.
    double along = 0, full = 0;
    for (int a = 0; a < 3; ++a) {
      const double at_start = p.mass[i] * stream[3] * dt * (stream[a] - before[a]);
      along += (drag[a] + p.mass[i] * before[3] * (v[a] - before[a])) * at_start;
      full += at_start * at_start;
    }
    promised[3] = full > 0 ? along / full : 0;
  });
}

}  // namespace

void read_component(const Mesh& m, const Deposits& sums, int component, double scale, Field& out) {
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    const std::int64_t from = sums.offset(m.box.low[0], m.box.low[1] + j, m.box.low[2] + k) + component;
    for (int i = 0; i < m.n[0]; ++i)
      out[at + i] =
          static_cast<double>(sums.values[static_cast<std::size_t>(from + std::int64_t{i} * sums.width)]) / scale;
  });
}

namespace {

/// What has passed the faces of the cells: with the particles, which `sums` says, and by what spreads and relieves them
/// further, as much as that has changed since the last step.
void load_passed(FluidCoupling& c, const Exchanged& x, const Deposits& sums, const Field& old_levels,
                 const Field& old_surpluses) {
  const Mesh& m = c.fluid.mesh;
  Field levels = m.make_field(), surpluses = m.make_field();
  for (std::int64_t at = 0; at < m.size; ++at) {
    levels[at] = c.levels[at] - old_levels[at];
    surpluses[at] = (c.surpluses[at] - old_surpluses[at]) / 6;
  }
  renew_ghosts(m, c.fluid.ranks, 1, {&levels, &surpluses});
  VectorField& passed = c.fluid.load.passed;
  for (int a = 0; a < 3; ++a) {
    read_component(m, sums, a, x.volume.scale, passed[a]);
    const std::int64_t st = m.stride[a];
    for_each_row(m, [&](int j, int k) {
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t at = m.index(i, j, k);
        const double spread = c.diffusion.length2 > 0 ? c.diffusion.face[a][at] : 0;
        passed[a][at] += spread * (levels[at - st] - levels[at]) + m.open[a][at] * (surpluses[at - st] - surpluses[at]);
      }
    });
  }
}

/// See part_made_way_for(): for particles that can give way, as drag and added mass were in the fluid's last step.
/// Those that it has not met yet do not count.
double find_part(const FluidCoupling& c, const Particles& p, const Quantity& volume, double solids) {
  double heaviness = 0, relaxation = 0;
#pragma omp parallel for schedule(static) reduction(max : heaviness, relaxation)
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.motion.row(i)[lane::inverse_mass] == 0 || p.met_at.row(i)[3] == 0) continue;
    const double carried = 1 + p.before.row(i)[3];
    heaviness = std::max(heaviness, c.fluid.settings.density * volume.values[i] / (p.mass[i] * carried));
    relaxation = std::max(relaxation, c.settings.fluid_step() * p.stream.row(i)[3] / carried);
  }
  const Ranks& ranks = c.fluid.ranks;
  return part_made_way_for(solids, ranks.largest(heaviness), ranks.largest(relaxation));
}

/// The void fraction from the volumes of the particles, and their volume flux. At once, or as the fluid makes way.
void find_fraction(FluidCoupling& c, const Particles& p, Exchanged& x, bool at_once) {
  const Mesh& m = c.fluid.mesh;
  x.box = c.fluid.ranks.alone() ? m.box : touched_cells(c.spreading, p);
  x.count = c.fluid.ranks.total(static_cast<std::int64_t>(p.size()));
  x.volume.values.resize(p.size());
  launch(p.size(), [&](std::size_t i) { x.volume.values[i] = volume_of(p, i); });
  x.volume.scale = scale_for(x.volume, x.count, c.fluid.ranks);
  Deposits mine;
  const std::vector<std::uint8_t> known = spread_passage(c.spreading, p, x.volume, x.box, mine);
  const Deposits passed = c.exchange.collect(mine);
  x.motion.values.resize(3 * p.size());
  launch(p.size(), [&](std::size_t i) {
    // Those of whom nothing is known at the faces count for nothing in the cells.
    const double counted = known[i] ? x.volume.values[i] : 0;
    for (int a = 0; a < 3; ++a) x.motion.values[3 * i + a] = counted * p.motion.row(i)[lane::vx + a];
  });
  x.motion.scale = scale_for(x.motion, x.count, c.fluid.ranks);
  spread(c.spreading, p, {&x.volume, &x.motion}, x.box, mine);
  const Deposits sums = c.exchange.collect(mine);
  for (int a = 0; a < 3; ++a) read_component(m, sums, 1 + a, x.motion.scale, c.amounts[a]);
  diffuse(c.diffusion, m, c.fluid.ranks, c.amounts, c.densities);
  read_component(m, sums, 0, x.volume.scale, c.amounts[0]);
  const Field old_levels = c.levels, old_surpluses = c.surpluses;
  Field& solids = c.way.solids;
  diffuse(c.diffusion, m, c.fluid.ranks, std::span(c.amounts).first(1), std::span(&solids, 1), &c.levels);
  const Crowding crowding = relieve_crowding(m, c.fluid.ranks, 1 - c.settings.least_fraction, solids, c.surpluses);
  load_passed(c, x, passed, old_levels, old_surpluses);
  FluidLoad& load = c.fluid.load;
  c.way.part = at_once ? 1 : find_part(c, p, x.volume, crowding.densest);
  make_way(c.way, m, c.densities, load);
  renew_ghosts(m, c.fluid.ranks, 1, {&load.passed[0], &load.passed[1], &load.passed[2]});
  c.books.crowded += static_cast<double>(crowding.cells);
  c.books.least_fraction = 1 - crowding.densest;
}

}  // namespace

std::vector<double> meet(FluidCoupling& c, const Particles& p, const CellBox& box,
                         const std::vector<const VectorField*>& vectors, bool with_fraction) {
  const Mesh& m = c.fluid.mesh;
  std::vector<VectorField> smooth;
  std::vector<const Field*> fields;
  for (const VectorField* v : vectors) {
    if (c.diffusion.length2 == 0) {
      for (int a = 0; a < 3; ++a) fields.push_back(&(*v)[a]);
      continue;
    }
    smooth.push_back(m.make_vector());
    for (int a = 0; a < 3; ++a)
      for_each_row(m, [&](int j, int k) {
        for (int i = 0; i < m.n[0]; ++i) {
          const std::int64_t at = m.index(i, j, k);
          c.amounts[a][at] = m.fluid[at] * (*v)[a][at] * m.cell_volume(i, j, k);
        }
      });
    diffuse(c.diffusion, m, c.fluid.ranks, c.amounts, smooth.back());
  }
  for (const VectorField& v : smooth)
    for (int a = 0; a < 3; ++a) fields.push_back(&v[a]);
  if (with_fraction) fields.push_back(&c.fluid.load.fraction);
  std::vector<double> out;
  read_at(c.spreading, p, c.exchange.fetch(box, fields), out);
  return out;
}

namespace {

void put(sc_vec from, double* to) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

/// What turns particles until the fluid's next step.
void note_gradient(const FluidThere& there, double* to) {
  put(there.gradient.x, to);
  put(there.gradient.y, to + 3);
  put(there.gradient.z, to + 6);
  to[9] = there.voidage;
}

/// Drag and lift of every particle at the start of the step, and what the fluid counts on of it.
void find_drag(FluidCoupling& c, Particles& p, Exchanged& x) {
  const StreamFields fields = find_stream(c);
  const std::vector<double> met = meet(c, p, x.box, fields.with(c.fluid.state.velocity), true);
  const std::size_t width = static_cast<std::size_t>(fields.width());
  x.kappa.resize(p.size());
  x.lift.resize(3 * p.size());
  x.rubbed.resize(3 * p.size());
  x.drag.values.resize(p.size());
  x.push.values.resize(3 * p.size());
  x.stream.values.resize(3 * p.size());
  launch(p.size(), [&](std::size_t i) {
    const double* v = p.motion.row(i) + lane::vx;
    const FluidThere there = stream_there(c, fields, &met[width * i]);
    const FluidPush push = push_of_fluid(c.settings.forces, p, i, there);
    x.kappa[i] = push.drag;
    put(push.force, &x.lift[3 * i]);
    put(sc_scale(x.volume.values[i], friction_there(fields, &met[width * i])), &x.rubbed[3 * i]);
    if (p.turned()) note_gradient(there, p.gradient.row(i));
    double* before = p.before.row(i);
    std::copy_n(v, 3, before);
    before[3] = added_mass_of(c.settings.forces, p, i, there) / p.mass[i];
    const double heavy = p.mass[i] * (1 + before[3]);
    // Free of other forces a particle keeps so much of its slip in the mean; one that is held keeps all.
    double& share = p.expected.row(i)[3];
    const bool held = p.motion.row(i)[lane::inverse_mass] == 0;
    share = held ? 1 : std::clamp(share, sc_phi1(x.kappa[i] / heavy * c.settings.fluid_step()), 1.0);
    x.drag.values[i] = share * x.kappa[i];
    for (int a = 0; a < 3; ++a) {
      x.push.values[3 * i + a] = x.drag.values[i] * v[a] - share * x.lift[3 * i + a] - x.rubbed[3 * i + a];
      x.stream.values[3 * i + a] = x.drag.values[i] * met[width * i + a];
    }
  });
}

/// Drag, and what pushes, in the cells of the fluid.
void load_fluid(FluidCoupling& c, const Particles& p, Exchanged& x) {
  const Mesh& m = c.fluid.mesh;
  const Ranks& ranks = c.fluid.ranks;
  FluidLoad& load = c.fluid.load;
  const std::vector<double> beyond =
      beyond_mean(c, p, x.box, x.count, x.drag, x.stream, c.fluid.state.velocity, load.drag);
  launch(p.size(), [&](std::size_t i) {
    for (int a = 0; a < 3; ++a) x.push.values[3 * i + a] += x.drag.values[i] * beyond[3 * i + a];
  });
  for (Quantity* q : {&x.push, &x.surplus}) q->scale = scale_for(*q, x.count, ranks);
  Deposits mine;
  spread(c.spreading, p, {&x.push, &x.surplus}, x.box, mine);
  const Deposits sums = c.exchange.collect(mine);
  const double per_dt = 1 / c.settings.fluid_step();
  Field surplus = m.make_field();
  for (int a = 0; a < 3; ++a) {
    read_component(m, sums, a, x.push.scale, c.amounts[a]);
    read_component(m, sums, 3 + a, x.surplus.scale, surplus);
    for (std::int64_t at = 0; at < m.size; ++at) c.amounts[a][at] -= per_dt * (surplus[at] + c.returned[a][at]);
    for (const double back : c.returned[a]) x.returned[a] += back;
    std::fill(c.returned[a].begin(), c.returned[a].end(), 0.0);
  }
  diffuse(c.diffusion, m, ranks, c.amounts, load.push);
}

/// What the cells have given away in the step, drag, and pressure on what is there; of this rank [N s].
Vector given_away(const FluidCoupling& c) {
  const Mesh& m = c.fluid.mesh;
  const FluidLoad& load = c.fluid.load;
  Vector sum{};
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t at = m.index(i, j, k);
        if (m.fluid[at] == 0) continue;
        const double volume = m.cell_volume(i, j, k), solids = c.settings.pressure ? c.way.solids[at] : 0;
        for (int a = 0; a < 3; ++a)
          sum[a] += volume *
                    (load.drag[at] * c.fluid.state.velocity[a][at] - load.push[a][at] - solids * load.gradient[a][at]);
      }
  for (double& s : sum) s *= c.settings.fluid_step();
  return sum;
}

/// Tells every particle what it will meet and what the fluid counts on.
void promise(FluidCoupling& c, Particles& p, const Exchanged& x) {
  std::vector<const VectorField*> vectors = {&c.fluid.state.velocity, &c.fluid.load.gradient};
  VectorField acceleration;
  if (c.settings.forces.added_mass) {
    acceleration = c.fluid.mesh.make_vector();
    find_acceleration(c.fluid, acceleration);
    vectors.push_back(&acceleration);
  }
  const std::vector<double> met = meet(c, p, x.box, vectors, false);
  const std::size_t width = 3 * vectors.size();
  const double dt = c.settings.fluid_step();
  launch(p.size(), [&](std::size_t i) {
    const double *u = &met[width * i], *gradient = u + 3, *m = p.motion.row(i);
    double *stream = p.stream.row(i), *pull = p.pull.row(i), *promised = p.expected.row(i);
    const double by_pressure = c.settings.pressure ? -x.volume.values[i] : 0;
    const bool held = m[lane::inverse_mass] == 0;
    for (int a = 0; a < 3; ++a) {
      const double lift = x.lift[3 * i + a], steady = by_pressure * gradient[a] + x.rubbed[3 * i + a];
      stream[a] = u[a];
      promised[a] = dt * (x.drag.values[i] * (u[a] - m[lane::vx + a]) + promised[3] * lift + steady);
      // One that is held does not move by what it has been promised; what goes along is promised to none.
      pull[a] = held ? 0 : (steady + lift) / p.mass[i];
      if (width > 6) pull[a] += p.before.row(i)[3] * u[6 + a];
    }
    stream[3] = x.kappa[i] / p.mass[i];
    std::fill_n(p.drag_impulse.row(i), 4, 0.0);
  });
}

/// Compares what the cells have given with what the particles are promised.
void close_books(FluidCoupling& c, const Particles& p, const Exchanged& x) {
  ExactVectorSum promised, surplus;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double *e = p.expected.row(i), *s = &x.surplus.values[3 * i];
    promised.add(e[0], e[1], e[2]);
    surplus.add(s[0], s[1], s[2]);
  }
  const Vector given = given_away(c), asked = {promised.x.value(), promised.y.value(), promised.z.value()},
               more = {surplus.x.value(), surplus.y.value(), surplus.z.value()};
  for (int a = 0; a < 3; ++a) {
    const Ranks& ranks = c.fluid.ranks;
    c.books.error[a] += ranks.sum(given[a]) - ranks.sum(asked[a]) - ranks.sum(more[a] + x.returned[a]);
    c.books.turned += std::abs(ranks.sum(asked[a]));
  }
}

}  // namespace

FluidCoupling::FluidCoupling(const FluidRegion& region, FluidSettings k, const CouplingSettings& how,
                             const Forms& forms, const Ranks& ranks)
    : settings(how),
      fluid(region, std::move(k), ranks),
      spreading(fluid.region, forms),
      exchange(fluid.mesh, fluid.ranks),
      returned(fluid.mesh.make_vector()),
      way{1, fluid.mesh.make_field(), fluid.mesh.make_vector()},
      levels(fluid.mesh.make_field()),
      surpluses(fluid.mesh.make_field()),
      amounts(fluid.mesh.make_vector()),
      densities(fluid.mesh.make_vector()) {
  know_shapes(settings.forces, forms);
  for (const Form& form : forms) surface_over_sphere.push_back(1 / sphericity(form));
  if (forms.empty()) surface_over_sphere.push_back(1);
  if (settings.diffusion > 0) diffusion = make_diffusion(fluid.mesh, fluid.ranks, settings.diffusion);
}

void begin_coupling(FluidCoupling& c, Particles& p, const std::array<PlaceFormula, 3>& velocity) {
  // The first step of the fluid meets the particles where they are; before, they were where they come from, or the
  // fluid that makes way for them would have come to rest in between.
  Particles before = p;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int a = 0; a < 3; ++a) before.motion.row(i)[a] -= c.settings.fluid_step() * p.motion.row(i)[lane::vx + a];
  note_meeting(before);
  Exchanged x;
  find_fraction(c, before, x, true);
  set_velocity(c.fluid, velocity);
  p.met_at = before.met_at;
  p.met_turned = before.met_turned;
}

void hand_back(FluidCoupling& c, const Particles& p, const std::vector<std::uint8_t>& gone) {
  const Ranks& ranks = c.fluid.ranks;
  if (ranks.all(gone.empty())) return;
  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (gone[i]) order.push_back(static_cast<std::uint32_t>(i));
  Particles leaving = p;
  leaving.permute(order);
  Quantity surplus{{}, 3, 1};
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    const Vector got = received(leaving, i);
    for (int a = 0; a < 3; ++a) surplus.values.push_back(got[a] - leaving.expected.row(i)[a]);
  }
  surplus.scale = scale_for(surplus, ranks.total(static_cast<std::int64_t>(leaving.size())), ranks);
  Deposits mine;
  spread(c.spreading, leaving, {&surplus}, ranks.alone() ? c.fluid.mesh.box : touched_cells(c.spreading, leaving),
         mine);
  const Deposits sums = c.exchange.collect(mine);
  Field more = c.fluid.mesh.make_field();
  for (int a = 0; a < 3; ++a) {
    read_component(c.fluid.mesh, sums, a, surplus.scale, more);
    for (std::int64_t at = 0; at < c.fluid.mesh.size; ++at) c.returned[a][at] += more[at];
  }
}

void advance_fluid(FluidCoupling& c, Particles& p) {
  Exchanged x;
  take_stock(c, p, x.surplus);
  find_fraction(c, p, x, false);
  find_drag(c, p, x);
  load_fluid(c, p, x);
  const HeatPromise heat = load_heat(c, p, x.box);
  c.report = advance(c.fluid, c.settings.fluid_step());
  promise(c, p, x);
  if (c.settings.pressure && c.way.part < 1)
    settle_pressure(c.way, c.fluid.mesh, c.fluid.load, c.settings.fluid_step(), c.returned);
  keep_promise(c, heat, x.box, p);
  close_books(c, p, x);
  note_meeting(p);
}

std::array<double, 3> under_way(const FluidCoupling& c, const Particles& p) {
  ExactVectorSum sum;
  const Mesh& m = c.fluid.mesh;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t at = m.index(i, j, k);
        sum.add(-c.returned[0][at], -c.returned[1][at], -c.returned[2][at]);
      }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector got = received(p, i);
    const double* promised = p.expected.row(i);
    sum.add(promised[0] - got[0], promised[1] - got[1], promised[2] - got[2]);
  }
  return {sum.x.value(), sum.y.value(), sum.z.value()};
}

}  // namespace scree
