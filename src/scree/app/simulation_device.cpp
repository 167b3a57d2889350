// A simulation on a device: particles go there before the first step and come back when somebody looks at them.
#include "scree/app/device_run.h"
#include "scree/app/guard.h"
#include "scree/app/simulation.h"
#include "scree/base/error.h"
#include "scree/coupling/columns.h"

namespace scree {
namespace {

std::vector<sc_body_group> groups_of(const std::vector<PrescribedGroup>& prescribed) {
  std::vector<sc_body_group> out;
  sc_count number = 0;
  for (const PrescribedGroup& group : prescribed) {
    out.push_back({group.first, static_cast<sc_count>(group.start.size()), number});
    number += out.back().count;
  }
  return out;
}

}  // namespace

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::use_device(const opencl::DeviceInfo& info, Precision precision) {
  refuse_on_device(case_);
  if (precision == Precision::mixed) refuse_in_mixed(case_);
  device_ = std::make_unique<DeviceRun>(info, precision);
}

std::string Simulation::device_name() const { return device_ ? device_->device.info().name : "cpu"; }

std::string Simulation::precision_name() const {
  return device_ && device_->precision == Precision::mixed ? "mixed" : "double";
}

bool Simulation::is_on_device() const { return device_ && device_->particles; }

void Simulation::advance_on_device() {
  auto& particles = device_->particles;
  move_walls_on_device();
  if (particles)
    exchange_on_device();
  else
    exchange_particles();
  step_fluid_on_device();
  if (!particles) send_to_device();
  particles->step(
      {move_now(), contact_time_now(), {system_.walls.poses, way_of_walls()}, prescribed_on_device(), clock_.now()});
  clock_.advance();
  if (particles->is_full()) settle_device();
}

void Simulation::send_to_device() {
  if (!ranks_.alone()) {
    refresh_neighbours();
    update_ghosts(system_, lists_);
  }
  if (is_on_device()) take_passings();
  device_->particles.emplace(device_->device, device_->precision, system_, lists_, fields_on_device(),
                             groups_of(prescribed_), case_.simulation.max_overlap);
  device_->particles->watch(planes_.planes());
}

/// Adds to the planes' counts what has passed on the device.
void Simulation::take_passings() {
  settle_device();
  planes_.add(device_->particles->take_counts());
}

/// Those who may come or go, with their neighbours, are dealt with by the host.
void Simulation::exchange_on_device() {
  if (!exchange_.due(clock_.step)) return;
  settle_device();
  if (!ranks_.alone()) {
    retrieve();
    if (exchange_particles()) send_to_device();
    return;
  }
  const std::vector<sc_region> regions = exchange_.regions(system_.domain, clock_.now());
  if (regions.empty()) return;
  PartOfDevice part = device_->particles->part_in(regions, system_);
  ContactLists lists = prepare_lists(part.system, case_.simulation.skin);
  refresh_lists(part.system, lists, team_);
  Buffer<sc_field> field;
  evaluate_fields(part.system, clock_.now(), field);
  if (!exchange_within(part.system, lists, field)) return;
  device_->particles->put_back(part, part.system);
  retrieved_step_ = sampled_step_ = -1;
}

/// The fluid is the host's. It takes what it wants to know of the particles, and they get what it has said to them.
void Simulation::step_fluid_on_device() {
  if (!is_on_device()) return step_fluid(system_.particles);
  if (!fluid_is_due()) return;
  settle_device();
  DeviceParticles& particles = *device_->particles;
  Particles met = system_.particles.none_alike();
  particles.read_columns(read_by_fluid, met);
  step_fluid(met);
  particles.write_columns(written_by_fluid, met);
}

/// What acts on particles on the device. A fluid that is solved for has said to each what it will meet, but for what
/// turns it, which follows from the flow there and its own rotation.
Fields Simulation::fields_on_device() const {
  Fields out = fields_;
  if (!coupling_) return out;
  out.forces = coupling_->settings.forces;
  out.density = coupling_->fluid.settings.density;
  out.viscosity = coupling_->fluid.settings.viscosity;
  return out;
}

/// Puts the walls where they are in the step that is given next. If their motion fails, the steps before come first.
void Simulation::move_walls_on_device() {
  try {
    move_walls(clock_.now());
  } catch (const PhysicsError&) {
    if (is_on_device()) settle_device();
    throw;
  }
}

/// What moves bodies in the step that is given next. If that fails, the steps before come first.
std::vector<sc_prescribed> Simulation::prescribed_on_device() {
  std::vector<sc_prescribed> out;
  if (prescribed_.empty()) return out;
  try {
    together([&] { out = prescribed_step(prescribed_, clock_.now(), clock_.dt, move_now().lag, staggered()); });
  } catch (...) {
    settle_device();
    throw;
  }
  return out;
}

/// Waits for the steps given to the device, and looks whether they went well. One that went wrong is the last.
void Simulation::settle_device() {
  const Stopwatch watch(stages_, "device");
  const DeviceFindings found = device_->particles->settle();
  clock_.step -= found.undone;
  if (found.steps > 0) {
    findings_ = found.last;
    own_findings_ = found.own;
    tally_.contacts += found.contacts;
    tally_.wall_contacts += found.wall_contacts;
    tally_.impacts += found.impacts;
    tally_.impact_speed += found.impact_speed;
  }
  if (found.field_lost) {
    retrieve();
    together([&] { guard_fields(system_.particles, device_->particles->bring_back_fields(), clock_.now()); });
  }
  if (found.steps == 0 || is_sound(findings_, case_.simulation.max_overlap)) return;
  retrieve();
  move_walls(static_cast<double>(clock_.step - 1) * clock_.dt);  // from steps given ahead to where they were
  guard();
}

/// Brings the present state back to system_, if it is on a device; lists are made anew when they are needed.
void Simulation::retrieve() {
  if (!is_on_device()) return;
  settle_device();
  if (retrieved_step_ == clock_.step) return;
  const Stopwatch watch(stages_, "gathering");
  device_->particles->bring_back(system_);
  forget_lists(system_, lists_);
  count_ = ranks_.total(static_cast<std::int64_t>(system_.particles.size()));
  retrieved_step_ = clock_.step;
}

}  // namespace scree
