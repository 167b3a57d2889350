#include "scree/app/device_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "scree/app/build_forces.h"
#include "scree/base/error.h"
#include "scree/input/located.h"

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

void refuse_particles(const Case& c) {
  for (std::size_t k = 0; k < c.particles.size(); ++k) {
    const ParticleKeys& group = c.particles[k];
    const auto key = [&](const char* name) { return fmt::format("particles.{}.{}", k, name); };
    if (group.motion == "prescribed") refuse(c, key("motion"), "bodies with a prescribed motion are");
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

void refuse_on_device(const Case& c) {
  refuse_particles(c);
  if (has_shapes(c) && by_vertices(c)) refuse(c, "contact.detection", "contacts of shapes by vertices are");
  if (is_hard(c)) refuse(c, "contact.collision", "hard collisions are");
  if (c.gravity.type != "none" && c.gravity.type != "uniform")
    refuse(c, "gravity.type", "body forces other than uniform gravity are");
  if (c.flow.type == "expression") refuse(c, "flow.type", "flows by formula are");
  if (solves_flow(c)) refuse(c, "fluid.type", "flows that are solved for are");
  if (warms(c)) refuse(c, "heat.type", "temperatures of particles are");
  if (c.flow.buoyancy) refuse(c, "flow.buoyancy", "buoyancy is");
  if (c.flow.drag != "none" && c.flow.drag != "stokes" && c.flow.drag != "schiller_naumann")
    refuse(c, "flow.drag", "drag by shape is");
  const FluidForces forces = build_forces(c.flow.drag, c.flow);
  if (forces.push() || forces.turn() || c.flow.pressure_force)
    refuse(c, "flow.type", "forces of a flow besides the drag of spheres are");
  if (!c.analysis.planes.empty()) refuse(c, "analysis.planes.0.point", "counting planes are");
}

void refuse_on_several_devices(const Case& c) {
  for (std::size_t k = 0; k < c.particles.size(); ++k)
    if (c.particles[k].shape != "sphere")
      refuse(c, fmt::format("particles.{}.shape", k), "with several processes, particles that are no spheres are");
}

}  // namespace scree
