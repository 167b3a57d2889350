// Runs in mixed precision beside those on the CPU, for the tests of what that changes.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/device_cases.h"
#include "support/motions.h"
#include "unit/engine_books.h"

namespace scree::test {

/// Leaves a figure in the report that --gtest_output writes.
inline void note(const std::string& name, double value) {
  testing::Test::RecordProperty(name, fmt::format("{:.3g}", value));
}

inline Simulation on_cpu(const Case& c, const Archive* from = nullptr) {
  Simulation s(c, 1, from);
  if (from) s.restore(*from);
  return s;
}

inline Simulation in_mixed(const Case& c, const Archive* from = nullptr) {
  Simulation s = on_cpu(c, from);
  s.use_device(first_device(), Precision::mixed);
  return s;
}

inline Archive saved_after(const Case& c, int steps) {
  Simulation s(c, 1);
  advance(s, steps);
  return s.save();
}

inline Told told_in_mixed(const Case& c, int steps) {
  Simulation s = in_mixed(c);
  advance(s, steps);
  return told_by(s);
}

/// A bed that has settled on the CPU goes on in mixed precision and on the CPU again, with its springs.
inline void expect_to_go_on(const Case& c) {
  const Archive started = saved_after(c, 8000);
  Simulation device = in_mixed(c, &started);
  advance(device, 100);
  const Archive carried = device.save();
  Simulation back = on_cpu(c, &carried), truth = on_cpu(c, &started);
  advance(back, 100);
  advance(truth, 200);
  EXPECT_LT(apart(motions(truth), motions(back), place).most, 1e-9);
  const auto springs = pair_springs(truth.whole()), there = pair_springs(back.whole());
  ASSERT_EQ(there.size(), springs.size());
  double most = 0, wrong = 0;
  for (const auto& [pair, spring] : springs)
    for (std::size_t k = 0; k < spring.size(); ++k) {
      most = std::max(most, std::abs(spring[k]));
      wrong = std::max(wrong, std::abs(spring[k] - there.at(pair)[k]));
    }
  EXPECT_GT(most, 1e-4);
  EXPECT_LT(wrong, 1e-4 * most);
}

/// How books close.
struct Closing {
  double energy = 0, momentum = 0, angular = 0;  // relative errors, the largest of ten looks
  Measured last;
};

inline Closing books_of(Simulation& s, int steps) {
  Books books;
  Closing out;
  for (int k = 0; k <= 10; ++k) {
    if (k) advance(s, steps / 10);
    out.last = s.measured();
    if (k == 0) books = open_books(out.last);
    enter(books, out.last);
    const LedgerRow row = balance(books, out.last, false);
    out.energy = std::max(out.energy, std::abs(row.relative_energy_error()));
    out.momentum = std::max(out.momentum, row.relative_momentum_error);
    out.angular = std::max(out.angular, row.angular_momentum_error / norm(out.last.angular_momentum));
  }
  return out;
}

}  // namespace scree::test
