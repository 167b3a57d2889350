#include "scree/app/columns.h"

#include <algorithm>
#include <limits>

#include "scree/app/build_exchange.h"
#include "scree/app/build_heat.h"
#include "scree/app/coupling_columns.h"
#include "scree/app/measures.h"
#include "scree/base/version.h"

namespace scree {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double whole(std::int64_t n) { return static_cast<double>(n); }

}  // namespace

std::string program_name() { return std::string("scree ") + version; }

double mean_impact_speed(std::int64_t count, std::int64_t sum) {
  return count > 0 ? whole(sum) * speed_quantum / whole(count) : nan;
}

std::vector<std::string> series_columns(const Case& c) {
  std::vector<std::string> names = {"time",
                                    "step",
                                    "kinetic_energy",
                                    "rotational_energy",
                                    "elastic_energy",
                                    "cohesive_energy",
                                    "gravitational_energy",
                                    "dissipated_normal",
                                    "dissipated_sliding",
                                    "dissipated_rolling",
                                    "work_drag",
                                    "work_prescribed",
                                    "work_walls",
                                    "energy_error",
                                    "energy_turnover",
                                    "momentum_x",
                                    "momentum_y",
                                    "momentum_z",
                                    "momentum_error",
                                    "angular_momentum_x",
                                    "angular_momentum_y",
                                    "angular_momentum_z",
                                    "angular_momentum_error",
                                    "particles",
                                    "contacts",
                                    "max_overlap",
                                    "max_speed",
                                    "mean_speed",
                                    "collision_speed",
                                    "stickiness"};
  if (is_hard(c)) names.insert(names.end(), {"work_relocation", "collisions"});
  if (!build_feeds(c).empty() || !c.outlets.empty())
    names.insert(names.end(), {"inserted_count", "inserted_mass", "inserted_energy", "removed_count", "removed_mass",
                               "removed_energy"});
  for (const OutletKeys& outlet : c.outlets)
    names.insert(names.end(), {"outlet_" + outlet.name + "_count", "outlet_" + outlet.name + "_mass"});
  if (c.analysis.agglomerates)
    names.insert(names.end(), {"agglomerates", "agglomerated_fraction", "largest_agglomerate", "mean_agglomerate_size",
                               "mean_radius_of_gyration", "spanning_agglomerates", "fractal_dimension",
                               "fractal_dimension_error", "coordination_number"});
  for (const WallKeys& wall : c.walls)
    for (const char* quantity : {"force", "torque"})
      for (const char axis : {'x', 'y', 'z'}) names.push_back(wall.name + "_" + quantity + "_" + axis);
  const std::vector<std::string> measures = measure_columns(c), heat = heat_columns(c), fluid = coupled_columns(c);
  names.insert(names.end(), measures.begin(), measures.end());
  names.insert(names.end(), heat.begin(), heat.end());
  names.insert(names.end(), fluid.begin(), fluid.end());
  return names;
}

PassedRow passed_of(const Exchange& exchange) {
  const Passage& p = exchange.passage();
  PassedRow row{p.inserted.count, p.removed.count, p.inserted.mass.value(), p.removed.mass.value(), {}};
  for (const OutletCount& outlet : exchange.outlet_counts())
    row.outlets.emplace_back(outlet.count, outlet.mass.value());
  return row;
}

std::vector<double> values_of(const SeriesRow& r) {
  const Measured& m = r.measured;
  std::vector<double> v = {r.time,
                           whole(r.step),
                           m.kinetic,
                           m.rotational,
                           m.elastic,
                           m.cohesive,
                           -m.body_work,
                           m.dissipated_normal,
                           m.dissipated_sliding,
                           m.dissipated_rolling,
                           m.drag_work,
                           m.prescribed_work,
                           m.wall_work,
                           r.balance.energy_error,
                           r.balance.turnover,
                           m.momentum[0],
                           m.momentum[1],
                           m.momentum[2],
                           r.balance.momentum_error,
                           m.angular_momentum[0],
                           m.angular_momentum[1],
                           m.angular_momentum[2],
                           r.balance.angular_momentum_error,
                           whole(r.particles),
                           whole(r.contacts),
                           r.max_overlap,
                           r.speeds.largest,
                           r.speeds.mean,
                           r.collision_speed,
                           r.stickiness};
  if (r.hard) v.insert(v.end(), {r.hard->work_relocation, whole(r.hard->collisions)});
  if (const auto& p = r.passed) {
    v.insert(v.end(), {whole(p->inserted_count), p->inserted_mass, m.inserted, whole(p->removed_count), p->removed_mass,
                       m.removed});
    for (const auto& [count, mass] : p->outlets) v.insert(v.end(), {whole(count), mass});
  }
  if (const auto& a = r.agglomerates)
    v.insert(v.end(), {whole(a->agglomerates), a->agglomerated_fraction, whole(a->largest_agglomerate),
                       a->mean_agglomerate_size, a->mean_radius_of_gyration, whole(a->spanning_agglomerates),
                       a->fractal_dimension, a->fractal_dimension_error, a->coordination_number});
  for (const WallLoad& load : r.wall_loads) {
    v.insert(v.end(), load.force.begin(), load.force.end());
    v.insert(v.end(), load.torque.begin(), load.torque.end());
  }
  v.insert(v.end(), r.measures.begin(), r.measures.end());
  v.insert(v.end(), r.heat.begin(), r.heat.end());
  v.insert(v.end(), r.fluid.begin(), r.fluid.end());
  return v;
}

std::vector<std::string> track_columns() {
  return {"time", "id", "x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "fx", "fy", "fz"};
}

std::vector<double> track_rows(const Sample& sample, const std::vector<std::uint64_t>& ids, double time) {
  const Particles& p = sample.system.particles;
  std::vector<double> out;
  for (const std::uint64_t wanted : ids)
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.id[i] != static_cast<std::int64_t>(wanted)) continue;
      const double *m = p.motion.row(i), *spin = p.spin.row(i), *force = &sample.force[4 * i];
      out.insert(out.end(), {time, static_cast<double>(wanted), m[0], m[1], m[2], m[4], m[5], m[6], spin[0] * spin[3],
                             spin[1] * spin[3], spin[2] * spin[3], force[0], force[1], force[2]});
    }
  return out;
}

std::vector<std::string> size_columns() { return {"time", "size", "count"}; }

void append_sizes(SeriesWriter& writer, double time, const std::map<std::int64_t, std::int64_t>& count_by_size) {
  std::vector<double> rows;
  for (const auto& [size, count] : count_by_size) rows.insert(rows.end(), {time, whole(size), whole(count)});
  writer.append(rows);
}

}  // namespace scree
