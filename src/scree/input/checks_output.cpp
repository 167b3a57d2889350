// What the outputs need of the rest of the case.
#include <fmt/format.h>

#include "scree/input/checks.h"

namespace scree {

void check_output(const Check& check) {
  if (!check.sound({"output.fields", "analysis.agglomerates"}) || check.c.analysis.agglomerates) return;
  for (const std::string& field : check.c.output.fields)
    if (field.starts_with("agglomerate"))
      check.fail("E164", "output.fields", fmt::format("the field '{}' needs analysis.agglomerates = true", field),
                 "agglomerates are not looked for", "set agglomerates = true in [analysis], or leave the field out");
}

}  // namespace scree
