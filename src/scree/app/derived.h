// Numbers that follow from a case before it is run: time step, depth of contacts, Reynolds, Stokes and stickiness
// numbers, memory. `scree check` prints them with a verdict each.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scree/app/body_kinds.h"
#include "scree/app/fluid_report.h"
#include "scree/app/periodic_jumps.h"
#include "scree/app/sticking.h"
#include "scree/data/materials.h"
#include "scree/data/walls.h"
#include "scree/input/case.h"
#include "scree/input/mesh_report.h"

namespace scree {

/// Hard collisions: a longer way in a step than this share of the smallest diameter is worth a warning.
inline constexpr double far_travel = 0.1;
/// The same for tips of bodies, over the least thickness; at half of it a run stops.
inline constexpr double far_tip_travel = 0.25;

/// Fewer time steps per contact than this are refused, or worth a warning.
inline constexpr double fewest_steps_per_contact = 10, few_steps_per_contact = 15;

/// Steps and contacts.
struct DerivedStep {
  bool automatic = false;
  double time_step = std::numeric_limits<double>::quiet_NaN();    // [s]; NaN if "auto" has nothing to go by
  double contact_time = std::numeric_limits<double>::infinity();  // shortest [s]; infinite without contacts
  double steps_per_contact = std::numeric_limits<double>::infinity();
  std::string shortest;                                          // the encounter with the shortest contact
  double damped_step = std::numeric_limits<double>::infinity();  // longest that brings a damped packing to rest [s]
  std::string damped;                                            // the encounter that asks for it
  double overlap = 0;                                            // deepest at top speed, over the smaller radius
  double travel = 0;      // hard: way at top speed in a step, over the smallest diameter
  double tip_travel = 0;  // hard: way of the tip of a body, over its thickness; 0 among spheres
  std::string deepest;
  double rayleigh_time = std::numeric_limits<double>::infinity();  // shortest [s]; infinite without elastic moduli
  double steps = 0;                                                // of the run
  double top_speed = 0;                                            // [m/s]
  std::string top_speed_source;
  std::string fastest_wall;  // its name, if walls that move are part of the top speed
};

/// Particles and fluid. Without drag the times are infinite and the numbers zero.
struct DerivedFluid {
  double flow_speed = 0;                                             // mean [m/s]
  double relaxation_time = std::numeric_limits<double>::infinity();  // Stokes, of the quickest particle [s]
  double reynolds = 0;                                               // of the largest particle at the fastest speed
  std::optional<double> stokes;                                      // of a particle of the mean volume
  double stokes_length = 0;                                          // length of the flow that it was taken with [m]
};

/// How much of the weight of a material the fluid carries, or would carry.
struct DerivedLift {
  std::string material;
  double share = 0;  // density of the fluid over that of the material
};

/// Cohesion of a typical encounter; empty where the law has none.
struct DerivedCohesion {
  std::string what;                              // the encounter
  double mass = 0, speed = 0;                    // reduced mass [kg] and speed [m/s] of the stickiness number
  double restitution = 1;                        // of the two without cohesion
  std::optional<double> stickiness;              // the report's number
  std::optional<double> sticking_speed;          // exact for the law, dashpots included [m/s]
  std::optional<double> elastic_sticking_speed;  // JKR without dashpots, of Thornton and Ning [m/s]
  std::optional<double> pull_off;                // JKR [N]
};

/// What the run costs.
struct DerivedCost {
  std::uint64_t particles = 0;
  double solid_fraction = 0;  // of the domain
  double bytes_per_particle = 0, bytes_per_pair = 0;
  double pairs_per_particle = 0;                                // estimate of the candidates listed
  double memory = 0;                                            // [bytes]
  std::uint64_t frames = 0, rows = 0, checkpoints = 0;          // of the series, the tracks included
  double frame_bytes = 0, row_bytes = 0, checkpoint_bytes = 0;  // of one; frames uncompressed
  double contact_bytes = 0;                                     // of the contacts beside one frame, if they are written
  std::uint64_t average_files = 0;                              // of all [[analysis.averages]]
  double average_bytes = 0;                                     // of all these files together
  std::uint64_t wall_files = 0;                                 // of the walls in the frames
  double wall_bytes = 0;                                        // of all these files together, uncompressed
  FluidCost fluid;                                              // that is solved for
  double disk = 0;  // all of it, and three checkpoints: a third is written before the oldest goes [bytes]
};

struct Derived {
  std::vector<BodyKind> kinds;
  Walls walls;
  std::vector<MeshReport> meshes;  // of walls that are surfaces of triangles
  DerivedStep step;
  DerivedFluid fluid;
  std::vector<DerivedLift> lift;  // of every material of free particles; empty without weight or fluid
  std::vector<PeriodicJump> jumps;
  std::optional<DerivedCohesion> cohesion;
  DerivedCost cost;
};

/// All numbers of a case. Throws InputError if its materials or particles cannot be made.
Derived derive(const Case& c);

/// Steps and contacts. The time step of the run is simulation.time_step, or the shortest contact time over
/// simulation.steps_per_contact, over every pair of materials and sizes that the case can create, walls included, and
/// no longer than strong dashpots bear (longest_damped_step). Hertz counts with the top speed; if nothing is known to
/// move, the step is a fifth of the Rayleigh time.
DerivedStep derive_step(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds,
                        const Walls& walls);

/// The same for a run. Throws InputError when a contact would take fewer than ten steps, when the run would take more
/// than `most_steps` (input/checks.h), or when "auto" has no contact to go by.
DerivedStep sound_step(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds,
                       const Walls& walls);

/// The impact that the stickiness number of the case is about: two particles of mean volume of the most numerous kind
/// (see typical_encounter). Empty without linear cohesion.
std::optional<CohesiveImpact> typical_impact(const Case& c, const Materials& materials,
                                             const std::vector<BodyKind>& kinds);

/// Where the results of a run would go, and the room that there is [bytes].
struct OutputPlace {
  std::string directory;
  double free = 0;
};

/// Looks at the file system that would hold the directory; nothing if it cannot be asked.
std::optional<OutputPlace> output_place(const std::string& directory);

/// Adds to `cost` what a run of so many steps writes.
void add_output_cost(const Case& c, const Walls& walls, double steps, DerivedCost& cost);

/// The text of `scree check`: every number with a verdict (ok, warning, refused) and a remedy where it is not ok.
/// `refusal` is why the initial state cannot be built, if it cannot; `place` is where results would go, if known.
std::string check_report(const Case& c, const Derived& derived, const std::string& refusal = {},
                         const std::optional<OutputPlace>& place = {});

/// The warnings of that text alone, for the start of a run: "2 warnings (scree check):", then a line and a remedy for
/// each; empty if there are none.
std::string check_warnings(const Case& c, const Derived& derived, const std::optional<OutputPlace>& place = {});

}  // namespace scree
