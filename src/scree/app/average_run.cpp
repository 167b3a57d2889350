#include "scree/app/average_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/app/columns.h"
#include "scree/app/due.h"
#include "scree/base/error.h"

namespace scree {
namespace {

CellGrid3 grid_of(const AverageKeys& keys, const Domain& domain) {
  CellGrid3 grid{keys.min, keys.max, {}, {}};
  for (int k = 0; k < 3; ++k) {
    grid.cells[k] = static_cast<int>(keys.cells[k]);
    grid.periodic[k] = domain.periodic[k] && keys.min[k] == domain.min[k] && keys.max[k] == domain.max[k];
  }
  return grid;
}

std::vector<double> numbers_of(const CellGrid3& grid) {
  std::vector<double> out(grid.min.begin(), grid.min.end());
  out.insert(out.end(), grid.max.begin(), grid.max.end());
  out.insert(out.end(), grid.cells.begin(), grid.cells.end());
  return out;
}

}  // namespace

AverageRun::AverageRun(const Case& c, const AverageKeys& keys, const Clock& clock,
                       const std::filesystem::path& directory, const Archive* archive)
    : keys_(keys),
      dt_(clock.dt),
      first_step_(step_at(keys.from, clock.dt)),
      sample_due_(first_step_),
      window_due_(first_step_),
      averages_(start_averages(grid_of(keys, build_domain(c)))) {
  if (archive && archive->contains("average_sums_" + keys_.name))
    restore(*archive);
  else if (clock.step > first_step_)
    first_step_ = clock.step;
  if (clock.step > first_step_ || averages_.samples > 0) {
    plan(clock.step);
  } else {
    plan(first_step_);
    sample_due_ = first_step_;
  }
  writer_.emplace(directory, keys_.name, program_name(), static_cast<std::uint64_t>(window_));
}

/// Sets when the next sample and the end of the window are due after `step`.
void AverageRun::plan(std::int64_t step) {
  const std::int64_t since = step - first_step_;
  sample_due_ = first_step_ + next_due(since, keys_.every, dt_);
  window_due_ =
      keys_.window > 0 ? first_step_ + next_due(since, keys_.window, dt_) : std::numeric_limits<std::int64_t>::max();
}

void AverageRun::look(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  if (clock.step < sample_due_ && clock.step < window_due_) return;
  if (clock.step >= sample_due_) {
    const Sample& sample = simulation.whole_sample();
    const Stopwatch watch(simulation.stages(), "averages");
    add_sample(averages_, sample);
    end_ = clock.now();
    if (averages_.samples == 1) begin_ = end_;
  }
  if (clock.step >= window_due_) {
    write();
    averages_ = start_averages(averages_.grid);
    ++window_;
  }
  plan(clock.step);
}

void AverageRun::finish() { write(); }

void AverageRun::write() {
  if (averages_.samples == 0) return;
  const CellGrid3& grid = averages_.grid;
  const GridSpan span{grid.min, grid.max, {grid.cells[0], grid.cells[1], grid.cells[2]},
                      begin_,   end_,     averages_.samples};
  const std::vector<AverageField> fields = fields_of(averages_);
  std::vector<FrameColumn> columns;
  for (const AverageField& f : fields)
    columns.push_back({f.name, f.unit, f.meaning,
                       array_view(f.values.data(), grid.size(), static_cast<std::uint64_t>(f.components))});
  writer_->write(static_cast<std::uint64_t>(window_), span, columns);
}

void AverageRun::save(Archive& archive) const {
  archive.put("average_sums_" + keys_.name, std::vector<double>(averages_.sums), sum_of::count);
  archive.put("average_grid_" + keys_.name, numbers_of(averages_.grid));
  archive.put("average_times_" + keys_.name, std::vector<double>{begin_, end_});
  archive.put("average_counts_" + keys_.name, std::vector<std::int64_t>{first_step_, window_, averages_.samples});
}

void AverageRun::restore(const Archive& archive) {
  if (!std::ranges::equal(archive.get<double>("average_grid_" + keys_.name), numbers_of(averages_.grid)))
    throw InputError(
        fmt::format("{} has averages '{}' on another grid: give the new ones another name, or the old grid",
                    archive.origin, keys_.name));
  const auto sums = archive.get<double>("average_sums_" + keys_.name, sum_of::count);
  const auto times = archive.get<double>("average_times_" + keys_.name);
  const auto counts = archive.get<std::int64_t>("average_counts_" + keys_.name);
  averages_.sums.assign(sums.begin(), sums.end());
  begin_ = times[0];
  end_ = times[1];
  first_step_ = counts[0];
  window_ = counts[1];
  averages_.samples = counts[2];
}

}  // namespace scree
