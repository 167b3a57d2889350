// What a run left behind, as one table: the columns of series.csv and of every followed particle, row by row in time.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace scree {

/// Columns of equal length by name: those of the series as they are, those of particle ID as "pID.x", "pID.vx" ...
struct ResultTable {
  std::map<std::string, std::vector<double>> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.begin()->second.size(); }
};

/// Reads series.csv and, if present, tracks.csv of the run directory. Throws InputError naming file and line when a
/// file is missing or broken or when the two do not have the same rows.
ResultTable load_results(const std::string& directory);

}  // namespace scree
