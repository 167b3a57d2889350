#include "scree/app/fluid_checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/hash.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/whole.h"

namespace scree {
namespace {

constexpr const char* axes = "xyz";

/// Calls visit(name, axis or 3, field) for all that a checkpoint holds.
template <class State, class Visit>
void for_each_field(State& s, Visit&& visit) {
  for (int a = 0; a < 3; ++a) {
    visit(fmt::format("fluid_velocity_{}", axes[a]), 3, s.velocity[a]);
    visit(fmt::format("fluid_velocity_old_{}", axes[a]), 3, s.velocity_old[a]);
    visit(fmt::format("fluid_flux_{}", axes[a]), a, s.flux[a]);
    visit(fmt::format("fluid_flux_old_{}", axes[a]), a, s.flux_old[a]);
  }
  visit("fluid_pressure", 3, s.pressure);
  for (std::size_t n = 0; n < s.corrections.size(); ++n)
    visit(fmt::format("fluid_correction{}", n), 3, s.corrections[n]);
  visit("fluid_fraction", 3, s.fraction);
  visit("fluid_fraction_old", 3, s.fraction_old);
  for (std::size_t n = 0; n < s.scalars.size(); ++n) {
    visit(fmt::format("fluid_scalar{}", n), 3, s.scalars[n].value);
    visit(fmt::format("fluid_scalar{}_old", n), 3, s.scalars[n].value_old);
  }
  for (int a = 0; a < 3 && !s.solids_flux[a].empty(); ++a) {
    visit(fmt::format("fluid_solids_passed_{}", axes[a]), a, s.solids_passed[a]);
    visit(fmt::format("fluid_solids_flux_{}", axes[a]), a, s.solids_flux[a]);
    visit(fmt::format("fluid_solids_flux_old_{}", axes[a]), a, s.solids_flux_old[a]);
    visit(fmt::format("fluid_solids_beyond_{}", axes[a]), a, s.solids_beyond[a]);
    visit(fmt::format("fluid_solids_beyond_old_{}", axes[a]), a, s.solids_beyond_old[a]);
  }
  if (s.eddies_found.empty()) return;
  visit("fluid_eddies_found", 3, s.eddies_found);
  visit("fluid_eddies_modelled", 3, s.eddies_modelled);
}

/// What particles have done to the fluid, and what it has of those that have left. Calls visit(name, field).
template <class Coupling, class Visit>
void for_each_shared_field(Coupling& c, Visit&& visit) {
  visit("coupling_drag", c.fluid.load.drag);
  visit("coupling_levels", c.levels);
  visit("coupling_surpluses", c.surpluses);
  for (int a = 0; a < 3; ++a) {
    visit(fmt::format("coupling_push_{}", axes[a]), c.fluid.load.push[a]);
    visit(fmt::format("coupling_solids_{}", axes[a]), c.fluid.load.solids[a]);
    visit(fmt::format("coupling_returned_{}", axes[a]), c.returned[a]);
    visit(fmt::format("coupling_owed_{}", axes[a]), c.way.owed[a]);
  }
}

std::vector<double> gather(const FluidSolver& s, int axis, const Field& field) {
  return axis == 3 ? gather_cells(s, field) : gather_faces(s, axis, field);
}

}  // namespace

Archive save_fluid(const FluidSolver& s) {
  Archive out;
  out.set("step", s.state.step);
  out.set("time", s.state.time);
  out.set("time_step", s.state.last_dt);
  put_fluid(s, out);
  return out;
}

void put_fluid(const FluidSolver& s, Archive& out) {
  out.set("fluid_step", s.state.step);
  out.set("fluid_time", s.state.time);
  out.set("fluid_time_step", s.state.last_dt);
  out.set("fluid_pace", s.state.pace);
  for_each_field(s.state,
                 [&](const std::string& name, int axis, const Field& field) { out.put(name, gather(s, axis, field)); });
  const FluidBooks& b = s.state.books;
  std::vector<double> books;
  for (const auto& row : {b.content, b.change, b.error, b.turned}) books.insert(books.end(), row.begin(), row.end());
  books.insert(books.end(), {b.kinetic, b.kinetic_start});
  for (const auto& row : {b.work, b.power}) books.insert(books.end(), row.begin(), row.end());
  for (const ScalarState& scalar : s.state.scalars)
    books.insert(books.end(), {scalar.books.content, scalar.books.change, scalar.books.error, scalar.books.turned});
  out.put("fluid_books", std::move(books));
}

void restore_fluid(FluidSolver& s, const Archive& archive) {
  FluidState& st = s.state;
  st.step = archive.integer("fluid_step");
  st.time = archive.number("fluid_time");
  st.last_dt = archive.number("fluid_time_step");
  st.pace = archive.number("fluid_pace");
  for_each_field(st, [&](const std::string& name, int axis, Field& field) {
    const std::span<const double> whole = archive.get<double>(name);
    if (axis == 3) {
      scatter_cells(s, whole, field);
      renew_ghosts(s.mesh, s.ranks, Mesh::ghosts, {&field});
    } else {
      scatter_faces(s, axis, whole, field);
    }
  });
  const std::span<const double> books = archive.get<double>("fluid_books");
  auto from = books.begin();
  for (auto* row : {&st.books.content, &st.books.change, &st.books.error, &st.books.turned}) {
    std::copy_n(from, row->size(), row->begin());
    from += static_cast<std::ptrdiff_t>(row->size());
  }
  st.books.kinetic = *from++;
  st.books.kinetic_start = *from++;
  for (auto* row : {&st.books.work, &st.books.power}) {
    std::copy_n(from, row->size(), row->begin());
    from += static_cast<std::ptrdiff_t>(row->size());
  }
  for (ScalarState& scalar : st.scalars) {
    scalar.books = {from[0], from[1], from[2], from[3]};
    from += 4;
  }
  refresh(s);
  // The boundary as it was, not as it is at the rounded time.
  for (int a = 0; a < 3; ++a)
    scatter_faces(s, a, archive.get<double>(fmt::format("fluid_flux_{}", axes[a])), s.state.flux[a]);
}

void save_averages(const FluidSolver& s, const FluidAverages& averages, Archive& archive) {
  archive.set("fluid_average_time", averages.time);
  for_each_average(averages,
                   [&](const std::string& name, const Field& field) { archive.put(name, gather_cells(s, field)); });
}

void restore_averages(const FluidSolver& s, const Archive& archive, FluidAverages& averages) {
  averages.time = archive.number("fluid_average_time");
  for_each_average(averages,
                   [&](const std::string& name, Field& field) { scatter_cells(s, archive.get<double>(name), field); });
}

void put_coupling(const FluidCoupling& coupling, Archive& out) {
  put_fluid(coupling.fluid, out);
  for_each_shared_field(coupling, [&](const std::string& name, const Field& field) {
    out.put(name, gather_cells(coupling.fluid, field));
  });
  const CouplingBooks& b = coupling.books;
  out.put("coupling_books",
          std::vector<double>{b.error[0], b.error[1], b.error[2], b.turned, b.crowded, b.least_fraction, b.heat_error,
                              b.heat_to_particles, coupling.way.part});
}

std::optional<int> saved_subcycles(const Archive& archive) {
  const double fluid = archive.number("fluid_time_step");
  if (!(fluid > 0)) return {};
  return static_cast<int>(std::lround(fluid / archive.number("time_step")));
}

void restore_coupling(FluidCoupling& coupling, const Archive& archive) {
  for_each_shared_field(coupling, [&](const std::string& name, Field& field) {
    scatter_cells(coupling.fluid, archive.get<double>(name), field);
  });
  restore_fluid(coupling.fluid, archive);
  coupling.fluid.load.fraction = coupling.fluid.state.fraction;
  const std::span<const double> b = archive.get<double>("coupling_books");
  coupling.books = {{b[0], b[1], b[2]}, b[3], b[4], b[5], b[6], b[7]};
  coupling.way.part = b[8];
}

std::string fluid_hash(const FluidSolver& s) {
  Sha256 hash;
  const auto add = [&](const double* x, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const double plain = x[i] + 0.0;  // -0 and 0 are the same state
      hash.update(&plain, sizeof plain);
    }
  };
  add(&s.state.time, 1);
  for_each_field(s.state, [&](const std::string&, int axis, const Field& field) {
    const std::vector<double> whole = gather(s, axis, field);
    add(whole.data(), whole.size());
  });
  return hash.hex();
}

}  // namespace scree
