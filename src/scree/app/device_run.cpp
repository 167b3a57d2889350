#include "scree/app/device_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "scree/app/build.h"
#include "scree/app/guard.h"
#include "scree/base/error.h"
#include "scree/input/located.h"
#include "scree/particles/device/formula.h"

namespace scree {
namespace {

std::string known_devices(const std::vector<opencl::DeviceInfo>& all) {
  if (all.empty()) return fmt::format("there is none; tried: {}", fmt::join(opencl::library().tried, "; "));
  std::string text = "there are";
  for (std::size_t k = 0; k < all.size(); ++k) text += fmt::format("{} opencl:{} ({})", k ? "," : "", k, all[k].name);
  return text;
}

[[noreturn]] void refuse(const Case& c, const std::string& key, const std::string& what) {
  throw error_at(c, key,
                 {"E193", {}, what + " not there yet on devices", "", "run the case without --device: the CPU has it"});
}

/// Refuses a formula with a function that kernels do not have.
void refuse_formulas(const Case& c, const std::string& key, const Expression3& formulas) {
  for (const std::string& formula : formulas) {
    const FormulaText text = formula_for_device(formula, {"x", "y", "z", "t"});
    if (!text.lacking.empty()) refuse(c, key, fmt::format("'{}' in the formula '{}' is", text.lacking, formula));
  }
}

}  // namespace

opencl::DeviceInfo find_device(const std::string& name, int place) {
  const std::vector<opencl::DeviceInfo> all = opencl::devices();
  std::size_t number = 0;
  bool good = name == "opencl";
  // GPUs come first; a rank more than there are of them is not to go to a processor.
  if (good && !all.empty())
    number = static_cast<std::size_t>(place) %
             static_cast<std::size_t>(std::count_if(
                 all.begin(), all.end(), [&](const opencl::DeviceInfo& d) { return d.gpu == all.front().gpu; }));
  if (name.starts_with("opencl:")) {
    const char *begin = name.data() + 7, *end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(begin, end, number);
    good = error == std::errc() && stop == end;
  }
  if (!good)
    throw InputError(
        fmt::format("--device {}: error[E190]: expected cpu, opencl, or opencl:NUMBER; {}", name, known_devices(all)));
  if (number >= all.size())
    throw InputError(fmt::format("--device {}: error[E190]: no such device; {}", name, known_devices(all)));
  if (!all[number].fp64)
    throw InputError(fmt::format("--device {}: error[E190]: {} has no double precision", name, all[number].name));
  return all[number];
}

Precision find_precision(const std::string& name, const std::string& device) {
  if (name == "double") return Precision::full;
  if (name != "mixed") throw InputError(fmt::format("--precision {}: error[E190]: expected double or mixed", name));
  if (device == "cpu")
    throw InputError(
        "--precision mixed: error[E190]: mixed precision is for devices, the CPU computes in double; name one with "
        "--device");
  return Precision::mixed;
}

void refuse_in_mixed(const Case& c, bool several) {
  const auto lacks = [&](const std::string& key, const std::string& what) {
    throw error_at(
        c, key, {"E193", {}, what + " not there yet in mixed precision", "", "--precision double has it on a device"});
  };
  if (several) lacks("simulation.end", "runs of several processes are");
  for (std::size_t k = 0; k < c.particles.size(); ++k)
    if (c.particles[k].motion == "prescribed")
      lacks(fmt::format("particles.{}.motion", k), "bodies that move as prescribed are");
  if (!c.analysis.planes.empty()) lacks("analysis.planes.0.point", "counting planes are");
}

void refuse_on_device(const Case& c) {
  if (has_shapes(c) && by_vertices(c)) refuse(c, "contact.detection", "contacts of shapes by vertices are");
  if (is_hard(c)) refuse(c, "contact.collision", "hard collisions are");
  if (c.gravity.type == "expression") refuse_formulas(c, "gravity.expression", c.gravity.expression);
  if (c.flow.type == "expression") refuse_formulas(c, "flow.expression", c.flow.expression);
  if (solves_flow(c) && !couples(c)) refuse(c, "fluid.type", "flows that are solved for are");
  if (warms(c)) refuse(c, "heat.type", "temperatures of particles are");
}

}  // namespace scree
