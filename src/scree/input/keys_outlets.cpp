// Where particles leave.
#include "scree/input/keys.h"

namespace scree {

const Section& outlets_section() {
  using S = OutletKeys;
  static const Section section = {
      "outlets",
      "[[outlets]]",
      "Where particles leave: an open face of the domain, or a region that takes what comes into it. They are counted "
      "in "
      "series.csv. One that several outlets would take goes into the first of them.",
      {key("name", &S::name, "name in messages and results").is_a(TextKind::name).defaults_to("outlet0, outlet1, ..."),
       key("type", &S::type,
           "face: takes particles whose centre leaves the domain there; region: takes those whose centre is in a box")
           .one_of({"face", "region"}),
       key("face", &S::face, "the face of the domain that is open")
           .one_of({"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"})
           .required()
           .only_with("type", {"face"}),
       key("min", &S::min, "lower corner of the region").unit("m").required().only_with("type", {"region"}),
       key("max", &S::max, "upper corner of the region").unit("m").required().only_with("type", {"region"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
