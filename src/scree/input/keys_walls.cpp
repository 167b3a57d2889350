// Walls: their shapes, when they are there, and how they move.
#include "scree/input/keys.h"

namespace scree {
namespace {

const Section& motion_section() {
  using S = MotionKeys;
  static const std::vector<std::string> turning = {"rotation", "expression"};
  static const Section section = {
      "walls.motion",
      "the motion",
      "How a wall moves as prescribed. Its place in the case file is that at t = 0.",
      {key("type", &S::type,
           "none: at rest; velocity: straight on; rotation: about an axis; oscillation: to and fro as a sine; "
           "expression: displacement and angle as formulas of t; surface: the wall stays, its surface moves along "
           "itself, as a conveyor belt does")
           .one_of({"none", "velocity", "rotation", "oscillation", "expression", "surface"}),
       key("velocity", &S::velocity, "velocity of the wall, or of its surface")
           .unit("m/s")
           .required()
           .only_with("type", {"velocity", "surface"}),
       key("point", &S::point, "a point on the axis of rotation; the torque in the series is about it").unit("m"),
       key("axis", &S::axis, "direction of the axis of rotation, right-handed; any length").only_with("type", turning),
       key("angular_velocity", &S::angular_velocity, "how fast it turns")
           .unit("rad/s")
           .required()
           .only_with("type", {"rotation"}),
       key("amplitude", &S::amplitude, "largest displacement from the middle, with its direction")
           .unit("m")
           .required()
           .only_with("type", {"oscillation"}),
       key("frequency", &S::frequency, "of the oscillation")
           .unit("Hz")
           .above(0)
           .required()
           .only_with("type", {"oscillation"}),
       key("phase", &S::phase, "of the sine at the start: 90 deg starts at the upper end")
           .unit("rad")
           .only_with("type", {"oscillation"}),
       key("displacement", &S::displacement, "components of the way from the place at t = 0, formulas of t")
           .unit("m")
           .defaults_to("[0, 0, 0]")
           .only_with("type", {"expression"}),
       key("angle", &S::angle, "angle by which the wall has turned about its axis in rad, a formula of t")
           .is_a(TextKind::formula)
           .only_with("type", {"expression"}),
       key("start", &S::start, "when the motion begins; formulas and the sine count t from here").unit("s").at_least(0),
       key("stop", &S::stop, "when it ends: the wall stays where it is then").unit("s").above(0).defaults_to("never")},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace

const Section& walls_section() {
  using S = WallKeys;
  static const std::vector<std::string> round = {"cylinder", "cone"};
  static const Section section = {
      "walls",
      "[[walls]]",
      "A wall, at rest or moving as prescribed, for all the time or for a part of it. Walls are not repeated beyond "
      "periodic faces of the domain.",
      {key("name", &S::name, "name in messages and results").is_a(TextKind::name).defaults_to("wall0, wall1, ..."),
       key("type", &S::type,
           "plane: infinite, one-sided; rectangle: aligned with the axes; plate: a rectangle of any orientation; box: "
           "the six faces of a box; cylinder, cone: about any axis; triangles: given by their corners; mesh: from an "
           "STL "
           "or OBJ file. All but planes, and boxes with the particles outside, act on both sides")
           .one_of({"plane", "rectangle", "plate", "box", "cylinder", "cone", "triangles", "mesh"})
           .required(),
       key("material", &S::material, "name of a material").required(),
       key("point", &S::point, "a point of the plane").unit("m").required().only_with("type", {"plane"}),
       key("normal", &S::normal, "direction from the plane towards the particles; any length")
           .required()
           .only_with("type", {"plane"}),
       key("min", &S::min, "lower corner; a rectangle has min = max along one axis")
           .unit("m")
           .required()
           .only_with("type", {"rectangle", "box"}),
       key("max", &S::max, "upper corner").unit("m").required().only_with("type", {"rectangle", "box"}),
       key("side", &S::side, "on which side of the box the particles are")
           .one_of({"inside", "outside"})
           .only_with("type", {"box"}),
       key("corner", &S::corner, "a corner of the plate").unit("m").required().only_with("type", {"plate"}),
       key("edge_a", &S::edge_a, "the edge from that corner to the next")
           .unit("m")
           .required()
           .only_with("type", {"plate"}),
       key("edge_b", &S::edge_b, "the edge from that corner to the other next one, at right angles to edge_a")
           .unit("m")
           .required()
           .only_with("type", {"plate"}),
       key("start", &S::start, "middle of the circle at one end").unit("m").required().only_with("type", round),
       key("end", &S::end,
           "middle of the circle at the other end; may be that of start in a cone, which is then a ring "
           "or, with one radius 0, a disc")
           .unit("m")
           .required()
           .only_with("type", round),
       key("radius", &S::radius, "of the cylinder").unit("m").above(0).required().only_with("type", {"cylinder"}),
       key("start_radius", &S::start_radius, "of the circle at the start; 0 for a tip")
           .unit("m")
           .at_least(0)
           .required()
           .only_with("type", {"cone"}),
       key("end_radius", &S::end_radius, "of the circle at the end; 0 for a tip")
           .unit("m")
           .at_least(0)
           .required()
           .only_with("type", {"cone"}),
       key("axis", &S::axis, "axis of a ring or disc, whose start and end are the same; any length")
           .defaults_to("from start to end")
           .only_with("type", {"cone"}),
       key("closed", &S::closed, "whether discs close the ends").only_with("type", round),
       key("vertices", &S::vertices, "corners of the triangles, three for each; equal corners are joined")
           .unit("m")
           .required()
           .only_with("type", {"triangles"}),
       key("file", &S::file, "STL (ASCII or binary) or OBJ file, relative to the case file")
           .is_a(TextKind::file)
           .required()
           .only_with("type", {"mesh"}),
       key("scale", &S::scale, "length of the file's unit").unit("m").above(0).only_with("type", {"mesh"}),
       key("offset", &S::offset, "where the origin of the file is, after scaling")
           .unit("m")
           .only_with("type", {"mesh"}),
       key("from", &S::from, "when the wall appears").unit("s").at_least(0),
       key("until", &S::until, "when it is taken away").unit("s").above(0).defaults_to("never"),
       key("temperature", &S::temperature, "with [heat]: that the wall keeps, up to its surface")
           .unit("K")
           .at_least(0)
           .defaults_to("it lets no heat through"),
       table("motion", &S::motion, motion_section())},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
