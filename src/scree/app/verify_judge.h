// Expectations against results: what a verification case demands, judged number by number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scree/app/verify_results.h"
#include "scree/input/case.h"

namespace scree {

/// The run of one variant: its results, or why there are none.
struct VariantRun {
  VariantKeys keys;
  std::string directory;
  double seconds = 0;
  ResultTable results;
  std::string stopped;       // message of the error that ended the run; empty: it finished
  bool interrupted = false;  // by the user
};

/// One number and its verdict. The expected value is absent where only bounds are given.
struct Check {
  std::string variant;  // "" where the number belongs to all variants together
  std::string what, source;
  double value = 0;
  std::optional<double> expected;
  double tolerance = 0;  // absolute, the relative one already multiplied out
  std::optional<double> at_least, at_most;
  bool wrong = false;  // of a variant that is deliberately wrong
  bool passed = false;
};

/// The verdict on a case. A variant that is deliberately wrong must fail at least one check or be stopped by the
/// program; otherwise the case's checks prove nothing and `complaints` says so.
struct Judgement {
  std::vector<Check> checks;
  std::vector<std::string> complaints;
  bool passed = false;
};

/// Evaluates every expectation for every variant it applies to. Throws InputError for a formula that cannot be read.
Judgement judge(const VerifyKeys& keys, const std::vector<VariantRun>& runs);

}  // namespace scree
