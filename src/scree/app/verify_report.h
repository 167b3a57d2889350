// The verification book's findings as text for the terminal and as verify.json.
#pragma once

#include <string>
#include <vector>

#include "scree/app/verify_judge.h"

namespace scree {

/// One case of the book with its verdict.
struct CaseReport {
  std::string name, title, source;
  double seconds = 0;
  std::vector<VariantRun> runs;  // results may have been dropped
  Judgement judgement;
};

/// The table of one case: a line with its verdict, then one line per number.
std::string report_text(const CaseReport& report);

/// The line under all tables: how many cases and numbers, and which cases failed.
std::string closing_text(const std::vector<CaseReport>& reports);

/// The content of verify.json (docs/verification.md).
std::string report_json(const std::vector<CaseReport>& reports);

}  // namespace scree
