// Hard collisions: how the impulses of a step are found.
#include "scree/input/keys.h"

namespace scree {

const Section& hard_section() {
  using S = HardKeys;
  static const Section section = {
      "hard",
      "[hard]",
      "How collisions are solved with contact.collision = 'hard'; soft ones do not read it.",
      {key("order", &S::order,
           "coloured: all contacts of a step together, with friction, and resting contacts apart from collisions; "
           "sequential: each pair, then each wall, once, without friction, for comparison")
           .one_of({"coloured", "sequential"}),
       key("sweeps", &S::sweeps,
           "most visits to each contact in each of the two phases of a step; stacks of more than twenty bodies come to "
           "rest with "
           "more")
           .between(1, 1e6),
       key("residual", &S::residual,
           "sweeps for rest end when they correct speeds by less than this share of the fastest approach, those of "
           "collisions at its square")
           .between(0, 1),
       key("threshold", &S::threshold,
           "approaches up to this speed are no collisions: they end without restitution, as contacts at rest do; "
           "with order = 'sequential' they are left alone")
           .unit("m/s")
           .at_least(0)
           .defaults_to("twice the speed that uniform gravity gives in a step; 0 without"),
       key("slop", &S::slop,
           "overlap that the relocation of bodies leaves, as a share of the smaller radius, so that contacts stay")
           .above(0)
           .at_most(0.1),
       key("travel", &S::travel,
           "with time_step = \"auto\": way at top speed in a step, as a share of the smallest diameter; of the tip of "
           "a "
           "thin body that tumbles, at most five times this share of its thickness")
           .above(0)
           .at_most(0.25)},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
