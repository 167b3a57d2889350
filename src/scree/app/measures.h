// What a case measures beyond the ledger: counting planes, free surfaces, regions, averages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scree/analysis/planes.h"
#include "scree/analysis/surface.h"
#include "scree/app/average_run.h"
#include "scree/app/simulation.h"

namespace scree {

/// The columns of the series that planes, surfaces and regions of the case fill.
std::vector<std::string> measure_columns(const Case& c);

class Measures {
 public:
  /// Begins, or goes on from what save() put into `archive`; what the archive does not know begins now.
  Measures(const Case& c, const Clock& clock, const std::filesystem::path& directory, const Archive* archive);

  /// Looks at the present step, once. Must see the first state, and every step after it.
  void look(Simulation& simulation);

  /// Takes up what the planes have counted so far, for row() and save().
  void count(Simulation& simulation);

  /// Values of measure_columns() for a row, `regions` among them; rates are those since the row before.
  std::vector<double> row(Simulation& simulation, const std::vector<RegionFacts>& regions);

  /// Writes what is incomplete.
  void finish();

  void save(Archive& archive) const;

 private:
  /// A plane, and what its last row of the series said.
  struct Plane {
    std::string name;
    PlaneCount count;
    double row_mass = 0;  // [kg]
  };

  std::vector<Plane> planes_;
  std::vector<SurfaceProbe> surfaces_;
  std::vector<AverageRun> averages_;
  bool axes_ = false;    // whether regions have columns of them
  double row_time_ = 0;  // of the last row [s]
  std::int64_t seen_step_ = -1;
};

}  // namespace scree
