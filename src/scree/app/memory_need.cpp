#include "scree/app/memory_need.h"

#include <fmt/format.h>

#include "scree/app/body_kinds.h"
#include "scree/app/build_forces.h"
#include "scree/app/build_particles.h"
#include "scree/input/checks.h"
#include "scree/input/located.h"

namespace scree {

std::size_t bytes_per_particle(const Case& c) {
  Particles none(has_shapes(c));
  if (couples(c)) none.couple(build_forces(c.coupling.drag, c.coupling).turn());
  if (warms(c)) none.give_heat();
  return none.bytes_per_particle();
}

std::string memory_refusal(const Case& c, std::optional<double> available) {
  const std::vector<ParticleGroup> groups = build_groups(c, Takeover::skip);
  double total = 0, most = 0;
  std::size_t largest = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double count = expected_number(groups[g], static_cast<std::uint32_t>(g), c.simulation.seed);
    total += count;
    if (count > most) {
      most = count;
      largest = g;
    }
  }
  const double bytes = total * static_cast<double>(bytes_per_particle(c));
  if (!available || bytes <= *available) return {};
  const std::string group = item_path("particles", largest);
  const bool counted = c.text && c.text->origins.given(group + ".count");
  return error_at(c, counted ? group + ".count" : group,
                  {"E133",
                   {},
                   fmt::format("{:.4g} particles need {:.3g} GB of memory for themselves alone", total, 1e-9 * bytes),
                   fmt::format("{:.3g} GB are available on this machine", 1e-9 * *available),
                   "take fewer or larger particles, or a larger machine"})
      .what();
}

}  // namespace scree
