// Groups of particles: size, motion, and how they come to be.
#include <fmt/format.h>

#include "scree/data/forms.h"
#include "scree/input/keys.h"

namespace scree {
namespace {

const Section& diameter_section() {
  using S = SizeKeys;
  static const std::vector<std::string> continuous = {"uniform", "normal", "lognormal"};
  static const std::vector<std::string> peaked = {"normal", "lognormal"};
  static const Section section = {
      "particles.diameter",
      "the diameter",
      "Diameter of the body, or of the sphere of equal volume: one value for all, or a distribution by number. Shapes "
      "may "
      "have their size from 'half_axes' instead.",
      {key("distribution", &S::distribution,
           "single: one value; classes: some values with their fractions; uniform, normal, lognormal: between min and "
           "max")
           .one_of({"single", "classes", "uniform", "normal", "lognormal"}),
       key("value", &S::value, "the single diameter")
           .unit("m")
           .above(0)
           .required()
           .only_with("distribution", {"single"}),
       key("diameters", &S::diameters, "diameters of the classes")
           .unit("m")
           .above(0)
           .required()
           .only_with("distribution", {"classes"}),
       key("fractions", &S::fractions, "fractions of the classes by number; they add up to 1")
           .above(0)
           .at_most(1)
           .required()
           .only_with("distribution", {"classes"}),
       key("mean", &S::mean, "mean of the diameter before it is cut at min and max")
           .unit("m")
           .above(0)
           .required()
           .only_with("distribution", peaked),
       key("deviation", &S::deviation, "standard deviation of the diameter before it is cut at min and max")
           .unit("m")
           .above(0)
           .required()
           .only_with("distribution", peaked),
       key("min", &S::min, "smallest diameter").unit("m").above(0).required().only_with("distribution", continuous),
       key("max", &S::max, "largest diameter").unit("m").above(0).required().only_with("distribution", continuous)},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& velocity_section() {
  using S = VelocityKeys;
  static const Section section = {
      "particles.velocity",
      "the velocity",
      "Initial velocity: one value for all, random, or that of the fluid.",
      {key("type", &S::type,
           "given: one velocity; random: normal deviates about it; fluid: that of the flow at the particle")
           .one_of({"given", "random", "fluid"}),
       key("value", &S::value, "the velocity, or the mean of random ones")
           .unit("m/s")
           .only_with("type", {"given", "random"}),
       key("deviation", &S::deviation, "standard deviation of each component")
           .unit("m/s")
           .above(0)
           .required()
           .only_with("type", {"random"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& orientation_section() {
  using S = OrientationKeys;
  static const std::vector<std::string> turned = {"given", "aligned"};
  static const Section section = {
      "particles.orientation",
      "the orientation",
      "How the axes of particles that are no spheres lie at the start.",
      {key("type", &S::type,
           "given: all alike; random: uniform over all orientations; aligned: as given, then turned a little at random")
           .one_of({"given", "random", "aligned"}),
       key("quaternion", &S::quaternion, "w, x, y, z of the rotation from the particle's axes to those of the domain")
           .between(-1, 1)
           .defaults_to("the rotation about 'axis' by 'angle'")
           .only_with("type", turned),
       key("axis", &S::axis, "axis of the rotation, of any length").only_with("type", turned),
       key("angle", &S::angle, "angle of the rotation").unit("rad").only_with("type", turned),
       key("spread", &S::spread, "standard deviation of the random turn about each axis of the domain")
           .unit("rad")
           .above(0)
           .required()
           .only_with("type", {"aligned"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

/// Words of shapes with half axes.
std::vector<std::string> shapes_but_spheres() {
  std::vector<std::string> words{"ellipsoid", "superellipsoid", "cylinder", "box"};
  for (const OtherShape& other : other_shapes()) words.emplace_back(other.name);
  return words;
}

std::vector<std::string> shapes() {
  std::vector<std::string> words = shapes_but_spheres();
  words.insert(words.begin(), "sphere");
  return words;
}

/// What the half axes of shapes beside superellipsoids are.
std::string meaning_of_others() {
  std::string text;
  for (const OtherShape& other : other_shapes())
    text += fmt::format("; {}: of its half axes {}", other.name, other.rule);
  return text;
}

}  // namespace

const Section& particles_section() {
  using S = ParticleKeys;
  static const std::vector<std::string> filled = {"lattice", "random"}, boxed = {"lattice", "random", "rate"},
                                        feed = {"rate"}, shaped = shapes_but_spheres();
  static const std::string meaning =
      "sphere; ellipsoid; superellipsoid: |x/a|^(2/e2) + |y/b|^(2/e2) to the power e2/e1, plus |z/c|^(2/e1), is 1; "
      "cylinder: the same with its axis along z and rounded edges (exponents 0.25 and 1); box: with rounded edges "
      "(0.25 "
      "and 0.25)" +
      meaning_of_others() + ". Others than spheres do not go with a rotating frame";
  static const Section section = {
      "particles",
      "[[particles]]",
      "A group of particles. Ids are counted through the groups in the order of the file, then as particles come in.",
      {key("name", &S::name, "name in messages and results").is_a(TextKind::name).defaults_to("group0, group1, ..."),
       key("material", &S::material, "name of a material").required(),
       key("shape", &S::shape, meaning.c_str()).one_of(shapes()).not_with("insert", {"checkpoint"}),
       key("half_axes", &S::half_axes,
           "half axes a, b, c of the shape, with a ratio of up to 20; where 'diameter' is given, it makes the size and "
           "they count by their ratios")
           .unit("m")
           .above(0)
           .required()
           .only_with("shape", shaped)
           .not_with("insert", {"checkpoint"}),
       key("exponents", &S::exponents,
           "e1 (along z) and e2 (in the plane of x and y): 1 is an ellipsoid, towards 0 edges get sharp (the powers "
           "2/e of the equation rise), above 1 the shape comes to points")
           .between(0.1, 1.9)
           .required()
           .only_with("shape", {"superellipsoid"})
           .not_with("insert", {"checkpoint"}),
       table("orientation", &S::orientation, orientation_section(), "type")
           .only_with("shape", shaped)
           .not_with("insert", {"checkpoint"}),
       table("diameter", &S::diameter, diameter_section(), "value")
           .required()
           .spared_unless("shape", {"sphere"})
           .not_with("insert", {"checkpoint"}),
       key("effect_gap", &S::effect_gap,
           "by how much the effect diameter, up to which linear cohesion acts, exceeds the body diameter")
           .unit("m")
           .at_least(0),
       key("motion", &S::motion,
           "free: moved by forces; fixed: at rest; prescribed: moved by formulas; the last two have infinite mass")
           .one_of({"free", "fixed", "prescribed"}),
       key("motion_velocity", &S::motion_velocity, "components of the velocity; x, y, z are the initial position")
           .unit("m/s")
           .required()
           .only_with("motion", {"prescribed"}),
       key("insert", &S::insert,
           "lattice: cubic; random: without overlap; file: columns of a CSV file; positions: listed; rate: one after "
           "the "
           "other while the run goes on, at random places of the region without overlap; checkpoint: taken over from "
           "another "
           "run")
           .one_of({"lattice", "random", "file", "positions", "rate", "checkpoint"}),
       key("region_min", &S::region_min,
           "lower corner of the box to fill, in which bodies lie as they are turned; with insert = 'rate' it may be "
           "flat: a face")
           .unit("m")
           .defaults_to("that of the domain")
           .only_with("insert", boxed),
       key("region_max", &S::region_max, "upper corner of the box to fill")
           .unit("m")
           .defaults_to("that of the domain")
           .only_with("insert", boxed),
       key("count", &S::count, "number of particles; 0: from spacing or solid_fraction")
           .at_most(1e10)
           .only_with("insert", filled),
       key("solid_fraction", &S::solid_fraction, "volume of the particles over that of the region; 0: from count")
           .between(0, 0.5)
           .only_with("insert", {"random"}),
       key("spacing", &S::spacing, "distance of neighbours on the lattice; 0: the region is filled evenly with count")
           .unit("m")
           .at_least(0)
           .only_with("insert", {"lattice"}),
       key("jitter", &S::jitter, "largest random shift off the lattice, as a fraction of the free gap")
           .between(0, 1)
           .only_with("insert", {"lattice"}),
       key("file", &S::file,
           "CSV file with the columns x, y, z and perhaps vx, vy, vz, wx, wy, wz, diameter, qw, qx, qy, qz, in SI "
           "units; relative to the case file")
           .is_a(TextKind::file)
           .required()
           .only_with("insert", {"file"}),
       key("checkpoint", &S::checkpoint,
           "checkpoint of another run, or its directory for the last one: places, velocities, spins and diameters of "
           "its "
           "particles; relative to the case file")
           .is_a(TextKind::file)
           .required()
           .only_with("insert", {"checkpoint"}),
       key("source_group", &S::source_group, "name of the only particle group of the other run that is taken over")
           .is_a(TextKind::name)
           .defaults_to("all particles that move freely")
           .only_with("insert", {"checkpoint"}),
       key("positions", &S::positions, "positions one by one").unit("m").required().only_with("insert", {"positions"}),
       table("velocity", &S::velocity, velocity_section(), "value").not_with("insert", {"checkpoint"}),
       key("angular_velocity", &S::angular_velocity, "initial angular velocity")
           .unit("rad/s")
           .not_with("insert", {"checkpoint"}),
       key("attempts", &S::attempts, "tries for each particle before random insertion gives up, or waits with 'rate'")
           .between(1, 1e9)
           .only_with("insert", {"random", "rate"}),
       key("mass_rate", &S::mass_rate, "mass that comes in per time; 0: number_rate is given")
           .unit("kg/s")
           .at_least(0)
           .only_with("insert", feed),
       key("number_rate", &S::number_rate, "particles that come in per time; 0: mass_rate is given")
           .unit("1/s")
           .at_least(0)
           .only_with("insert", feed),
       key("from", &S::from, "when particles begin to come in").unit("s").at_least(0).only_with("insert", feed),
       key("until", &S::until, "when no more become due; those that wait for room still come")
           .unit("s")
           .above(0)
           .or_word("end")
           .only_with("insert", feed),
       key("total_mass", &S::total_mass, "mass after which no more come in; 0: no limit")
           .unit("kg")
           .at_least(0)
           .only_with("insert", feed),
       key("total_count", &S::total_count, "number after which no more come in; 0: no limit").only_with("insert", feed),
       key("max_delay", &S::max_delay, "how long a particle may wait for room before the run stops")
           .unit("s")
           .at_least(0)
           .or_word("auto")
           .defaults_to("a tenth of the time that the insertion lasts")
           .only_with("insert", feed)
           .may_change_at_restart(),
       key("temperature", &S::temperature, "with [heat]: at the start, or as they come in")
           .unit("K")
           .at_least(0)
           .defaults_to("none")},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
