// The simulation: its state, and the step that advances it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scree/app/build.h"
#include "scree/app/exchange.h"
#include "scree/app/prescribed.h"
#include "scree/app/sticking.h"
#include "scree/app/wall_motion.h"
#include "scree/base/stopwatch.h"
#include "scree/input/case.h"
#include "scree/mpi/ranks.h"
#include "scree/output/archive.h"
#include "scree/particles/hard/step.h"
#include "scree/particles/sample.h"

namespace scree {

/// Time as a number of equal steps, so that it does not collect rounding.
struct Clock {
  std::int64_t step = 0;
  double dt = 0;  // [s]

  double now() const { return static_cast<double>(step) * dt; }
  void advance() { ++step; }
};

/// What has been counted since the start.
struct Tally {
  std::int64_t contacts = 0;       // evaluations of acting contacts
  std::int64_t wall_contacts = 0;  // of these with walls
  std::int64_t impacts = 0;        // pairs that began to touch
  std::int64_t impact_speed = 0;   // sum of their approach speeds [speed_quantum]
};

class Simulation {
 public:
  /// Builds the initial state of a case. A run that goes on gives the archive that will be restored: what the case
  /// takes from another run's checkpoint is then not read again. Throws InputError if the case cannot be run.
  Simulation(const Case& c, Team team, const Archive* resumed = nullptr);

  /// Advances by one time step. Throws PhysicsError when the physics has gone wrong.
  void step();

  /// The present state with all velocities at the time of the positions.
  const Sample& sample();

  /// SHA-256 over time, particles by id and contacts by key, as hexadecimal text.
  std::string state_hash() const;

  /// Everything that continuing to the last bit needs.
  Archive save() const;

  /// Continues from what save() gave. Throws InputError if it does not fit the case.
  void restore(const Archive& archive);

  const Case& input() const { return case_; }
  const Clock& clock() const { return clock_; }
  const ParticleSystem& system() const { return system_; }
  const Fields& fields() const { return fields_; }
  const Exchange& exchange() const { return exchange_; }
  /// The impact that the stickiness number is about; empty without linear cohesion.
  const std::optional<CohesiveImpact>& typical_impact() const { return typical_impact_; }
  const Tally& tally() const { return tally_; }
  const SweepFindings& findings() const { return findings_; }
  const StageSeconds& stages() const { return stages_; }
  StageSeconds& stages() { return stages_; }
  const char* instruction_set() const { return lists_.kernels.name; }
  int threads() const { return team_.threads; }

 private:
  void move_walls(double time);
  void exchange_particles();
  void move_prescribed_bodies();
  void refresh_neighbours();
  void evaluate_fields(double time);
  void advance_particles();
  void collide_particles();
  void take(SweepFindings findings);
  void guard() const;

  /// Whether a pass needs to know what acts at each particle.
  bool fields_matter() const { return act_locally(fields_) || !prescribed_.empty(); }

  /// Whether velocities are kept half a step behind the positions.
  bool staggered() const;
  void note_ways(double particles);
  sc_move move_now() const;
  sc_contact_time contact_time_now() const;

  Case case_;
  Team team_;
  Ranks ranks_;
  Fields fields_;
  ParticleSystem system_;
  std::vector<PrescribedGroup> prescribed_;
  std::vector<WallMotion> motions_;
  Exchange exchange_;
  ContactLists lists_;
  Buffer<sc_field> field_;
  Clock clock_;
  std::optional<CohesiveImpact> typical_impact_;
  Tally tally_;
  SweepFindings findings_;
  StageSeconds stages_;
  Sample sample_;
  std::int64_t sampled_step_ = -1;
  HardStep hard_;
};

}  // namespace scree
