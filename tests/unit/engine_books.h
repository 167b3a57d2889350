// Books followed through a run, for the tests of conservation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine_cases.h"
#include "scree/analysis/ledger.h"
#include "scree/analysis/measure.h"

namespace scree::test {

inline double norm(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// How well the books of a run close: the largest errors of energy over the turnover, of momentum over its scale, of
/// angular momentum over its largest magnitude.
struct Closure {
  double energy = 0, momentum = 0, angular = 0;
  Measured first, last;
  Tally tally;
};

/// Runs a case and looks at its books eleven times; `omit` leaves channels out of them.
inline Closure follow(const Case& c, Team team, int steps, const std::vector<std::string>& omit = {}) {
  Simulation s(c, team);
  Books books;
  Closure out;
  double turn = 0;
  for (int k = 0; k <= 10; ++k) {
    if (k) advance(s, steps / 10);
    Measured now = measure(s.sample(), s.fields(), s.clock().now());
    leave_out(now, omit);
    if (k == 0) books = open_books(out.first = now);
    enter(books, now);
    const LedgerRow row = balance(books, now, s.system().domain.any_periodic());
    turn = std::max(turn, norm(now.angular_momentum));
    out.energy = std::max(out.energy, std::abs(row.relative_energy_error()));
    out.momentum = std::max(out.momentum, row.relative_momentum_error);
    out.angular = std::max(out.angular, row.angular_momentum_error);
    out.last = now;
  }
  out.angular /= turn;
  out.tally = s.tally();
  return out;
}

}  // namespace scree::test
