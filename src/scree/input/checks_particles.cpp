// Particles: sizes, how many, from where; and what the run asks of the flow and the clock.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>

#include "scree/data/forms.h"
#include "scree/input/checks.h"

namespace scree {
namespace {

constexpr double fraction_tolerance = 1e-6;

void check_size(const Check& check, const std::string& path, const SizeKeys& size) {
  if (!check.sound({path})) return;
  if (size.distribution == "classes") {
    if (size.diameters.size() != size.fractions.size())
      check.fail("E167", path + ".fractions",
                 fmt::format("{} diameters but {} fractions", size.diameters.size(), size.fractions.size()),
                 "one for each diameter");
    const double sum = std::accumulate(size.fractions.begin(), size.fractions.end(), 0.0);
    if (std::abs(sum - 1) > fraction_tolerance)
      check.fail("E167", path + ".fractions", "the fractions do not add up to 1",
                 fmt::format("they add up to {:.7g}", sum));
    return;
  }
  if (size.distribution == "single") return;
  if (size.min > size.max)
    check.fail("E167", path + ".min", "the smallest diameter is above the largest",
               fmt::format("max is {} m", size.max));
  else if (size.distribution != "uniform" && (size.mean < size.min || size.mean > size.max))
    check.fail("E167", path + ".mean", "the mean diameter is not between min and max",
               fmt::format("min is {} m, max is {} m", size.min, size.max));
}

/// What to write in place of a quaternion that turns but is not of length 1: "write [0.7071068, 0.7071068, 0, 0]".
std::string same_turn(const std::vector<double>& q, double square) {
  if (q.size() != 4 || !(square > 0))
    return "of a turn by an angle about an axis: cos(angle/2), sin(angle/2) times the axis";
  const double length = std::sqrt(square);
  return fmt::format("for that rotation write [{:.9g}, {:.9g}, {:.9g}, {:.9g}]", q[0] / length, q[1] / length,
                     q[2] / length, q[3] / length);
}

void check_shape(const Check& check, std::size_t index) {
  constexpr double largest_ratio = 20, length_tolerance = 1e-6;
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index);
  if (p.shape == "sphere" || p.insert == "checkpoint" ||
      !check.sound({path + ".shape", path + ".half_axes", path + ".exponents", path + ".orientation"}))
    return;
  const auto [least, most] = std::minmax_element(p.half_axes.begin(), p.half_axes.end());
  if (*most > (1 + 1e-9) * largest_ratio * *least)  // lengths with units are rounded
    check.fail("E167", path + ".half_axes", "the shape is too long or too flat",
               fmt::format("the half axes differ by a factor of {:.4g}", *most / *least), "up to 20 is possible");
  const OtherShape* const other = other_shape(p.shape);
  if (other && !other->fits(sc_make_vec(p.half_axes[0], p.half_axes[1], p.half_axes[2])))
    check.fail("E167", path + ".half_axes", fmt::format("these are no half axes of a {}", other->name),
               in_words(p.half_axes), fmt::format("of its half axes {}", other->rule));
  if (p.exponents.size() != 2)
    check.fail("E104", path + ".exponents", "'exponents' must be two numbers, e1 and e2",
               fmt::format("{} given", p.exponents.size()), "e1 is that along z, e2 that in the plane of x and y");
  const OrientationKeys& o = p.orientation;
  const std::string turn = path + ".orientation";
  double square = 0;
  for (const double q : o.quaternion) square += q * q;
  if (!o.quaternion.empty() && (o.quaternion.size() != 4 || std::abs(square - 1) > length_tolerance))
    check.fail("E104", turn + ".quaternion", "a quaternion must be four numbers w, x, y, z of length 1",
               o.quaternion.size() == 4 ? fmt::format("its length is {:.7g}", std::sqrt(square))
                                        : fmt::format("{} given", o.quaternion.size()),
               same_turn(o.quaternion, square));
  if (o.axis == Vec3{} && o.type != "random")
    check.fail("E167", turn + ".axis", "the axis of the rotation has no direction", "it is (0, 0, 0)");
  if (check.c.gravity.type == "rotating")
    check.fail("E164", path + ".shape", "particles in a rotating frame must be spheres", "gravity.type is 'rotating'",
               "turn the walls ([walls.motion]) instead of the frame");
}

void check_insertion(const Check& check, std::size_t index) {
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index);
  if (!check.sound({path + ".insert", path + ".count", path + ".solid_fraction", path + ".spacing", path + ".file"}))
    return;
  if (p.insert == "random" && (p.count > 0) == (p.solid_fraction > 0))
    check.fail("E169", path + ".insert", "insert = 'random' needs either 'count' or 'solid_fraction'",
               p.count > 0 ? "both are given" : "neither is given", "say how many particles there are in one way");
  if (p.insert == "lattice" && p.count == 0 && p.spacing == 0)
    check.fail("E169", path + ".insert", "insert = 'lattice' needs 'count', 'spacing' or both", "neither is given",
               "count fills the region evenly, spacing fixes the distance of neighbours");
  std::error_code ignored;
  if (p.insert == "file" && !std::filesystem::is_regular_file(p.file, ignored))
    check.fail("E168", path + ".file", fmt::format("there is no file '{}'", p.file), "not found",
               "file names are relative to the case file");
  if (p.velocity.type == "fluid" && check.c.flow.type == "none" && check.sound({"flow.type"}))
    check.fail("E163", path + ".velocity.type", "velocity.type = 'fluid' needs a flow", "there is no fluid",
               "set flow.type   (scree explain flow.type)");
}

/// Zastawny's coefficients are of two shapes.
void check_zastawny(const Check& check, const std::string& table) {
  for (std::size_t i = 0; i < check.c.particles.size(); ++i) {
    const ParticleKeys& p = check.c.particles[i];
    const Vec3& a = p.half_axes;
    const bool round = p.shape == "ellipsoid" && std::abs(a[1] / a[0] - 1) < 1e-6;
    if (round && (std::abs(a[2] / a[0] - 2.5) < 1e-6 || std::abs(a[2] / a[0] - 1.25) < 1e-6)) continue;
    return check.fail("E164", table + ".drag", "drag = 'zastawny' is for ellipsoids of 2:2:5 and of 4:4:5",
                      fmt::format("'{}' has another shape", p.name),
                      "shape = 'ellipsoid' with half_axes like [2, 2, 5], the longest along z, turned by orientation; "
                      "drag = 'holzer_sommerfeld' is for any shape");
  }
}

/// Hard collisions know no torque of a flow, and no fluid that is struck with a particle.
void check_hard_forces(const Check& check, const std::string& table, const std::string& drag,
                       const FluidForceKeys& keys, bool by_shape) {
  if (!is_hard(check.c)) return;
  const std::string because = "contact.collision is 'hard'";
  const bool pitches = by_shape && drag != "stokes_ellipsoid" && drag != "haider_levenspiel";
  const auto acts = [](const std::string& word, bool by_itself) {
    return word == "on" || (word == "auto" && by_itself);
  };
  const bool pitching = acts(keys.pitching_torque, pitches), viscous = acts(keys.viscous_torque, by_shape);
  if (by_shape && viscous)
    check.fail("E164", table + ".drag", fmt::format("drag = '{}' does not go with hard collisions", drag),
               "it turns particles, too, and " + because,
               "choose contact.collision = 'soft', or drag = 'schiller_naumann'");
  else if (pitching || viscous)
    check.fail("E164", table + (pitching ? ".pitching_torque" : ".viscous_torque"),
               "torques of a fluid do not go with hard collisions", because,
               "choose contact.collision = 'soft', or set pitching_torque and viscous_torque to 'off'");
  if (keys.added_mass)
    check.fail("E164", table + ".added_mass", "added mass does not go with hard collisions", because,
               "choose contact.collision = 'soft'");
}

/// What the forces of the table of a flow, prescribed or solved for, ask of the particles.
void check_forces(const Check& check, const std::string& table, const std::string& drag, const FluidForceKeys& keys) {
  if (!check.sound({table, "particles", "contact.collision"})) return;
  static const std::vector<std::string> laws = {"stokes_ellipsoid", "haider_levenspiel", "ganser", "holzer_sommerfeld",
                                                "zastawny"};
  check_hard_forces(check, table, drag, keys, std::ranges::find(laws, drag) != laws.end());
  if (drag == "zastawny") check_zastawny(check, table);
}

/// The forces of a flow that is solved for.
void check_coupling(const Check& check) {
  const CouplingKeys& k = check.c.coupling;
  if (!couples(check.c)) return;
  check_forces(check, "coupling", k.drag, k);
  const bool viscous = k.drag != "none" || k.saffman || k.magnus || k.shape_lift == "on" || k.pitching_torque == "on" ||
                       k.viscous_torque == "on";
  if (viscous && check.c.fluid.viscosity == 0 && check.sound({"fluid.viscosity", "coupling"}))
    check.fail("E163", "fluid.viscosity", fmt::format("drag = '{}' needs a fluid with viscosity", k.drag),
               "the viscosity is 0",
               "give its viscosity, or set coupling.drag = 'none'   (scree explain coupling.drag)");
}

void check_flow(const Check& check) {
  const FlowKeys& f = check.c.flow;
  if (f.type == "none") return;
  if (f.drag != "none" && f.viscosity == 0 && check.sound({"flow.viscosity", "flow.drag", "flow.type"}))
    check.fail("E163", "flow.drag", fmt::format("drag = '{}' needs the viscosity of the fluid", f.drag),
               "'viscosity' is missing", "add 'viscosity'   (scree explain flow.viscosity)");
  const bool creeping = f.drag == "none" || f.drag == "stokes";
  if (!creeping && f.density == 0 && check.sound({"flow.density", "flow.drag", "flow.type"}))
    check.fail("E163", "flow.drag", fmt::format("drag = '{}' needs the density of the fluid", f.drag),
               "'density' is missing", "add 'density'   (scree explain flow.density)");
  check_forces(check, "flow", f.drag, f);
  const bool dense = f.saffman || f.magnus || f.added_mass || f.pressure_force || f.pitching_torque == "on" ||
                     f.viscous_torque == "on" || f.shape_lift == "on";
  if (dense && (f.density == 0 || f.viscosity == 0) && check.sound({"flow"}))
    check.fail("E163", "flow.type", "the forces of the flow need the density and the viscosity of the fluid",
               f.density == 0 ? "'density' is missing" : "'viscosity' is missing",
               "give both   (scree explain flow.density)");
  if (!f.buoyancy || !check.sound({"flow.buoyancy", "flow.density", "flow.type", "gravity"})) return;
  if (f.density == 0)
    check.fail("E163", "flow.buoyancy", "buoyancy needs the density of the fluid", "'density' is missing",
               "add 'density'   (scree explain flow.density)");
  if (check.c.gravity.type != "uniform")
    check.fail("E164", "flow.buoyancy", "buoyancy belongs to uniform gravity",
               fmt::format("gravity.type is '{}'", check.c.gravity.type),
               "set gravity.type = 'uniform', or remove 'buoyancy'");
}

/// Ids of tracks can be checked when the number of particles is known before they are placed.
void check_tracks(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"output.tracks", "particles"})) return;
  std::set<std::uint64_t> seen;
  for (std::uint64_t id : c.output.tracks)
    if (!seen.insert(id).second)
      check.fail("E161", "output.tracks", fmt::format("particle {} is tracked twice", id), "every id once");
  std::uint64_t total = 0;
  for (const ParticleKeys& p : c.particles) {
    if (p.insert == "checkpoint") return;
    const std::uint64_t count = p.insert == "positions" ? p.positions.size()
                                : p.insert == "rate"    ? p.total_count
                                                        : p.count;
    if (count == 0) return;
    total += count;
  }
  for (std::uint64_t id : c.output.tracks)
    if (id >= total)
      check.fail("E160", "output.tracks", fmt::format("there is no particle with id {}", id),
                 fmt::format("ids go from 0 to {}", total - 1));
}

void check_steps(const Check& check) {
  const SimulationKeys& s = check.c.simulation;
  if (!s.time_step || !check.sound({"simulation.end", "simulation.time_step"})) return;
  if (*s.time_step > s.end)
    check.fail("E167", "simulation.time_step", "the time step is longer than the run",
               fmt::format("end is {} s", s.end));
  if (!(s.end / *s.time_step <= most_steps)) {
    const Problem problem = too_many_steps(s.end, *s.time_step);
    check.fail("E132", "simulation.time_step", problem.message, problem.note, problem.help);
  }
}

}  // namespace

void check_particles(const Check& check) {
  const Case& c = check.c;
  if (c.particles.empty() && !solves_flow(c) && check.sound({"particles", "fluid.type"}))
    check.fail("E103", "", "there are no particles", "",
               "add a group headed by [[particles]]   (scree explain particles)");
  for (std::size_t i = 0; i < c.particles.size(); ++i) {
    check_size(check, item_path("particles", i) + ".diameter", c.particles[i].diameter);
    check_insertion(check, i);
    check_shape(check, i);
  }
  check_flow(check);
  check_coupling(check);
  check_tracks(check);
  check_steps(check);
}

}  // namespace scree
