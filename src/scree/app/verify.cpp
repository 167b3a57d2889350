#include "scree/app/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "scree/app/plot.h"
#include "scree/app/run.h"
#include "scree/app/verify_judge.h"
#include "scree/app/verify_plot.h"
#include "scree/app/verify_report.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/input/load.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> all_cases(const std::string& directory) {
  std::vector<std::string> names;
  if (fs::is_directory(directory))
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
      if (fs::exists(entry.path() / "case.toml")) names.push_back(entry.path().filename());
  if (names.empty()) throw InputError(fmt::format("{}: no verification cases (NN_name/case.toml) here", directory));
  std::ranges::sort(names);
  return names;
}

// "01_drag" is known by its number and by its word, too.
bool answers_to(const std::string& name, const std::string& asked) {
  const std::size_t underscore = name.find('_');
  return name == asked || name.substr(0, underscore) == asked ||
         (underscore != std::string::npos && name.substr(underscore + 1) == asked);
}

std::vector<std::string> chosen_cases(const VerifyOptions& options) {
  const std::vector<std::string> all = all_cases(options.cases);
  if (options.names.empty()) return all;
  std::vector<std::string> chosen;
  for (const std::string& asked : options.names) {
    const auto found = std::ranges::find_if(all, [&](const std::string& name) { return answers_to(name, asked); });
    if (found == all.end())
      throw InputError(fmt::format("no verification case '{}'; there are: {}", asked, fmt::join(all, ", ")));
    chosen.push_back(*found);
  }
  return chosen;
}

VariantRun run_variant(const std::string& path, const VariantKeys& keys, const std::string& directory, int threads) {
  VariantRun run;
  run.keys = keys;
  run.directory = directory + "/" + keys.name;
  const auto start = std::chrono::steady_clock::now();
  RunOptions options;
  options.directory = run.directory;
  options.force = true;
  options.quiet = true;
  options.threads = threads;
  const RunResult result = run_case(load_case(path, keys.set), options);
  if (result.status == Exit::success)
    run.results = load_results(run.directory);
  else
    run.stopped = result.summary.reason;
  run.interrupted = result.status == Exit::interrupted;
  run.seconds = seconds_since(start);
  return run;
}

std::vector<VariantKeys> variants_of(const VerifyKeys& keys) {
  if (!keys.variants.empty()) return keys.variants;
  VariantKeys only;
  only.name = "run";
  return {only};
}

// A case that cannot be read or evaluated fails, and the others go on.
CaseReport verify_case(const VerifyOptions& options, const std::string& name) {
  const std::string path = (fs::path(options.cases) / name / "case.toml").string();
  const std::string directory = (fs::path(options.directory) / name).string();
  const auto start = std::chrono::steady_clock::now();
  CaseReport report;
  report.name = name;
  try {
    const VerifyKeys keys = load_case(path).verify;
    report.title = keys.title;
    report.source = keys.source;
    for (const VariantKeys& variant : variants_of(keys)) {
      report.runs.push_back(run_variant(path, variant, directory, options.threads));
      if (report.runs.back().interrupted) return report;
    }
    report.judgement = judge(keys, report.runs);
    if (options.plot)
      write_text_file(directory + "/figure.json", plot_json(name + ": " + keys.title, keys, report.runs));
  } catch (const InputError& error) {
    report.judgement.complaints.push_back(error.what());
  }
  for (VariantRun& run : report.runs) run.results = {};
  report.seconds = seconds_since(start);
  return report;
}

bool interrupted(const CaseReport& report) {
  return std::ranges::any_of(report.runs, [](const VariantRun& run) { return run.interrupted; });
}

}  // namespace

int verify(const VerifyOptions& options) {
  const std::vector<std::string> names = chosen_cases(options);
  std::error_code failure;
  fs::create_directories(options.directory, failure);
  if (failure) throw ResourceError(fmt::format("{}: {}", options.directory, failure.message()));
  std::vector<CaseReport> reports;
  for (const std::string& name : names) {
    reports.push_back(verify_case(options, name));
    if (interrupted(reports.back())) return static_cast<int>(Exit::interrupted);
    fmt::print("{}", report_text(reports.back()));
    std::fflush(stdout);
  }
  fmt::print("{}", closing_text(reports));
  write_text_file(options.directory + "/verify.json", report_json(reports));
  if (options.plot) plot_verification(options.directory);
  const bool passed = std::ranges::all_of(reports, [](const CaseReport& report) { return report.judgement.passed; });
  return static_cast<int>(passed ? Exit::success : Exit::physics);
}

}  // namespace scree
