#include "scree/app/take_over.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <sstream>

#include "scree/base/error.h"
#include "scree/input/located.h"
#include "scree/output/run_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// The error of a problem at a key of a group.
InputError at(const Case& c, const ParticleKeys& keys, const char* key, Problem problem) {
  const auto index = static_cast<std::size_t>(&keys - c.particles.data());
  return error_at(c, fmt::format("particles.{}.{}", index, key), std::move(problem));
}

fs::path checkpoint_file(const Case& c, const ParticleKeys& keys) {
  std::error_code ignored;
  if (!fs::is_directory(keys.checkpoint, ignored)) return keys.checkpoint;
  const auto newest = newest_checkpoint(keys.checkpoint).path;
  if (!newest)
    throw at(c, keys, "checkpoint",
             {"E174",
              {},
              fmt::format("the directory '{}' holds no checkpoint that can be read", keys.checkpoint),
              "",
              "give the directory of a finished or interrupted run, or one of its checkpoints"});
  return *newest;
}

/// Index of the wanted group in the other run, or -1 for all.
std::int32_t source_group(const Case& c, const Archive& archive, const ParticleKeys& keys) {
  if (keys.source_group.empty()) return -1;
  std::istringstream names(archive.text("groups"));
  std::string all;
  std::int32_t index = 0;
  for (std::string name; std::getline(names, name); ++index) {
    if (name == keys.source_group) return index;
    all += (all.empty() ? "'" : ", '") + name + "'";
  }
  throw at(c, keys, "source_group",
           {"E160",
            {},
            fmt::format("{} has no group '{}'", archive.origin, keys.source_group),
            "",
            "its groups are " + all});
}

Archive checkpoint_of(const Case& c, const ParticleKeys& keys) {
  const fs::path file = checkpoint_file(c, keys);
  try {
    return read_archive(file, "take particles from");
  } catch (const InputError& error) {
    throw at(c, keys, "checkpoint",
             {"E174",
              {},
              error.what(),
              "",
              "give the directory of a finished or interrupted run, or one of its checkpoints"});
  }
}

}  // namespace

Particles particles_of(const Archive& archive, const Ranks& ranks) {
  Particles out(archive.contains("form"));
  if (archive.contains("stream")) out.couple(archive.contains("gradient"));
  if (archive.contains("heat")) out.give_heat();
  out.resize(equal_part(static_cast<std::uint64_t>(archive.integer("particles")), ranks).second);
  out.for_each_field([&](std::string_view name, auto& column, Travels, bool saved, auto) {
    if (!saved) return;
    using Component = typename std::remove_reference_t<decltype(column)>::value_type;
    const auto values = archive.part<Component>(std::string(name), column.components, ranks);
    if (values.size() != column.values.size())
      throw InputError(archive.origin + ": wrong number of " + std::string(name));
    std::copy(values.begin(), values.end(), column.values.begin());
  });
  return out;
}

Forms forms_of(const Archive& archive) {
  Forms forms;
  if (!archive.contains("forms")) return forms;
  const auto numbers = archive.get<double>("forms", 5);
  // Where there are only superellipsoids, nothing says so.
  std::istringstream names(archive.contains("shapes") ? archive.text("shapes") : "");
  for (std::size_t k = 0; k + 5 <= numbers.size(); k += 5) {
    std::string name;
    std::getline(names, name);
    forms.push_back(
        make_form_at_radius_one(name, {numbers[k], numbers[k + 1], numbers[k + 2]}, numbers[k + 3], numbers[k + 4]));
  }
  return forms;
}

void save_forms(const Forms& forms, Archive& archive) {
  if (forms.empty()) return;
  std::vector<double> numbers;
  for (const Form& form : forms) {
    const Axes axes = form.half_axes();
    numbers.insert(numbers.end(), axes.begin(), axes.end());
    numbers.insert(numbers.end(), form.exponents.begin(), form.exponents.end());
  }
  archive.put("forms", std::move(numbers), 5);
  if (!has_other_shapes(forms)) return;
  std::string names;
  for (const Form& form : forms) names += std::string(form.shape_name()) + "\n";
  archive.set("shapes", names);
}

std::string group_names(const Case& c) {
  std::string names;
  for (const ParticleKeys& keys : c.particles) names += keys.name + "\n";
  return names;
}

bool takes_over(const Case& c) {
  return std::any_of(c.particles.begin(), c.particles.end(),
                     [](const ParticleKeys& keys) { return keys.insert == "checkpoint"; });
}

namespace {

/// What needs spheres refuses others that come from a checkpoint, as it does those of a group.
void refuse_shapes(const Case& c, const ParticleKeys& keys, const std::string& origin) {
  const auto refuse = [&](bool chosen, const char* what, const char* help) {
    if (chosen)
      throw at(c, keys, "checkpoint",
               {"E164", {}, fmt::format("{} for spheres only", what), origin + " holds other particles", help});
  };
  refuse(c.gravity.type == "rotating", "a rotating frame is there",
         "turn the walls ([walls.motion]) instead of the frame");
}

}  // namespace

std::vector<GivenParticle> take_over(const Case& c, const ParticleKeys& keys) {
  const Archive archive = checkpoint_of(c, keys);
  const Particles p = particles_of(archive);
  const Forms forms = forms_of(archive);
  const std::int32_t wanted = source_group(c, archive, keys);
  std::vector<std::uint32_t> order(p.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return p.id[a] < p.id[b]; });
  std::vector<GivenParticle> taken;
  double largest = 0;
  for (const std::uint32_t i : order) {
    const double *m = p.motion.row(i), *s = p.spin.row(i);
    if (wanted < 0 ? m[lane::inverse_mass] == 0 : p.group[i] != wanted) continue;
    const double rate = s[lane::inverse_radius];
    taken.push_back({{m[0], m[1], m[2]},
                     {{m[lane::vx], m[lane::vy], m[lane::vz]}},
                     {{s[0] * rate, s[1] * rate, s[2] * rate}},
                     2 * p.radius_by_volume(i),
                     {},
                     {}});
    if (p.shaped()) {
      const double* q = p.orientation.row(i);
      taken.back().orientation = sc_make_quat(q[0], q[1], q[2], q[3]);
      taken.back().shape = forms.at(static_cast<std::size_t>(p.form[i]));
      if (p.form[i] != 0) refuse_shapes(c, keys, archive.origin);
    }
    largest = std::max(largest, 2 * m[lane::radius]);
  }
  if (taken.empty())
    throw at(c, keys, "checkpoint", {"E174", {}, archive.origin + " holds no particle to take over", "", ""});
  for (int k = 0; k < 3; ++k)
    if (c.domain.periodic[k] && c.domain.max[k] - c.domain.min[k] <= 2 * (largest + keys.effect_gap))
      throw at(
          c, keys, "checkpoint",
          {"E166",
           {},
           fmt::format("the domain is too small to be periodic along {} with particles of {:g} m", "xyz"[k], largest),
           "",
           "a periodic box must be longer than two interaction ranges"});
  return taken;
}

}  // namespace scree
