// What is measured: names, boxes and grids that make sense.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/input/checks.h"

namespace scree {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr double most_cells = 1e7;

template <class Keys>
void check_names(const Check& check, const std::vector<Keys>& list, const char* table) {
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (list[i].name == list[j].name)
        check.fail("E161", item_path(table, i) + ".name", fmt::format("'{}' is there twice", list[i].name),
                   "used above", "results are found by this name");
}

/// A box that is not empty.
template <class Keys>
void check_box(const Check& check, const Keys& keys, const std::string& path) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(keys.max[k] > keys.min[k])) {
      const char* corner = check.origins.given(path + ".max") ? ".max" : ".min";
      return check.fail("E165", path + corner,
                        fmt::format("the box of '{}' is empty along {}", keys.name, axis_names[k]),
                        fmt::format("from {} m to {} m", keys.min[k], keys.max[k]),
                        "'min' is the lower corner, 'max' the upper one; the domain, if not given");
    }
}

/// A box that a period holds.
template <class Keys>
void check_period(const Check& check, const Keys& keys, const char* what, const std::string& path) {
  const DomainKeys& domain = check.c.domain;
  for (std::size_t k = 0; k < 3; ++k)
    if (domain.periodic[k] && (keys.min[k] < domain.min[k] || keys.max[k] > domain.max[k]))
      check.fail("E165", path + (check.origins.given(path + ".min") ? ".min" : ".max"),
                 fmt::format("the {} of '{}' reaches beyond the period along {}", what, keys.name, axis_names[k]),
                 fmt::format("the domain is from {} m to {} m", domain.min[k], domain.max[k]));
}

template <class Keys>
void check_cells(const Check& check, const Keys& keys, const std::string& path) {
  const auto& n = keys.cells;
  if (n.size() != 3)
    return check.fail("E105", path + ".cells", "'cells' has three whole numbers: along x, y and z",
                      fmt::format("{} given", n.size()));
  if (std::find(n.begin(), n.end(), 0u) != n.end())
    return check.fail("E130", path + ".cells", "every axis has one cell or more", "must be at least 1");
  const double total = static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]);
  if (total > most_cells)
    check.fail("E130", path + ".cells", fmt::format("{:.3g} cells are too many", total),
               fmt::format("at most {:.0e}", most_cells));
}

void check_plane(const Check& check, const PlaneKeys& plane, const std::string& path) {
  const Vec3& n = plane.normal;
  if (!(std::hypot(n[0], n[1], n[2]) > 0))
    return check.fail("E165", path + ".normal", fmt::format("the normal of plane '{}' has no direction", plane.name),
                      "its length is 0", "give the direction in which passing counts positive");
  const auto across = static_cast<int>(std::count_if(n.begin(), n.end(), [](double x) { return x != 0; }));
  for (std::size_t k = 0; k < 3; ++k)
    if (check.c.domain.periodic[k] && n[k] != 0 && across > 1)
      return check.fail("E165", path + ".normal",
                        fmt::format("plane '{}' does not fit the period along {}", plane.name, axis_names[k]),
                        "oblique to a periodic axis",
                        "the normal must be along a periodic axis or at right angles to it");
  check_box(check, plane, path);
}

void check_average(const Check& check, const AverageKeys& average, const std::string& path) {
  check_box(check, average, path);
  check_cells(check, average, path);
  if (average.window > 0 && average.window < average.every)
    check.fail("E167", path + ".window", fmt::format("the window of '{}' is shorter than 'every'", average.name),
               fmt::format("every is {} s", average.every), "a window holds one sample or more");
  check_period(check, average, "grid", path);
}

template <class Keys, class One>
void check_each(const Check& check, const std::vector<Keys>& list, const char* table, One&& one) {
  check_names(check, list, table);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (check.sound({item_path(table, i), "domain"})) one(check, list[i], item_path(table, i));
}

}  // namespace

void check_analysis(const Check& check) {
  const AnalysisKeys& a = check.c.analysis;
  check_each(check, a.planes, "analysis.planes", check_plane);
  check_each(check, a.averages, "analysis.averages", check_average);
  check_each(check, a.surfaces, "analysis.surfaces",
             [](const Check& c, const SurfaceKeys& surface, const std::string& path) {
               check_box(c, surface, path);
               check_cells(c, surface, path);
             });
  check_each(check, a.regions, "analysis.regions",
             [](const Check& c, const RegionKeys& region, const std::string& path) {
               check_box(c, region, path);
               check_period(c, region, "box", path);
             });
}

}  // namespace scree
