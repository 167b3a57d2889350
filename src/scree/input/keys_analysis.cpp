// What is measured while a run goes on.
#include "scree/input/keys.h"

namespace scree {
namespace {

const Section& planes_section() {
  using S = PlaneKeys;
  static const Section section = {
      "analysis.planes",
      "[[analysis.planes]]",
      "A plane, or a part of it, at which the particles that pass are counted: columns NAME_count, NAME_against, "
      "NAME_mass and NAME_rate of the series.",
      {key("name", &S::name, "name of its columns").is_a(TextKind::name).defaults_to("plane0, plane1, ..."),
       key("point", &S::point, "a point of the plane, the middle of a disc").unit("m").required(),
       key("normal", &S::normal, "direction in which passing counts positive; any length").required(),
       key("radius", &S::radius, "only what passes within this distance of the point counts")
           .unit("m")
           .above(0)
           .defaults_to("no limit"),
       key("min", &S::min, "lower corner of the box within which passing counts").unit("m").defaults_to("the domain"),
       key("max", &S::max, "its upper corner").unit("m").defaults_to("the domain")},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const Section& averages_section() {
  using S = AverageKeys;
  static const Section section = {
      "analysis.averages",
      "[[analysis.averages]]",
      "Averages over space and time on a regular grid: solid fraction, velocity, granular temperature, fluxes and "
      "stresses, by exact coarse graining.",
      {key("name", &S::name, "name of its files").is_a(TextKind::name).defaults_to("average0, average1, ..."),
       key("min", &S::min, "lower corner of the grid").unit("m").defaults_to("the domain"),
       key("max", &S::max, "upper corner of the grid").unit("m").defaults_to("the domain"),
       key("cells", &S::cells, "number of cells along x, y and z; the averages reach over three of them").required(),
       key("from", &S::from, "time of the first sample").unit("s").at_least(0),
       key("every", &S::every, "time between two samples").unit("s").above(0).required(),
       key("window", &S::window, "time over which samples are averaged into one file; 0: all of them")
           .unit("s")
           .at_least(0)},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const Section& surfaces_section() {
  using S = SurfaceKeys;
  static const Section section = {
      "analysis.surfaces",
      "[[analysis.surfaces]]",
      "The free surface of a bed in a box: columns NAME_level, NAME_angle and NAME_direction of the series.",
      {key("name", &S::name, "name of its columns").is_a(TextKind::name).defaults_to("surface0, surface1, ..."),
       key("min", &S::min, "lower corner of the box, in a drum the middle part").unit("m").defaults_to("the domain"),
       key("max", &S::max, "upper corner of the box").unit("m").defaults_to("the domain"),
       key("cells", &S::cells, "number of cells along x, y and z; they should be two diameters wide or more")
           .required(),
       key("up", &S::up, "direction in which the bed ends").one_of({"x", "y", "z", "-x", "-y", "-z"}),
       key("solid_fraction", &S::solid_fraction, "smallest solid fraction of a cell that belongs to the bed")
           .above(0)
           .below(1)},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

const Section& regions_section() {
  using S = RegionKeys;
  static const Section section = {
      "analysis.regions",
      "[[analysis.regions]]",
      "A box in which the packing is measured: columns NAME_solid_fraction and NAME_coordination of the series; of "
      "bodies that are no spheres also how they are turned, NAME_nematic_order and NAME_cos2_x, _y, _z.",
      {key("name", &S::name, "name of its columns").is_a(TextKind::name).defaults_to("region0, region1, ..."),
       key("min", &S::min, "lower corner of the box").unit("m").defaults_to("the domain"),
       key("max", &S::max, "upper corner of the box").unit("m").defaults_to("the domain")},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

}  // namespace

const Section& analysis_section() {
  using S = AnalysisKeys;
  static const Section section = {
      "analysis",
      "[analysis]",
      "What is measured while the run goes on.",
      {key("agglomerates", &S::agglomerates,
           "whether agglomerates (particles connected by contact or effect distance) are found, at every row of the "
           "series"),
       key("stop_agglomerated", &S::stop_agglomerated,
           "ends the run when this fraction of the particles is in agglomerates; 0: never")
           .between(0, 1)
           .only_with("agglomerates", {"true"}),
       tables<S, PlaneKeys>(
           "planes", [](S & s) -> auto& { return s.planes; }, planes_section()),
       tables<S, AverageKeys>(
           "averages", [](S & s) -> auto& { return s.averages; }, averages_section()),
       tables<S, SurfaceKeys>(
           "surfaces", [](S & s) -> auto& { return s.surfaces; }, surfaces_section()),
       tables<S, RegionKeys>(
           "regions", [](S & s) -> auto& { return s.regions; }, regions_section())},
      [] { return std::make_shared<S>(); },
      true};
  return section;
}

}  // namespace scree
