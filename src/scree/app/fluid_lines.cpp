#include "scree/app/fluid_lines.h"

#include <algorithm>
#include <limits>

#include "scree/app/fluid_times.h"
#include "scree/fluid/measure.h"

namespace scree {
namespace {

const std::vector<std::string> columns = {"time", "x", "y", "z", "u_x", "u_y", "u_z", "p"};

std::vector<double> sample(const FluidSolver& s, const FluidLineKeys& line) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> rows;
  for (std::uint64_t n = 0; n < line.points; ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(line.points - 1);
    std::array<double, 3> place{};
    for (int a = 0; a < 3; ++a) place[a] = (1 - share) * line.from[a] + share * line.to[a];
    const auto found = probe(s, place);
    rows.push_back(s.state.time);
    rows.insert(rows.end(), place.begin(), place.end());
    for (int i = 0; i < 4; ++i) rows.push_back(found ? (*found)[i] : nan);
  }
  return rows;
}

}  // namespace

FluidLines::FluidLines(const Case& c, const RunDirectory* directory, double now, bool resumed) {
  for (const FluidLineKeys& keys : c.fluid.lines) {
    const double interval = keys.every > 0 ? keys.every : series_interval(c);
    lines_.push_back({keys, interval, resumed ? next_multiple(now, interval) : 0, resumed ? now : -1});
    if (!directory) continue;
    tables_.push_back(resumed ? SeriesWriter::resume(directory->line(keys.name), columns, now)
                              : SeriesWriter::create(directory->line(keys.name), columns));
  }
}

double FluidLines::next_event(double time) const {
  double next = never;
  for (const Line& line : lines_) next = std::min(next, next_multiple(time, line.interval));
  return next;
}

void FluidLines::write_due(const FluidSolver& s, bool last) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Line& line = lines_[i];
    if (!(last || reached(s.state.time, line.due, line.interval)) || line.written == s.state.time) continue;
    line.due = next_multiple(s.state.time, line.interval);
    line.written = s.state.time;
    const std::vector<double> rows = sample(s, line.keys);
    if (!tables_.empty()) tables_[i].append(rows);
  }
}

}  // namespace scree
