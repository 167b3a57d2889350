// What the outputs need of the rest of the case.
#include <fmt/format.h>

#include "scree/data/forms.h"
#include "scree/input/checks.h"

namespace scree {
namespace {

void check_shape_fields(const Check& check) {
  const auto& groups = check.c.particles;
  const bool unknown =
      std::any_of(groups.begin(), groups.end(), [](const ParticleKeys& p) { return p.insert == "checkpoint"; });
  if (!check.sound({"output.fields", "particles"}) || unknown) return;
  const bool others =
      std::any_of(groups.begin(), groups.end(), [](const ParticleKeys& p) { return other_shape(p.shape) != nullptr; });
  for (const std::string& field : check.c.output.fields)
    if (field == "shape_file" && !others)
      check.fail("E164", "output.fields", "the field 'shape_file' needs particles that are no superellipsoids",
                 "there are none", "leave the field out, or set a shape   (scree explain particles.shape)");
  if (has_shapes(check.c)) return;
  for (const std::string& field : check.c.output.fields)
    if (field == "orientation" || field == "half_axes" || field == "exponents")
      check.fail("E164", "output.fields", fmt::format("the field '{}' needs particles that are no spheres", field),
                 "all particles are spheres", "leave the field out, or set a shape   (scree explain particles.shape)");
}

}  // namespace

void check_output(const Check& check) {
  check_shape_fields(check);
  for (const std::string& field : check.c.output.fields)
    if (field == "temperature" && check.sound({"output.fields", "heat"}) && !warms(check.c))
      check.fail("E164", "output.fields", "the field 'temperature' needs particles that have one", "there is no [heat]",
                 "leave the field out, or add [heat]   (scree explain heat)");
  if (!check.sound({"output.fields", "analysis.agglomerates"}) || check.c.analysis.agglomerates) return;
  for (const std::string& field : check.c.output.fields)
    if (field.starts_with("agglomerate"))
      check.fail("E164", "output.fields", fmt::format("the field '{}' needs analysis.agglomerates = true", field),
                 "agglomerates are not looked for", "set agglomerates = true in [analysis], or leave the field out");
}

}  // namespace scree
