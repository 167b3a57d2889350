#include "scree/app/measures.h"

#include <algorithm>

namespace scree {
namespace {

SurfaceProbe probe_of(const SurfaceKeys& keys) {
  SurfaceProbe out;
  out.min = keys.min;
  out.max = keys.max;
  for (int k = 0; k < 3; ++k) out.cells[k] = static_cast<int>(keys.cells[k]);
  out.downwards = keys.up.front() == '-';
  out.axis = keys.up.back() - 'x';
  out.threshold = keys.solid_fraction;
  return out;
}

/// Whether the axes of bodies have columns: where some are no spheres, or may be, as those of a checkpoint.
bool tells_axes(const Case& c) {
  return has_shapes(c) || std::any_of(c.particles.begin(), c.particles.end(),
                                      [](const ParticleKeys& p) { return p.insert == "checkpoint"; });
}

}  // namespace

std::vector<std::string> measure_columns(const Case& c) {
  std::vector<std::string> out;
  for (const PlaneKeys& plane : c.analysis.planes)
    for (const char* what : {"_count", "_against", "_mass", "_rate"}) out.push_back(plane.name + what);
  for (const SurfaceKeys& surface : c.analysis.surfaces)
    for (const char* what : {"_level", "_angle", "_direction"}) out.push_back(surface.name + what);
  for (const RegionKeys& region : c.analysis.regions) {
    for (const char* what : {"_solid_fraction", "_coordination"}) out.push_back(region.name + what);
    if (!tells_axes(c)) continue;
    for (const char* what : {"_nematic_order", "_cos2_x", "_cos2_y", "_cos2_z"}) out.push_back(region.name + what);
  }
  return out;
}

Measures::Measures(const Case& c, const Clock& clock, const std::filesystem::path& directory, const Archive* archive)
    : axes_(tells_axes(c)), row_time_(clock.now()) {
  for (const PlaneKeys& keys : c.analysis.planes) {
    Plane plane{keys.name, {}, 0};
    if (archive && archive->contains("plane_row_mass_" + keys.name))
      plane.row_mass = archive->number("plane_row_mass_" + keys.name);
    planes_.push_back(std::move(plane));
  }
  if (archive && archive->contains("measures_row_time")) row_time_ = archive->number("measures_row_time");
  for (const SurfaceKeys& keys : c.analysis.surfaces) surfaces_.push_back(probe_of(keys));
  for (const AverageKeys& keys : c.analysis.averages) averages_.emplace_back(c, keys, clock, directory, archive);
}

void Measures::look(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  if (seen_step_ == clock.step) return;
  for (AverageRun& average : averages_) average.look(simulation);
  seen_step_ = clock.step;
}

void Measures::count(Simulation& simulation) {
  const std::vector<PlaneCount> counts = simulation.plane_counts();
  for (std::size_t k = 0; k < planes_.size(); ++k) planes_[k].count = counts[k];
}

std::vector<double> Measures::row(Simulation& simulation, const std::vector<RegionFacts>& regions) {
  const double time = simulation.clock().now();
  std::vector<double> out;
  for (Plane& plane : planes_) {
    const PlaneCount& count = plane.count;
    const double mass = count.mass.value();
    const double rate = time > row_time_ ? (mass - plane.row_mass) / (time - row_time_) : 0;
    out.insert(out.end(),
               {static_cast<double>(count.along - count.against), static_cast<double>(count.against), mass, rate});
    plane.row_mass = mass;
  }
  row_time_ = time;
  for (const SurfaceProbe& probe : surfaces_) {
    const Surface found = find_surface(probe, simulation.whole().particles);
    out.insert(out.end(), {found.level, found.angle, found.direction});
  }
  for (const RegionFacts& region : regions) {
    out.insert(out.end(), {region.solid_fraction, region.coordination});
    if (!axes_) continue;
    out.push_back(region.axes.nematic);
    out.insert(out.end(), region.axes.cos2.begin(), region.axes.cos2.end());
  }
  return out;
}

void Measures::finish() {
  for (AverageRun& average : averages_) average.finish();
}

void Measures::save(Archive& archive) const {
  if (!planes_.empty()) archive.set("measures_row_time", row_time_);
  for (const Plane& plane : planes_) {
    archive.put("plane_" + plane.name, numbers_of(plane.count));
    archive.set("plane_row_mass_" + plane.name, plane.row_mass);
  }
  for (const AverageRun& average : averages_) average.save(archive);
}

}  // namespace scree
