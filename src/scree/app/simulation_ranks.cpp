// A simulation on several ranks: the root conducts, the others follow.
#include <algorithm>
#include <cstring>

#include "scree/app/device_run.h"
#include "scree/app/simulation.h"
#include "scree/base/error.h"
#include "scree/particles/migration.h"

namespace scree {
namespace {

/// The physics has gone wrong on another rank, or this one has told the root.
struct WrongElsewhere {};

/// What a rank has had to do.
struct ShareOfRank {
  Effort effort;
  double particles = 0;
};

Bytes bytes_of(const std::string& text) {
  Bytes out(text.size());
  if (!text.empty()) std::memcpy(out.data(), text.data(), text.size());
  return out;
}

}  // namespace

void Simulation::call(Call what) const {
  if (!ranks_.alone() && ranks_.root()) ranks_.of_root(static_cast<std::int64_t>(what));
}

std::int64_t Simulation::follow() {
  for (;;) {
    try {
      const Call what = static_cast<Call>(ranks_.of_root(0));
      if (what == Call::dismiss) return ranks_.of_root(0);
      what == Call::step ? advance() : help(what);
    } catch (const WrongElsewhere&) {
      // The root decides what becomes of the run.
    }
  }
}

/// The other ranks' part of what the root does when it looks at the present state.
void Simulation::help(Call what) {
  switch (what) {
    case Call::sample:
      return take_own_sample();
    case Call::measure:
      return void(measure_share());
    case Call::row:
      return void(look_at_share());
    case Call::frame:
      return frame_share(nullptr, nullptr);
    case Call::finite:
      return void(ranks_.all(is_share_finite()));
    case Call::hash:
      return void(hash_share());
    case Call::save:
      return void(saved_ = save_share());
    case Call::keep:
      return void(kept_ = share());
    case Call::save_kept:
      return void(saved_ = archive_of(*kept_, ranks_));
    case Call::write:
      write_archive({}, saved_, ranks_);
      return void(saved_ = Archive());
    case Call::gather:
      return gather();
    case Call::planes:
      return void(plane_counts());
    case Call::report:
      return void(report());
    case Call::fluid_row:
      return void(fluid_row());
    case Call::fluid_frame:
      return void(fluid_frame(false));
    case Call::fluid_hash:
      return void(fluid_hash());
    case Call::step:
    case Call::dismiss:
      return;
  }
}

void Simulation::dismiss(std::int64_t parting) {
  if (ranks_.alone()) return;
  call(Call::dismiss);
  ranks_.of_root(parting);
}

/// Runs what may find on some ranks only that the physics has gone wrong. It has then gone wrong on all of them: the
/// root throws what the first of them says.
void Simulation::together(const std::function<void()>& look) const {
  if (ranks_.alone()) return look();
  std::string finding;
  try {
    look();
  } catch (const PhysicsError& error) {
    finding = error.what();
  }
  if (ranks_.all(finding.empty())) return;
  for (const Bytes& said : ranks_.gather(bytes_of(finding)))
    if (!said.empty()) throw PhysicsError(std::string(reinterpret_cast<const char*>(said.data()), said.size()));
  throw WrongElsewhere();
}

/// Keeps this rank's share of a system that every rank has as a whole.
void Simulation::settle() {
  cut_blocks(Ranks());
  if (!ranks_.alone()) lists_.luggage = keep_share(system_, lists_.blocks, ranks_);
}

/// Begins anew with blocks of equal numbers of particles: of those that `who_counts` have together.
void Simulation::cut_blocks(const Ranks& who_counts) {
  count_ = who_counts.total(static_cast<std::int64_t>(system_.particles.size()));
  whole_step_ = -1;
  if (ranks_.alone()) return;
  lists_.ranks = ranks_;
  lists_.blocks = equal_blocks(ranks_.count(), system_.domain);
  const std::vector<std::int32_t> equal_loads(system_.particles.size(), 1);
  balance(lists_.blocks, system_.domain, system_.particles, equal_loads, who_counts);
}

std::int64_t Simulation::particles() const {
  if (is_on_device() && ranks_.alone()) return static_cast<std::int64_t>(device_->particles->count());
  return ranks_.alone() ? static_cast<std::int64_t>(system_.particles.size()) : count_;
}

std::vector<Bytes> Simulation::report() const {
  const std::size_t mine = is_on_device() ? device_->particles->count() : system_.particles.size();
  const ShareOfRank share{effort_, static_cast<double>(mine)};
  Bytes bytes(sizeof share);
  std::memcpy(bytes.data(), &share, sizeof share);
  return ranks_.gather(bytes);
}

std::vector<std::pair<std::string, double>> Simulation::sharing() const {
  if (ranks_.alone() || effort_.stretches == 0) return {};
  call(Call::report);
  double messages = 0, bytes = 0, busy = 0, waiting = 0, busiest = 0, most_particles = 0;
  for (const Bytes& said : report()) {
    ShareOfRank share;
    std::memcpy(&share, said.data(), sizeof share);
    messages += static_cast<double>(share.effort.traffic.messages);
    bytes += static_cast<double>(share.effort.traffic.bytes);
    waiting += share.effort.traffic.waiting;
    busy += share.effort.busy();
    busiest = std::max(busiest, share.effort.busy());
    most_particles = std::max(most_particles, share.particles);
  }
  const double ranks = ranks_.count(), rank_steps = ranks * static_cast<double>(effort_.stretches);
  return {{"messages", messages / rank_steps},
          {"bytes", bytes / rank_steps},
          {"busy", busy / ranks},
          {"waiting", waiting / ranks},
          {"imbalance", busiest * ranks / busy - 1},
          {"most_particles", most_particles}};
}

std::vector<PlaneCount> Simulation::plane_counts() {
  if (planes_.empty()) return {};
  call(Call::planes);
  if (is_on_device()) take_passings();
  return planes_.counts(ranks_);
}

void Simulation::gather() {
  retrieve();
  move_walls(clock_.now());
  refresh_neighbours();
  const Stopwatch watch(stages_, "gathering");
  gather_system(system_, ranks_, whole_);
  whole_step_ = clock_.step;
}

const ParticleSystem& Simulation::whole() {
  if (ranks_.alone()) {
    retrieve();
    return system_;
  }
  if (whole_step_ != clock_.step) {
    call(Call::gather);
    gather();
  }
  return whole_;
}

}  // namespace scree
