// A simulation on a device: particles go there before the first step and come back when somebody looks at them.
#include "scree/app/device_run.h"
#include "scree/app/guard.h"
#include "scree/app/simulation.h"
#include "scree/base/error.h"

namespace scree {

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::use_device(const opencl::DeviceInfo& info) {
  refuse_on_device(case_);
  device_ = std::make_unique<DeviceRun>(info);
}

bool Simulation::is_on_device() const { return device_ && device_->spheres; }

void Simulation::advance_on_device() {
  auto& spheres = device_->spheres;
  move_walls_on_device();
  if (!spheres) spheres.emplace(device_->device, system_, lists_, fields_, case_.simulation.max_overlap);
  spheres->step(move_now(), contact_time_now(), {system_.walls.poses, way_of_walls()});
  clock_.advance();
  if (spheres->is_full()) settle_device();
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

/// Waits for the steps given to the device, and looks whether they went well. One that went wrong is the last.
void Simulation::settle_device() {
  const Stopwatch watch(stages_, "device");
  const DeviceFindings found = device_->spheres->settle();
  clock_.step -= found.undone;
  if (found.steps == 0) return;
  findings_ = found.last;
  tally_.contacts += found.contacts;
  tally_.wall_contacts += found.wall_contacts;
  tally_.impacts += found.impacts;
  tally_.impact_speed += found.impact_speed;
  if (is_sound(findings_, case_.simulation.max_overlap)) return;
  move_walls(static_cast<double>(clock_.step - 1) * clock_.dt);  // from steps given ahead to where they were
  bring_back();
  guard_step(whole_, findings_, case_.simulation.max_overlap, clock_.now());
}

void Simulation::bring_back() {
  const Stopwatch watch(stages_, "gathering");
  device_->spheres->bring_back(system_, whole_);
  whole_step_ = clock_.step;
}

}  // namespace scree
