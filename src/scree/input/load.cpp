// The stages of loading: syntax, overrides, keys, defaults that depend on other keys, checks.
#include "scree/input/load.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scree/base/error.h"
#include "scree/data/forms.h"
#include "scree/input/bind.h"
#include "scree/input/checks.h"
#include "scree/input/located.h"
#include "scree/input/overrides.h"
#include "scree/input/toml_reader.h"

namespace scree {
namespace {

constexpr std::uintmax_t largest_file = 256u << 20;

struct Outcome {
  Case c;
  Origins origins;
  std::vector<Problem> problems;
};

/// A path that is relative to the case file, made absolute.
std::string beside_case(const Case& c, const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path base = std::filesystem::path(c.path).parent_path();
  return std::filesystem::absolute(base / file, ignored).lexically_normal().string();
}

/// Names by number, and the whole domain where no box is given.
template <class Keys>
void complete_measures(std::vector<Keys>& list, const char* table, const char* name, const DomainKeys& domain,
                       const Origins& origins) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string path = item_path(table, i);
    if (!origins.given(path + ".name")) list[i].name = fmt::format("{}{}", name, i);
    if (!origins.given(path + ".min")) list[i].min = domain.min;
    if (!origins.given(path + ".max")) list[i].max = domain.max;
  }
}

/// The exponents of shapes that have a name, and the diameter of equal volume where the half axes alone tell the size.
void complete_shape(ParticleKeys& p, bool has_diameter) {
  if (p.shape == "sphere" || p.shape == "ellipsoid" || other_shape(p.shape)) p.exponents = {1, 1};
  if (p.shape == "cylinder") p.exponents = {0.25, 1};
  if (p.shape == "box") p.exponents = {0.25, 0.25};
  const Vec3& a = p.half_axes;
  if (p.shape == "sphere" || has_diameter || p.exponents.size() != 2 || !(a[0] > 0 && a[1] > 0 && a[2] > 0)) return;
  p.diameter.value = 2 * make_form(p.shape, a, p.exponents[0], p.exponents[1]).equivalent_radius *
                     bounding_radius(p.shape, a, p.exponents[0], p.exponents[1]);
}

/// Names by number, and the whole face where no part of it is given.
void complete_fluid(Case& c, const Origins& origins) {
  FluidKeys& f = c.fluid;
  const auto name = [&](auto& list, const char* table, const char* word) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!origins.given(item_path(table, i) + ".name")) list[i].name = fmt::format("{}{}", word, i);
  };
  name(f.blocks, "fluid.blocks", "block");
  name(f.obstacles, "fluid.obstacles", "obstacle");
  name(f.patches, "fluid.patches", "patch");
  name(f.probes, "fluid.probes", "probe");
  name(f.lines, "fluid.lines", "line");
  name(f.scalars, "fluid.scalars", "scalar");
  for (std::size_t i = 0; i < f.patches.size(); ++i) {
    const std::string path = item_path("fluid.patches", i);
    if (!origins.given(path + ".min")) f.patches[i].min = c.domain.min;
    if (!origins.given(path + ".max")) f.patches[i].max = c.domain.max;
  }
}

/// Defaults that are not constants: names by number, the whole domain as region, absolute file names, a tangential law
/// that fits the normal one.
void complete(Case& c, const Origins& origins) {
  if (!origins.given("contact.tangential") && c.contact.laws.normal == SC_NORMAL_HERTZ)
    c.contact.laws.tangential = SC_TANGENTIAL_MINDLIN;
  for (std::size_t i = 0; i < c.particles.size(); ++i) {
    ParticleKeys& p = c.particles[i];
    const std::string path = item_path("particles", i);
    if (!origins.given(path + ".name")) p.name = fmt::format("group{}", i);
    if (!origins.given(path + ".region_min")) p.region_min = c.domain.min;
    if (!origins.given(path + ".region_max")) p.region_max = c.domain.max;
    complete_shape(p, origins.given(path + ".diameter"));
    for (std::string* file : {&p.file, &p.checkpoint})
      if (!file->empty()) *file = beside_case(c, *file);
  }
  for (std::size_t i = 0; i < c.walls.size(); ++i) {
    if (!origins.given(item_path("walls", i) + ".name")) c.walls[i].name = fmt::format("wall{}", i);
    if (!c.walls[i].file.empty()) c.walls[i].file = beside_case(c, c.walls[i].file);
  }
  for (std::size_t i = 0; i < c.outlets.size(); ++i)
    if (!origins.given(item_path("outlets", i) + ".name")) c.outlets[i].name = fmt::format("outlet{}", i);
  complete_fluid(c, origins);
  complete_measures(c.analysis.planes, "analysis.planes", "plane", c.domain, origins);
  complete_measures(c.analysis.averages, "analysis.averages", "average", c.domain, origins);
  complete_measures(c.analysis.surfaces, "analysis.surfaces", "surface", c.domain, origins);
  complete_measures(c.analysis.regions, "analysis.regions", "region", c.domain, origins);
}

Outcome evaluate(Table root, const std::string& path, const std::vector<std::string>& overrides) {
  Outcome result;
  result.c.path = path;
  for (std::size_t i = 0; i < overrides.size(); ++i)
    apply_override(root, overrides[i], static_cast<int>(i) + 1, result.problems);
  bind_case(root, result.c, result.origins, result.problems);
  complete(result.c, result.origins);
  const Check check{result.c, result.origins, result.problems};
  check_materials(check);
  check_hard(check);
  check_vertices(check);
  check_geometry(check);
  check_walls(check);
  check_particles(check);
  check_fields(check);
  check_fluid(check);
  check_heat(check);
  check_output(check);
  check_exchange(check);
  check_analysis(check);
  check_verify(check);
  return result;
}

/// Every variant of a verification case must be a valid case itself.
void check_variants(const Table& root, Outcome& result) {
  for (std::size_t i = 0; i < result.c.verify.variants.size(); ++i) {
    const VariantKeys& variant = result.c.verify.variants[i];
    const Outcome changed = evaluate(root, result.c.path, variant.set);
    if (changed.problems.empty()) continue;
    const Problem& first = changed.problems.front();
    const int set = first.place.source - 1;
    const std::string by = set >= 0 ? fmt::format("by \"{}\"", variant.set[set]) : "not a valid case";
    result.problems.push_back({"E181", result.origins.place(item_path("verify.variants", i) + ".set"),
                               fmt::format("variant '{}': {}", variant.name, first.message), by, first.help});
  }
}

[[noreturn]] void unreadable(const std::string& path, const std::string& why) {
  throw InputError(
      fmt::format("{}: error[E100]: cannot read the case file: {}\n      = help: scree explain E100", path, why));
}

std::string read_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) unreadable(path, "it is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) unreadable(path, std::strerror(errno));
  if (std::filesystem::file_size(path, error) > largest_file && !error) unreadable(path, "it is larger than 256 MiB");
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) unreadable(path, "reading failed");
  return text;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& path_for_messages, const std::vector<std::string>& overrides,
                bool colour) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const Sources sources{path_for_messages, std::string(text), overrides};
  std::optional<Problem> syntax;
  const Table root = read_toml(text, 0, syntax);
  if (syntax) throw InputError(render(sources, {*syntax}, colour));
  Outcome result = evaluate(root, path_for_messages, overrides);
  // With overrides this may be a variant itself, which those of the others would contradict.
  if (result.problems.empty() && overrides.empty()) check_variants(root, result);
  if (!result.problems.empty()) throw InputError(render(sources, result.problems, colour));
  result.c.text = std::make_shared<const CaseText>(CaseText{sources, result.origins, colour});
  return result.c;
}

Case load_case(const std::string& path, const std::vector<std::string>& overrides, bool colour) {
  return parse_case(read_file(path), path, overrides, colour);
}

}  // namespace scree
