// The report of `scree check`: what follows from a case, with a verdict and a remedy where something is doubtful.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "scree/app/coupling_report.h"
#include "scree/app/derived.h"
#include "scree/app/formula_check.h"
#include "scree/app/idle_keys.h"
#include "scree/app/outside.h"
#include "scree/app/wall_jumps.h"
#include "scree/base/memory.h"
#include "scree/data/form_surface.h"
#include "scree/input/mesh_report.h"

namespace scree {
namespace {

enum class Verdict { none, ok, warning, refused };

struct Line {
  std::string label, value;
  Verdict verdict = Verdict::none;
  std::string remedy;
};

using Lines = std::vector<Line>;

Verdict warn_if(bool bad) { return bad ? Verdict::warning : Verdict::ok; }

/// Bytes with a decimal prefix: "12.3 MB".
std::string size_text(double bytes) {
  for (const char* unit : {"B", "kB", "MB", "GB"}) {
    if (bytes < 999.5) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= 1000;
  }
  return fmt::format("{:.3g} TB", bytes);
}

std::string grouped(double whole) {
  std::string digits = fmt::format("{:.0f}", whole);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), 1, ' ');
  return digits;
}

/// A particle of a group of shapes: its lengths, areas, volume and moments of inertia at the mean volume.
void say_shape(const ParticleKeys& keys, double diameter, Lines& lines) {
  if (keys.shape == "sphere" || keys.insert == "checkpoint") return;
  const auto [e1, e2] = std::pair(keys.exponents[0], keys.exponents[1]);
  const Form form = make_form(keys.shape, keys.half_axes, e1, e2);
  const double radius = 0.5 * diameter / form.equivalent_radius;
  const double volume = sphere_volume(diameter);
  Axes axes = form.half_axes(), inertia = form.inertia;
  for (int k = 0; k < 3; ++k) {
    axes[k] *= radius;
    inertia[k] *= radius * radius;
  }
  const double surface = surface_of(form) * radius * radius;
  const std::string what =
      form.other() ? std::string(form.shape_name()) : fmt::format("exponents {:g} and {:g}", e1, e2);
  lines.push_back(
      {"", fmt::format("half axes {:.4g}, {:.4g}, {:.4g} m, {}", axes[0], axes[1], axes[2], what), Verdict::none, ""});
  lines.push_back({"",
                   fmt::format("volume {:.4g} m3, surface {:.4g} m2, sphericity {:.4g}", volume, surface,
                               sphericity(volume, surface)),
                   Verdict::none, ""});
  lines.push_back({"",
                   fmt::format("bounding radius {:.4g} m, moments of inertia over the mass {:.4g}, {:.4g}, {:.4g} m2",
                               radius, inertia[0], inertia[1], inertia[2]),
                   Verdict::none, ""});
}

void say_particles(const Case& c, const Derived& d, Lines& lines) {
  for (const BodyKind& kind : d.kinds) {
    const std::string size = kind.smallest == kind.largest
                                 ? fmt::format("diameter {:.4g} m", kind.smallest)
                                 : fmt::format("diameters {:.4g} to {:.4g} m", kind.smallest, kind.largest);
    lines.push_back(
        {fmt::format("particles '{}'", kind.name),
         fmt::format("{}, {}{}", grouped(static_cast<double>(kind.count)), size, kind.free ? "" : ", infinite mass"),
         Verdict::none, ""});
    say_shape(c.particles[kind.group], kind.typical(), lines);
  }
  const auto feeds = [](const ParticleKeys& p) { return p.insert == "rate"; };
  if (std::ranges::any_of(c.particles, feeds))
    lines.push_back({"",
                     c.outlets.empty() ? "those of feeds as many as come in over the run"
                                       : "those of feeds as many as come in over the run; what the outlets take is not "
                                         "known before, so that all numbers below count it in",
                     Verdict::none, ""});
  const double fraction = d.cost.solid_fraction;
  lines.push_back({"solid fraction of the domain", fmt::format("{:.4g} %", 100 * fraction), warn_if(fraction > 0.64),
                   "equal spheres pack to about 64 % at random; enlarge the domain or place fewer particles"});
}

Verdict steps_verdict(double steps) {
  if (steps < fewest_steps_per_contact) return Verdict::refused;
  return warn_if(steps < few_steps_per_contact);
}

void say_step(const Case& c, const DerivedStep& s, Lines& lines) {
  lines.push_back({"top speed", fmt::format("{:.4g} m/s ({})", s.top_speed, s.top_speed_source), Verdict::none, ""});
  if (std::isnan(s.time_step)) {
    lines.push_back({"time step", is_hard(c) ? "auto has no speed to go by" : "auto has no contact to go by",
                     Verdict::refused, "give simulation.time_step"});
    return;
  }
  lines.push_back(
      {"time step", fmt::format("{:.4g} s ({})", s.time_step, s.automatic ? "auto" : "given"), Verdict::none, ""});
  lines.push_back({"steps of the run", grouped(s.steps), Verdict::none, ""});
  if (is_hard(c))
    lines.push_back({"way in a step", fmt::format("{:.3g} % of the smallest diameter at top speed", 100 * s.travel),
                     warn_if(s.travel > far_travel),
                     "hard collisions are found that late: use a shorter time step, or \"auto\""});
  if (is_hard(c) && s.tip_travel > 0)
    lines.push_back({"way of tips in a step", fmt::format("{:.3g} % of the least thickness", 100 * s.tip_travel),
                     warn_if(s.tip_travel > far_tip_travel),
                     "thin bodies pass each other unseen if they go farther than half their thickness: use a shorter "
                     "time step, or \"auto\""});
  if (std::isfinite(s.contact_time)) {
    lines.push_back({"shortest contact", fmt::format("{:.4g} s, {}", s.contact_time, s.shortest), Verdict::none, ""});
    lines.push_back({"steps per contact", fmt::format("{:.3g}", s.steps_per_contact),
                     steps_verdict(s.steps_per_contact),
                     fmt::format("use a time step of at most {:.3g} s (25 steps), or \"auto\"", s.contact_time / 25)});
  }
  if (s.time_step > s.damped_step * (1 + 1e-12))
    lines.push_back(
        {"dashpots", fmt::format("too strong for this step where {} are packed", s.damped), Verdict::warning,
         fmt::format("beds do not come to rest; use a time step of at most {:.3g} s, or \"auto\"", s.damped_step)});
  if (s.overlap > 0)
    lines.push_back({"overlap at top speed",
                     std::isinf(s.overlap)
                         ? "cohesion is as stiff as the bodies"
                         : fmt::format("{:.3g} % of the smaller radius, {}", 100 * s.overlap, s.deepest),
                     warn_if(s.overlap > c.simulation.max_overlap),
                     fmt::format("the run stops beyond {:g} %: use stiffer materials, lower speeds, or raise "
                                 "simulation.max_overlap",
                                 100 * c.simulation.max_overlap)});
  if (std::isfinite(s.rayleigh_time)) {
    const double fraction = s.time_step / s.rayleigh_time;
    lines.push_back(
        {"Rayleigh time step", fmt::format("{:.4g} s; the step is {:.3g} % of it", s.rayleigh_time, 100 * fraction),
         warn_if(fraction > 0.4), fmt::format("use a time step of at most {:.3g} s", 0.4 * s.rayleigh_time)});
  }
}

void say_fluid(const Case& c, const Derived& d, Lines& lines) {
  const DerivedFluid& f = d.fluid;
  if (!std::isfinite(f.relaxation_time)) return;
  const double ratio = d.step.time_step / f.relaxation_time;
  const bool exact = c.simulation.integrator != "explicit";
  const std::string share = std::isnan(ratio) ? "" : fmt::format("; the step is {:.3g} % of it", 100 * ratio);
  lines.push_back({"drag relaxation time", fmt::format("{:.4g} s{}", f.relaxation_time, share),
                   warn_if(!exact && ratio > 1),
                   "explicit drag needs a step below the relaxation time; use integrator = \"leapfrog\""});
  const bool stokes = c.flow.drag == "stokes" || c.flow.drag == "stokes_ellipsoid";
  lines.push_back({"particle Reynolds number", fmt::format("up to {:.3g}", f.reynolds),
                   warn_if(f.reynolds > (stokes ? 1.0 : 2e5)),
                   stokes ? "Stokes drag holds well below 1; use drag = \"schiller_naumann\""
                          : "above 2e5 the boundary layer turns turbulent and the drag drops"});
  if (f.stokes)
    lines.push_back(
        {"Stokes number",
         fmt::format("{:.3g} (mean flow {:.4g} m/s over {:.4g} m)", *f.stokes, f.flow_speed, f.stokes_length),
         Verdict::none, ""});
}

void say_lift(const Case& c, const Derived& d, Lines& lines) {
  for (const DerivedLift& lift : d.lift)
    lines.push_back({fmt::format("buoyancy of '{}'", lift.material),
                     fmt::format("{}, {:.3g} % of the weight", c.flow.buoyancy ? "on" : "off", 100 * lift.share),
                     warn_if(!c.flow.buoyancy && lift.share > 0.01),
                     "set flow.buoyancy = true, unless gravity.acceleration is already reduced by it"});
}

/// What describes the other model of collisions.
void say_idle(const Case& c, Lines& lines) {
  const std::vector<std::string> keys = idle_keys(c);
  if (keys.empty()) return;
  lines.push_back({fmt::format("no effect on {} collisions", c.contact.collision),
                   fmt::format("{}", fmt::join(keys, ", ")), Verdict::none, ""});
}

/// What belongs to something that the case does not have.
void say_idle_tables(const Case& c, Lines& lines) {
  for (const IdleTable& idle : idle_tables(c))
    lines.push_back({"no effect", fmt::format("{}, without {}", idle.keys, idle.missing), Verdict::warning,
                     "remove it, or give what it needs"});
}

/// What the boundaries do to particles and fields.
void say_boundaries(const Case& c, const Derived& d, Lines& lines) {
  std::string open;
  for (int k = 0; k < 3; ++k)
    for (const char* end : {"min", "max"}) {
      const std::string face = fmt::format("{}_{}", "xyz"[k], end);
      const bool lets_out = std::ranges::any_of(c.outlets, [&](const OutletKeys& o) { return o.face == face; });
      if (!c.domain.periodic[k] && !lets_out) open += (open.empty() ? "" : ", ") + face;
    }
  if (c.walls.empty() && !open.empty())
    lines.push_back({"open boundaries",
                     fmt::format("{}, without wall or outlet: a particle that leaves there stops the run", open),
                     Verdict::none, ""});
  for (const PeriodicJump& jump : d.jumps)
    lines.push_back(
        {jump.key,
         fmt::format("jumps by up to {:.3g} {} at the periodic faces along {}; it is up to {:.3g} {} elsewhere",
                     jump.jump, jump.unit, "xyz"[jump.axis], jump.largest, jump.unit),
         Verdict::warning,
         fmt::format("make it periodic, or set domain.periodic to false along {}", "xyz"[jump.axis])});
}

/// Walls, outlets and grids that are where nobody gets, and walls that jump.
void say_places(const Case& c, const Derived& d, Lines& lines) {
  double reach = 0, smallest = std::numeric_limits<double>::infinity();
  for (const BodyKind& kind : d.kinds) {
    reach = std::max(reach, 0.5 * (kind.largest + kind.effect_gap));
    smallest = std::min(smallest, 0.5 * kind.smallest);
  }
  for (const std::vector<Remark>& remarks :
       {remarks_on_places(c, d.walls, reach), remarks_on_jumps(c, d.walls, d.step.time_step, smallest)})
    for (const Remark& remark : remarks)
      lines.push_back({remark.label, remark.finding, Verdict::warning, remark.remedy});
}

/// Formulas that are not finite somewhere. Nobody need get there, so that it is no error yet.
void say_formulas(const Case& c, Lines& lines) {
  for (const NoNumber& found : formulas_without_number(c))
    lines.push_back({found.key,
                     fmt::format("is {} at ({:.4g}, {:.4g}, {:.4g}) m, t = {:.4g} s", found.value, found.at[0],
                                 found.at[1], found.at[2], found.at[3]),
                     Verdict::warning, "the run stops when a particle meets it: mend the formula"});
}

/// Whether the meshes are closed, and what is unusual in them.
void say_meshes(const Case& c, const Derived& d, Lines& lines) {
  auto mesh = d.meshes.begin();
  for (const WallKeys& wall : c.walls) {
    if (wall.type != "mesh" && wall.type != "triangles") continue;
    const MeshReport& report = *mesh++;
    const bool faulty = report.crowded_edges + report.degenerate + report.duplicate > 0;
    std::string label = fmt::format("wall '{}'", wall.name);
    std::istringstream text(describe(report));
    for (std::string line; std::getline(text, line); label.clear())
      lines.push_back({label, line, label.empty() && faulty ? Verdict::warning : Verdict::none,
                       "look at the mesh where it was made"});
  }
}

void say_cohesion(const DerivedCohesion& cohesion, Lines& lines) {
  lines.push_back(
      {"cohesion of", fmt::format("{}, reduced mass {:.4g} kg", cohesion.what, cohesion.mass), Verdict::none, ""});
  if (cohesion.stickiness)
    lines.push_back({"stickiness number", fmt::format("{:.4g} at {:.4g} m/s", *cohesion.stickiness, cohesion.speed),
                     Verdict::none, ""});
  if (cohesion.pull_off)
    lines.push_back({"pull-off force", fmt::format("{:.4g} N", *cohesion.pull_off), Verdict::none, ""});
  if (cohesion.elastic_sticking_speed && cohesion.restitution < 1)
    lines.push_back({"elastic bodies stick below",
                     fmt::format("{:.4g} m/s (Thornton and Ning 1998)", *cohesion.elastic_sticking_speed),
                     Verdict::none, ""});
  if (cohesion.sticking_speed) {
    const bool always = std::isinf(*cohesion.sticking_speed);
    lines.push_back({"they stick below",
                     always ? "any speed"
                            : fmt::format("{:.4g} m/s (restitution {:.4g} without cohesion)", *cohesion.sticking_speed,
                                          cohesion.restitution),
                     warn_if(always), "keep cohesion_stiffness below the normal stiffness"});
  }
}

/// Linear cohesion between bodies whose effect surfaces are their own.
void say_reach_of_cohesion(const Case& c, const Derived& d, Lines& lines) {
  const auto reaches = [](const BodyKind& kind) { return kind.effect_gap > 0; };
  if (c.contact.laws.cohesion != SC_COHESION_LINEAR || std::ranges::any_of(d.kinds, reaches)) return;
  lines.push_back({"cohesion", "begins at the touch: particles.effect_gap is 0, so that it only softens the spring",
                   Verdict::warning,
                   "give particles.effect_gap: how far beyond the bodies it acts, over both of two alike"});
}

void say_cost(const DerivedCost& cost, Lines& lines) {
  const std::optional<double> free = available_memory();
  const bool short_of = free && cost.memory > *free;
  lines.push_back(
      {"memory",
       fmt::format("{} ({:.0f} B per particle, {:.0f} B per pair, about {:.2g} pairs per particle){}",
                   size_text(cost.memory), cost.bytes_per_particle, cost.bytes_per_pair, cost.pairs_per_particle,
                   short_of ? fmt::format("; {} are available", size_text(*free)) : ""),
       short_of ? Verdict::warning : Verdict::none, "take fewer or larger particles, or a larger machine"});
}

std::string many(std::uint64_t count, const char* what) {
  return fmt::format("{} {}{}", grouped(static_cast<double>(count)), what, count == 1 ? "" : "s");
}

void say_outputs(const DerivedCost& cost, const std::optional<OutputPlace>& place, Lines& lines) {
  lines.push_back({"writes",
                   fmt::format("{} of {}, {} of {}, {} of {}", many(cost.frames, "frame"), size_text(cost.frame_bytes),
                               many(cost.rows, "row"), size_text(cost.row_bytes), many(cost.checkpoints, "checkpoint"),
                               size_text(cost.checkpoint_bytes)),
                   Verdict::none, ""});
  if (cost.contact_bytes > 0)
    lines.push_back(
        {"", fmt::format("contacts of every frame, up to {}", size_text(cost.contact_bytes)), Verdict::none, ""});
  if (cost.average_files > 0)
    lines.push_back(
        {"", fmt::format("{} of averages, {} in all", many(cost.average_files, "file"), size_text(cost.average_bytes)),
         Verdict::none, ""});
  if (cost.wall_files > 0)
    lines.push_back(
        {"", fmt::format("{} of walls, up to {} in all", many(cost.wall_files, "file"), size_text(cost.wall_bytes)),
         Verdict::none, ""});
  if (!place) {
    lines.push_back({"disk", "up to " + size_text(cost.disk), Verdict::none, ""});
    return;
  }
  lines.push_back(
      {"disk",
       fmt::format("up to {}; {} are left for '{}'", size_text(cost.disk), size_text(place->free), place->directory),
       warn_if(cost.disk > place->free),
       "write fewer frames (output.frames) or fields (output.fields), squeeze them (output.precision, "
       "output.compression), or write elsewhere (-o DIR)"});
}

std::string word(Verdict verdict) {
  switch (verdict) {
    case Verdict::ok:
      return "ok";
    case Verdict::warning:
      return "warning";
    case Verdict::refused:
      return "refused";
    default:
      return "";
  }
}

Lines all_lines(const Case& c, const Derived& d, const std::optional<OutputPlace>& place) {
  Lines lines;
  say_particles(c, d, lines);
  say_step(c, d.step, lines);
  say_idle(c, lines);
  say_idle_tables(c, lines);
  say_boundaries(c, d, lines);
  say_meshes(c, d, lines);
  say_places(c, d, lines);
  say_formulas(c, lines);
  say_fluid(c, d, lines);
  for (const CouplingNote& note : coupling_notes(c, d))
    lines.push_back({note.label, note.value, warn_if(!note.remedy.empty()), note.remedy});
  say_lift(c, d, lines);
  if (d.cohesion) say_cohesion(*d.cohesion, lines);
  say_reach_of_cohesion(c, d, lines);
  say_cost(d.cost, lines);
  say_outputs(d.cost, place, lines);
  return lines;
}

}  // namespace

std::string check_warnings(const Case& c, const Derived& d, const std::optional<OutputPlace>& place) {
  std::string text;
  int count = 0;
  for (const Line& line : all_lines(c, d, place)) {
    if (line.verdict != Verdict::warning) continue;
    ++count;
    text += fmt::format("  {}: {}\n    = help: {}\n", line.label, line.value, line.remedy);
  }
  return count == 0 ? text : fmt::format("{} warning{} (scree check):\n{}", count, count == 1 ? "" : "s", text);
}

std::string check_report(const Case& c, const Derived& d, const std::string& refusal,
                         const std::optional<OutputPlace>& place) {
  const Lines lines = all_lines(c, d, place);
  std::size_t width = 0;
  for (const Line& line : lines) width = std::max(width, line.label.size());
  std::string text = fmt::format("{}\n\n", c.simulation.title.empty() ? c.path : c.simulation.title);
  Verdict worst = Verdict::ok;
  for (const Line& line : lines) {
    text += fmt::format("  {:7}  {:{}}  {}\n", word(line.verdict), line.label, width, line.value);
    if (line.verdict >= Verdict::warning) text += fmt::format("           {:{}}  = help: {}\n", "", width, line.remedy);
    worst = std::max(worst, line.verdict);
  }
  if (!refusal.empty()) return fmt::format("{}\nThe case would be refused:\n{}\n", text, refusal);
  return text + (worst == Verdict::refused   ? "\nThe case would be refused.\n"
                 : worst == Verdict::warning ? "\nThe case can be run; mind the warnings.\n"
                                             : "\nThe case can be run.\n");
}

}  // namespace scree
