// The simulation: its state, and the step that advances it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scree/analysis/axis_order.h"
#include "scree/analysis/measure.h"
#include "scree/analysis/region.h"
#include "scree/app/build.h"
#include "scree/app/exchange.h"
#include "scree/app/fluid_columns.h"
#include "scree/app/frame_fields.h"
#include "scree/app/plane_watches.h"
#include "scree/app/prescribed.h"
#include "scree/app/state_share.h"
#include "scree/app/sticking.h"
#include "scree/app/sweep_tally.h"
#include "scree/app/wall_motion.h"
#include "scree/base/stopwatch.h"
#include "scree/coupling/coupling.h"
#include "scree/input/case.h"
#include "scree/mpi/effort.h"
#include "scree/mpi/ranks.h"
#include "scree/output/archive.h"
#include "scree/output/frames.h"
#include "scree/particles/device/precision.h"
#include "scree/particles/hard/step.h"
#include "scree/particles/heat.h"
#include "scree/particles/sample.h"

namespace scree {

/// Time as a number of equal steps, so that it does not collect rounding.
struct Clock {
  std::int64_t step = 0;
  double dt = 0;  // [s]

  double now() const { return static_cast<double>(step) * dt; }
  void advance() { ++step; }
};

struct DeviceRun;
namespace opencl {
struct DeviceInfo;
}

/// What the root asks of the other ranks.
enum class Call : std::int64_t {
  step,
  sample,
  measure,
  row,
  frame,
  finite,
  hash,
  save,
  keep,
  save_kept,
  write,
  gather,
  planes,
  report,
  fluid_row,
  fluid_frame,
  fluid_hash,
  dismiss
};

/// What is in one of the regions.
struct RegionFacts {
  double solid_fraction = 0, coordination = 0;
  AxisOrder axes;
};

/// What a row of the series says of the particles of all ranks, besides what they hold.
struct RowFacts {
  Speeds speeds;
  std::vector<RegionFacts> regions;
  std::vector<double> tracks;  // rows of the particles that are followed
  std::vector<double> heat;    // heat_row()
};

/// What has been counted since the start.
struct Tally {
  std::int64_t contacts = 0;       // evaluations of acting contacts
  std::int64_t wall_contacts = 0;  // of these with walls
  std::int64_t impacts = 0;        // pairs that began to touch
  std::int64_t impact_speed = 0;   // sum of their approach speeds [speed_quantum]
};

/// With several ranks every one of them has a simulation of the same case, which holds its share of the particles. The
/// root conducts: whatever it is asked for, it calls upon the others, which follow().
class Simulation {
 public:
  /// Builds the initial state of a case. A run that goes on gives the archive that will be restored: what the case
  /// takes from another run's checkpoint is then not read again. Throws InputError if the case cannot be run.
  Simulation(const Case& c, Team team, const Archive* resumed = nullptr, const Ranks& ranks = {},
             const InsertionWatch& watch = {});
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Steps from now on are done on a device. Throws InputError if the case has something that is not there yet on
  /// devices, ResourceError if the device cannot be used.
  void use_device(const opencl::DeviceInfo& info, Precision precision = Precision::full);

  /// Of the device that does the steps; "cpu" without one.
  std::string device_name() const;

  /// "double", or "mixed" on a device that was told so.
  std::string precision_name() const;

  /// Advances by one time step. Throws PhysicsError when the physics has gone wrong.
  void step();

  /// The present state with all velocities at the time of the positions; of several ranks, this rank's part of it.
  const Sample& sample();

  /// The same of all ranks together, at the root: for what cannot be put together from parts.
  const Sample& whole_sample();

  /// All particles and contacts of the run; of several ranks, put together at the root.
  const ParticleSystem& whole();

  /// What the particles hold, and what the series says of them besides.
  Measured measured();
  RowFacts row_facts();

  /// Writes a frame of the present state, and one of its contacts if there is a writer for them.
  void write_frame(FrameWriter& frames, FrameWriter* contacts);

  /// Whether every number of the motion is one that sums and squares can bear.
  bool is_finite();

  /// SHA-256 over time, particles by id and contacts by key, as hexadecimal text.
  std::string state_hash();

  /// What has passed each plane of the case since the start.
  std::vector<PlaneCount> plane_counts();

  /// Everything that continuing to the last bit needs; of several ranks, this rank's part of it.
  Archive save();

  /// Remembers the present state, on every rank its part; save_kept() gives it as save() would have then.
  void keep();
  Archive save_kept();

  /// Writes what save() or save_kept() gave last, to which the caller may have added. Throws ResourceError.
  void write(const std::filesystem::path& path, const Archive& archive);

  /// Ranks other than the root: does as the root does until that dismisses them; returns what it gives them.
  std::int64_t follow();

  /// The root: lets the others go, with a number for them.
  void dismiss(std::int64_t parting);

  /// Continues from what save() gave. Throws InputError if it does not fit the case.
  void restore(const Archive& archive);

  const Case& input() const { return case_; }
  const Clock& clock() const { return clock_; }
  /// This rank's particles.
  const ParticleSystem& system() const { return system_; }
  /// Particles on all ranks.
  std::int64_t particles() const;
  const Ranks& ranks() const { return ranks_; }
  /// The root: how the ranks have shared the steps, by name (docs/files.md); empty for one process.
  std::vector<std::pair<std::string, double>> sharing() const;
  const Fields& fields() const { return fields_; }
  const Exchange& exchange() const { return exchange_; }
  /// The impact that the stickiness number is about; empty without linear cohesion.
  const std::optional<CohesiveImpact>& typical_impact() const { return typical_impact_; }
  const Tally& tally() const { return tally_; }
  /// Of the steps that this object has made.
  const SweepTally& sweeps() const { return sweeps_; }
  const SweepFindings& findings() const { return findings_; }
  const StageSeconds& stages() const { return stages_; }
  StageSeconds& stages() { return stages_; }
  /// The fluid that the particles are in; null without one that is solved for.
  const FluidCoupling* coupling() const { return coupling_.get(); }
  /// What a row of the series says of the fluid (app/coupling_columns.h); counts anew from here.
  std::vector<double> fluid_row();
  /// What a frame shows of the fluid, in single precision or in double.
  std::vector<FrameColumn> fluid_frame(bool single) const;
  /// The hash of the fluid; for equal numbers of ranks only.
  std::string fluid_hash() const;
  const char* instruction_set() const { return lists_.kernels.name; }
  int threads() const { return team_.threads; }

 private:
  void call(Call what) const;
  void advance();
  void advance_on_device();
  void send_to_device();
  void move_walls_on_device();
  void settle_device();
  void take_passings();
  std::vector<sc_prescribed> prescribed_on_device();
  void retrieve();
  bool is_on_device() const;
  void help(Call what);
  void gather();
  void take_own_sample();
  bool turn_by_fluid_around(Particles& particles, double dt) const;
  void sample_whole();
  Measured measure_share();
  RowFacts look_at_share();
  void frame_share(FrameWriter* frames, FrameWriter* contacts);
  FrameData frame_data_share();
  bool is_share_finite();
  StateShare share();
  Archive save_share();
  std::string hash_share();
  std::vector<Bytes> report() const;
  void settle();
  void settle(const Archive& archive);
  void restore_contacts(const Archive& archive);
  void cut_blocks(const Ranks& who_counts);
  void together(const std::function<void()>& look) const;
  void move_walls(double time);
  bool exchange_particles();
  void exchange_on_device();
  bool exchange_within(ParticleSystem& system, ContactLists& lists, const Buffer<sc_field>& fields);
  void move_prescribed_bodies();
  void look_at_planes();
  void refresh_neighbours();
  void conduct_heat();
  void step_fluid(Particles& particles);
  void step_fluid_on_device();
  Fields fields_on_device() const;
  bool fluid_is_due() const { return coupling_ && clock_.step % coupling_->settings.subcycles == 0; }
  void evaluate_own_fields(double time);
  void evaluate_fields(const ParticleSystem& system, double time, Buffer<sc_field>& field);
  void advance_particles();
  void collide_particles();
  void take(SweepFindings findings);
  void guard();

  /// Whether a pass needs to know what acts at each particle.
  bool fields_matter() const { return act_locally(fields_) || !prescribed_.empty(); }

  /// Whether velocities are kept half a step behind the positions.
  bool staggered() const;
  void note_ways(double particles);
  double way_of_walls();
  sc_move move_now() const;
  sc_contact_time contact_time_now() const;

  Case case_;
  Team team_;
  Ranks ranks_;
  std::int64_t count_ = 0;  // particles on all ranks, where there are several
  Effort effort_;           // of this rank, in all steps
  Fields fields_;
  ParticleSystem system_;
  std::vector<PrescribedGroup> prescribed_;
  std::vector<WallMotion> motions_;
  Exchange exchange_;
  PlaneWatches planes_;
  std::vector<Region> regions_;
  ContactLists lists_;
  Buffer<sc_field> field_;
  Clock clock_;
  std::optional<CohesiveImpact> typical_impact_;
  Tally tally_;
  SweepTally sweeps_;
  SweepFindings findings_, own_findings_;  // of all ranks, of this one
  StageSeconds stages_;
  Sample sample_, whole_sample_;
  std::int64_t sampled_step_ = -1, whole_sampled_step_ = -1;
  std::optional<StateShare> kept_;
  Archive saved_;  // ranks other than the root: waits to be written
  std::unique_ptr<DeviceRun> device_;
  std::int64_t retrieved_step_ = -1;
  ParticleSystem whole_;  // at the root of several ranks: the run as a whole
  std::int64_t whole_step_ = -1;
  HardStep hard_;
  std::unique_ptr<FluidCoupling> coupling_;
  FluidTally fluid_tally_;
  std::optional<HeatProperties> heat_;
  HeatBooks heat_books_;
};

}  // namespace scree
