// A validated case: values only, all in SI. input/ makes it from TOML, app/ builds a simulation from it.
// Each field's meaning, unit, limits and default stand once, in the key table (input/keys_*.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scree/input/fluid_keys.h"
#include "scree/physics/contact/contact.h"

namespace scree {

using Vec3 = std::array<double, 3>;
using Expression3 = std::array<std::string, 3>;  // formulas of x, y, z, t for the three components

struct SimulationKeys {
  std::string title;
  double end = 0;                       // [s]
  std::optional<double> time_step;      // [s]; empty: "auto"
  double steps_per_contact = 25;        // of "auto"
  std::optional<double> top_speed;      // the fastest impact that "auto" and the check count with [m/s]
  std::string integrator = "leapfrog";  // leapfrog, explicit, implicit
  std::uint64_t seed = 1;
  double max_overlap = 0.2;           // of the smaller radius; beyond it the run stops
  double skin = 0;                    // of the Verlet list [m]; 0: chosen by the program
  std::uint64_t exchange_every = 50;  // steps between two looks for particles that come or go
};

struct DomainKeys {
  Vec3 min{}, max{};
  std::array<bool, 3> periodic{};
};

struct GravityKeys {
  std::string type = "none";    // none, uniform, central, expression, rotating
  Vec3 acceleration{};          // uniform and rotating [m/s2]
  Vec3 center{};                // central: the attracting point; rotating: a point on the axis [m]
  double strength = 0;          // central: G M [m3/s2]
  Expression3 expression;       // of x, y, z, t [m/s2]
  Vec3 angular_velocity{};      // of the rotating frame [rad/s]
  Vec3 angular_acceleration{};  // of the rotating frame [rad/s2]
};

/// What a fluid does to particles besides drag.
struct FluidForceKeys {
  std::string shape_lift = "auto", pitching_torque = "auto", viscous_torque = "auto";  // auto, on, off
  bool saffman = false, magnus = false, added_mass = false;

  bool operator==(const FluidForceKeys&) const = default;
};

struct FlowKeys : FluidForceKeys {
  std::string type = "none";    // none, still, uniform, taylor_green, shear, expression
  std::string drag = "none";    // none, stokes, schiller_naumann, and laws by shape
  bool pressure_force = false;  // of the flow's acceleration
  double density = 0;           // [kg/m3]
  double viscosity = 0;         // dynamic [Pa s]
  bool buoyancy = false;        // the fluid takes its part of the weight in uniform gravity
  Vec3 velocity{};              // uniform [m/s]
  double amplitude = 0;         // Taylor-Green A [m/s]
  double wavenumber = 0;        // Taylor-Green a [1/m]
  double shear_rate = 0;        // u_x = rate * (y - shear_origin) [1/s]
  double shear_origin = 0;      // [m]
  Expression3 expression;       // of x, y, z, t [m/s]
};

struct MaterialKeys {
  std::string name;
  double density = 0;                    // [kg/m3]
  std::optional<double> young, poisson;  // Hertz, Mindlin, JKR [Pa], [-]
  std::optional<double> stiffness;       // linear normal spring [N/m]
  double restitution = 1;
  double tangential_restitution = 0;       // of hard collisions that stick
  double friction = 0;                     // static and sliding
  std::optional<double> friction_sliding;  // default: as friction
  double rolling_friction = 0, twisting_friction = 0;
  double cohesion_stiffness = 0;  // [N/m]
  double adhesion = 0;            // work of adhesion against itself [J/m2]
  // [J/(kg K)], [W/(m K)]
  std::optional<double> heat_capacity, conductivity;
};

/// What a pair of materials has of its own; what is empty is mixed from the two materials.
struct PairKeys {
  std::array<std::string, 2> materials;
  std::optional<double> stiffness, young, restitution, tangential_restitution, friction, friction_sliding,
      rolling_friction, twisting_friction, cohesion_stiffness, adhesion;
};

struct ContactKeys {
  std::string collision = "soft";       // soft, hard
  std::string detection = "certified";  // certified, vertices
  std::uint64_t vertices = 20;          // vertices: N of N x N on each surface
  std::string spacing = "linear";       // vertices: linear, exponential, radial, normal, mixed
  sc_laws laws{SC_NORMAL_LINEAR, SC_TANGENTIAL_HISTORY, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE};
  double tangential_stiffness_ratio = 2.0 / 7.0;  // k_t / k_n of the linear laws
  std::optional<double> tangential_damping;       // damping ratio; default: as the normal one
  double rolling_stiffness_ratio = 1.0;           // k_r / (k_t R^2)
  double rolling_damping = 0.3;
  double twisting_stiffness_ratio = 1.0;
  double twisting_damping = 0.3;
};

/// How hard collisions are solved.
struct HardKeys {
  std::string order = "coloured";  // coloured, sequential
  std::uint64_t sweeps = 100;
  double residual = 1e-4;           // of the fastest approach
  std::optional<double> threshold;  // approaches up to it are no collisions [m/s]; empty: by gravity
  double slop = 1e-3;               // overlap that stays, over the smaller radius
  double travel = 0.02;             // of the smallest diameter at top speed in a step, when the time step is "auto"
};

/// A distribution of diameters; every one has a minimum and a maximum.
struct SizeKeys {
  std::string distribution = "single";  // single, classes, uniform, normal, lognormal
  double value = 0;                     // single [m]
  std::vector<double> diameters;        // classes [m]
  std::vector<double> fractions;        // classes, by number; they add up to 1
  double mean = 0, deviation = 0;       // normal, lognormal: of the diameter itself [m]
  double min = 0, max = 0;              // uniform, normal, lognormal [m]
};

struct VelocityKeys {
  std::string type = "given";  // given, random, fluid
  Vec3 value{};                // given: the velocity; random: its mean [m/s]
  double deviation = 0;        // random: standard deviation of each component [m/s]
};

/// How particles lie at the start.
struct OrientationKeys {
  std::string type = "given";      // given, random, aligned
  std::vector<double> quaternion;  // w x y z, body to world; empty: by axis and angle
  Vec3 axis{0, 0, 1};
  double angle = 0;   // [rad]
  double spread = 0;  // aligned: standard deviation of the turn about each axis of the world [rad]
};

struct ParticleKeys {
  std::string name;
  std::string material;
  std::string shape = "sphere";   // sphere, ellipsoid, superellipsoid, cylinder, box
  Vec3 half_axes{};               // of all but spheres; with a diameter, their ratios only [m]
  std::vector<double> exponents;  // e1 (along z), e2 (in the plane of x and y)
  OrientationKeys orientation;
  SizeKeys diameter;                // of the sphere of equal volume
  double effect_gap = 0;            // d_e - d_b: how much the effect diameter exceeds the body diameter [m]
  std::string motion = "free";      // free, fixed, prescribed: the last two have infinite mass
  Expression3 motion_velocity;      // prescribed: formulas of t (and of the initial x, y, z) [m/s]
  std::string insert = "lattice";   // lattice, random, file, positions, rate, checkpoint
  Vec3 region_min{}, region_max{};  // lattice, random, rate [m]; default: the domain
  std::uint64_t count = 0;          // lattice, random: how many
  double solid_fraction = 0;        // random: instead of count
  double spacing = 0;               // lattice: distance of neighbours [m]; 0: fill the region evenly with `count`
  double jitter = 0;                // lattice: largest shift, as a fraction of the free gap
  std::string file;                 // CSV: columns x, y, z [, vx, vy, vz, wx, wy, wz, diameter]; path made absolute
  std::string checkpoint;           // of another run, or its directory; path made absolute
  std::string source_group;         // checkpoint: the group that is taken over; empty: all that are free
  std::vector<Vec3> positions;      // positions: given one by one
  VelocityKeys velocity;
  std::optional<double> temperature;
  Vec3 angular_velocity{};          // [rad/s]
  std::uint64_t attempts = 1000;    // random: tries per particle before giving up; rate: before waiting
  double mass_rate = 0;             // rate [kg/s]; 0: by number
  double number_rate = 0;           // rate [1/s]; 0: by mass
  double from = 0;                  // rate: when it begins [s]
  std::optional<double> until;      // rate: when it ends [s]; empty: never
  double total_mass = 0;            // rate: after which it ends [kg]; 0: never
  std::uint64_t total_count = 0;    // rate: likewise
  std::optional<double> max_delay;  // rate: how late it may be [s]; empty: a tenth of the time that it lasts
};

/// Where particles leave: an open face of the domain, or a region that takes what comes into it.
struct OutletKeys {
  std::string name;
  std::string type = "face";  // face, region
  std::string face;           // x_min ... z_max
  Vec3 min{}, max{};          // region: corners [m]
};

/// How a wall moves.
struct MotionKeys {
  std::string type = "none";  // none, velocity, rotation, oscillation, expression, surface
  Vec3 velocity{};            // velocity, surface [m/s]
  Vec3 point{};               // on the axis [m]
  Vec3 axis{0, 0, 1};
  double angular_velocity = 0;  // [rad/s]
  Vec3 amplitude{};             // [m]
  double frequency = 0;         // [Hz]
  double phase = 0;             // [rad]
  Expression3 displacement{"0", "0", "0"};
  std::string angle = "0";  // formula of t [rad]
  double start = 0;         // [s]
  std::optional<double> stop;
};

struct WallKeys {
  std::string name;
  std::string type;  // plane, rectangle, plate, box, cylinder, cone, triangles, mesh
  std::string material;
  Vec3 point{}, normal{};             // plane: particles are on the side that the normal points to
  Vec3 min{}, max{};                  // rectangle (flat in one axis), box
  std::string side = "inside";        // box: particles are inside or outside
  Vec3 corner{}, edge_a{}, edge_b{};  // plate
  Vec3 start{}, end{}, axis{};        // cylinder, cone
  double radius = 0, start_radius = 0, end_radius = 0;
  bool closed = false;
  std::vector<Vec3> vertices;  // triangles
  std::string file;            // mesh; path made absolute
  double scale = 1;            // of the mesh [m]
  Vec3 offset{};               // of the mesh [m]
  double from = 0;             // [s]
  std::optional<double> until, temperature;
  MotionKeys motion;
};

struct OutputKeys {
  double frames = 0;                          // interval [s]; 0: only first and last
  double series = 0;                          // interval [s]; 0: 200 rows over the run
  double checkpoints = 0;                     // interval [s]; 0: only at the end
  std::vector<std::uint64_t> tracks;          // ids of particles whose motion is written at every series row
  std::vector<std::string> fields;            // of the particles in frames; empty: the usual ones
  std::string precision = "double";           // of the floating-point fields in frames: double, single
  std::string compression = "whole_numbers";  // of frames: whole_numbers, none, fast, small
  bool contacts = false;                      // a file of contacts with every frame
};

struct LedgerKeys {
  std::uint64_t every = 0;        // steps; 0: at every series row
  double energy_tolerance = 0;    // closure error as a fraction of the turnover at which the run stops; 0: never
  std::vector<std::string> omit;  // channels left out of the books on purpose, to see that the check bites
};

/// A plane, or a part of it, at which the particles that pass are counted.
struct PlaneKeys {
  std::string name;
  Vec3 point{}, normal{};        // any length of the normal [m]
  std::optional<double> radius;  // of a disc about the point; empty: no limit [m]
  Vec3 min{}, max{};             // default: the domain [m]
};

/// Averages over space and time on a regular grid.
struct AverageKeys {
  std::string name;
  Vec3 min{}, max{};                 // default: the domain [m]
  std::vector<std::uint64_t> cells;  // along x, y, z
  double from = 0;                   // of the first sample [s]
  double every = 0;                  // between samples [s]
  double window = 0;                 // over which samples are averaged; 0: to the end [s]
};

/// The free surface of a bed.
struct SurfaceKeys {
  std::string name;
  Vec3 min{}, max{};                 // default: the domain [m]
  std::vector<std::uint64_t> cells;  // along x, y, z
  std::string up = "z";              // x, y, z, -x, -y, -z
  double solid_fraction = 0.3;       // of a cell that belongs to the bed
};

/// A box in which the packing is measured.
struct RegionKeys {
  std::string name;
  Vec3 min{}, max{};  // default: the domain [m]
};

struct AnalysisKeys {
  bool agglomerates = false;
  double stop_agglomerated = 0;  // ends the run when this fraction of the particles is in agglomerates; 0: never
  std::vector<PlaneKeys> planes;
  std::vector<AverageKeys> averages;
  std::vector<SurfaceKeys> surfaces;
  std::vector<RegionKeys> regions;
};

/// A run of a verification case with some keys changed.
struct VariantKeys {
  std::string name;
  std::vector<std::string> set;     // overrides, each "key.path=value" as on the command line
  double parameter = 0;             // what the variants vary, for orders of convergence (a time step, say)
  bool wrong = false;               // a term is deliberately wrong: at least one expectation must fail
  std::vector<std::string> define;  // "name = formula": numbers of this variant, before those of the case
};

/// One number that a verification case must reproduce.
struct ExpectKeys {
  std::string what;      // in words
  std::string value;     // formula of the results (docs/verification.md)
  std::string equals;    // number or formula; empty if only bounds are given
  double tolerance = 0;  // absolute
  double relative = 0;   // of `equals`
  std::optional<double> at_least, at_most;
  std::vector<std::string> variants;  // names; empty: every variant that is not wrong
  std::string source;                 // author, year, equation; empty: that of the case
};

/// A picture of a verification case over its reference.
struct VerifyPlotKeys {
  std::string title;
  std::string x = "time", y, reference;  // formulas; reference may be empty
  std::string x_label, y_label;
  std::vector<std::string> variants;  // names; empty: every variant that is not wrong
  bool per_variant = false;           // one point per variant instead of one curve per variant
  bool logarithmic = false;           // both axes
};

struct VerifyKeys {
  std::string title, source;
  std::vector<VariantKeys> variants;
  std::vector<ExpectKeys> expect;
  std::vector<std::string> define;  // "name = formula": names that the formulas may use, in order
  std::vector<VerifyPlotKeys> plots;
};

/// How particles and a fluid that is solved for act on each other.
struct CouplingKeys : FluidForceKeys {
  std::string drag = "gidaspow_blend";  // the laws of app/models.h
  std::uint64_t subcycles = 0;          // 0: from both time steps
  std::optional<double> diffusion;      // width [m]; empty: three diameters where cells are under two
  double least_void_fraction = 0.2;
  bool pressure_force = true, viscous_stress = false;

  bool operator==(const CouplingKeys&) const = default;
};

/// Heat of the particles.
struct HeatKeys {
  std::string type = "none";      // none, solved
  std::string exchange = "gunn";  // with a fluid that carries heat: none, ranz_marshall, gunn
  bool conduction = true;         // through contacts
  double contact_radius = 1;      // of the conducting circle over Hertz'
  std::uint64_t every = 1;        // steps between two looks at the contacts
};

struct CaseText;  // input/located.h

struct Case {
  std::string path;                      // of the case file
  std::shared_ptr<const CaseText> text;  // and where its keys stand, for messages; empty if made without a file
  SimulationKeys simulation;
  DomainKeys domain;
  GravityKeys gravity;
  FlowKeys flow;
  FluidKeys fluid;
  CouplingKeys coupling;
  HeatKeys heat;
  ContactKeys contact;
  HardKeys hard;
  std::vector<MaterialKeys> materials;
  std::vector<PairKeys> pairs;
  std::vector<ParticleKeys> particles;
  std::vector<WallKeys> walls;
  std::vector<OutletKeys> outlets;
  OutputKeys output;
  LedgerKeys ledger;
  AnalysisKeys analysis;
  VerifyKeys verify;  // used by `scree verify` only
};

/// Whether collisions are impulses.
inline bool is_hard(const Case& c) { return c.contact.collision == "hard"; }

/// Whether the flow of a fluid is solved for.
inline bool solves_flow(const Case& c) { return c.fluid.type != "none"; }

/// Whether particles are in a flow that is solved for.
inline bool couples(const Case& c) { return solves_flow(c) && !c.particles.empty(); }

/// Whether particles have a temperature.
inline bool warms(const Case& c) { return c.heat.type != "none" && !c.particles.empty(); }

/// Whether they give heat to the fluid and take it.
inline bool exchanges_heat(const Case& c) {
  return warms(c) && couples(c) && c.fluid.heat.type != "none" && c.heat.exchange != "none";
}

/// Whether contacts of shapes are found by vertices.
inline bool by_vertices(const Case& c) { return c.contact.detection == "vertices"; }

/// Whether contacts remember what rolling laws need. Hard collisions keep an impulse there.
inline bool remembers_rolling(const Case& c) {
  const sc_laws& laws = c.contact.laws;
  return is_hard(c) || laws.rolling != SC_ROLLING_NONE || laws.twisting != SC_TWISTING_NONE;
}

/// Whether the case has groups of particles that are no spheres. Those of a checkpoint are not known here.
inline bool has_shapes(const Case& c) {
  return std::any_of(c.particles.begin(), c.particles.end(),
                     [](const ParticleKeys& p) { return p.shape != "sphere" && p.insert != "checkpoint"; });
}

}  // namespace scree
