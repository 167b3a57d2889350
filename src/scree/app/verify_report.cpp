#include "scree/app/verify_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace scree {
namespace {

std::string expected_text(const Check& check) {
  std::string text = check.expected ? fmt::format("{:.8g}", *check.expected) : "";
  if (check.at_least) text += fmt::format("{}>= {:.4g}", text.empty() ? "" : ", ", *check.at_least);
  if (check.at_most) text += fmt::format("{}<= {:.4g}", text.empty() ? "" : ", ", *check.at_most);
  return text;
}

std::string verdict_text(const Check& check) {
  if (check.wrong) return check.passed ? "passes" : "caught";
  return check.passed ? "ok" : "FAILED";
}

using Row = std::array<std::string, 7>;

Row row_of(const Check& check) {
  return {verdict_text(check),  check.variant.empty() ? "all together" : check.variant,
          check.what,           fmt::format("{:.8g}", check.value),
          expected_text(check), check.expected ? fmt::format("{:.2g}", check.tolerance) : "",
          check.source};
}

// Numbers of characters, not bytes: continuation bytes of UTF-8 take no place.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

nlohmann::json number(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr); }

nlohmann::json optional_number(const std::optional<double>& value) { return value ? number(*value) : nullptr; }

nlohmann::json to_json(const Check& check) {
  return {{"variant", check.variant},
          {"what", check.what},
          {"value", number(check.value)},
          {"expected", optional_number(check.expected)},
          {"tolerance", check.tolerance},
          {"at_least", optional_number(check.at_least)},
          {"at_most", optional_number(check.at_most)},
          {"verdict", verdict_text(check)},
          {"source", check.source}};
}

nlohmann::json to_json(const CaseReport& report) {
  nlohmann::json variants = nlohmann::json::array(), checks = nlohmann::json::array();
  for (const VariantRun& run : report.runs)
    variants.push_back({{"name", run.keys.name},
                        {"directory", run.directory},
                        {"seconds", run.seconds},
                        {"wrong", run.keys.wrong},
                        {"stopped", run.stopped}});
  for (const Check& check : report.judgement.checks) checks.push_back(to_json(check));
  return {{"name", report.name},     {"title", report.title},
          {"source", report.source}, {"seconds", report.seconds},
          {"variants", variants},    {"passed", report.judgement.passed},
          {"checks", checks},        {"complaints", report.judgement.complaints}};
}

}  // namespace

std::string report_text(const CaseReport& report) {
  std::string text = fmt::format("{}  {}  {} ({:.1f} s)\n", report.judgement.passed ? "ok    " : "FAILED", report.name,
                                 report.title, report.seconds);
  std::vector<Row> rows = {{"", "variant", "what", "value", "expected", "within", "source"}};
  for (const Check& check : report.judgement.checks) rows.push_back(row_of(check));
  std::array<std::size_t, 7> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  for (const Row& row : rows) {
    std::string line = "   ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line += " " + row[i] + std::string(widths[i] - width_of(row[i]) + 1, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& complaint : report.judgement.complaints) text += "     ! " + complaint + "\n";
  return text + "\n";
}

std::string closing_text(const std::vector<CaseReport>& reports) {
  std::size_t numbers = 0, wrong = 0;
  std::string failed;
  for (const CaseReport& report : reports) {
    for (const Check& check : report.judgement.checks) ++(check.wrong ? wrong : numbers);
    if (!report.judgement.passed) failed += (failed.empty() ? "" : ", ") + report.name;
  }
  return fmt::format("{} cases, {} numbers, {} more of deliberately wrong variants: {}\n", reports.size(), numbers,
                     wrong, failed.empty() ? "all passed" : "failed: " + failed);
}

std::string report_json(const std::vector<CaseReport>& reports) {
  nlohmann::json cases = nlohmann::json::array();
  for (const CaseReport& report : reports) cases.push_back(to_json(report));
  const bool passed = std::ranges::all_of(reports, [](const CaseReport& report) { return report.judgement.passed; });
  return nlohmann::json{{"passed", passed}, {"cases", cases}}.dump(2) + "\n";
}

}  // namespace scree
