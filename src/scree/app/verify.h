// `scree verify`: runs the cases of the verification book and judges every number they must reproduce.
#pragma once

#include <string>
#include <vector>

namespace scree {

struct VerifyOptions {
  std::string cases;                       // directory that holds NN_name/case.toml
  std::vector<std::string> names;          // "01_drag", "01" or "drag"; empty: all cases
  std::string directory = "verification";  // results: NN_name/VARIANT/ run directories, verify.json
  bool plot = false;                       // also NN_name/figure.png of each case
  int threads = 0;                         // 0: as many as the machine offers
};

/// Runs every variant of the named cases, prints a table per case to standard output and writes verify.json.
/// Returns the exit code: 0 if all is as it must be, 3 if a number is missed or a deliberately wrong variant passes,
/// 130 after Ctrl-C. Throws InputError for an unknown name, ResourceError when the results cannot be written.
int verify(const VerifyOptions& options);

}  // namespace scree
