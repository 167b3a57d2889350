#include "scree/app/bench_figures.h"

#include <algorithm>
#include <cmath>

namespace scree {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    sum_xx += dx * dx;
    sum_xy += dx * (std::log(y[i]) - mean_y);
  }
  return sum_xy / sum_xx;
}

double bytes_per_particle_step(double candidates, double contacts) {
  const double particle = 2 * (64 + 32 + 32), candidate = 4 + 4 + 4 + 1 + 2 * 4, contact = 2 * 32 + 1;
  return particle + candidates * candidate + contacts * contact;
}

std::array<int, 3> repeats(int copies) {
  std::array<int, 3> best{1, 1, copies};
  for (int a = 1; a * a * a <= copies; ++a) {
    if (copies % a != 0) continue;
    const int rest = copies / a;
    for (int b = a; b * b <= rest; ++b)
      if (rest % b == 0 && rest / b < best[2]) best = {a, b, rest / b};
  }
  return best;
}

}  // namespace scree
