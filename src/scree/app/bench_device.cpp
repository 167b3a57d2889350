#include "scree/app/bench_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "scree/app/bench_clock.h"
#include "scree/app/bench_figures.h"
#include "scree/app/bench_linear.h"
#include "scree/app/build.h"
#include "scree/app/data_files.h"
#include "scree/app/device_run.h"
#include "scree/app/simulation.h"
#include "scree/input/load.h"

namespace scree {
namespace {

constexpr std::array<int, 5> bed_tiles{1, 3, 10, 30, 100};      // side by side, of 100 000 spheres each
constexpr std::array<int, 4> shape_tiles{1, 5, 50, 500};        // of 2000 bodies each
constexpr std::array<int, 4> vortex_periods{1, 10, 100, 1000};  // in all, of vortex_particles each
constexpr int warm_steps = 60;

/// The system repeated nx times along x and ny times along y.
ParticleSystem tiled(const ParticleSystem& one, int nx, int ny) {
  ParticleSystem out = one;
  const double wide = one.domain.length(0), deep = one.domain.length(1);
  const std::int64_t count = static_cast<std::int64_t>(one.particles.size());
  out.domain.max[0] = one.domain.min[0] + nx * wide;
  out.domain.max[1] = one.domain.min[1] + ny * deep;
  for (int tile = 1; tile < nx * ny; ++tile) {
    Particles copy = one.particles;
    for (std::size_t i = 0; i < copy.size(); ++i) {
      copy.motion.row(i)[lane::x] += tile % nx * wide;
      copy.motion.row(i)[lane::y] += tile / nx * deep;
      copy.id[i] += tile * count;
    }
    out.particles.append(copy);
  }
  return out;
}

/// Bytes per second of copying within the device.
double copy_bandwidth(const opencl::Device& device) {
  const std::size_t bytes = std::size_t{1} << 28;
  opencl::DeviceBuffer from(device, bytes), to(device, bytes);
  double best = 0;
  for (int round = 0; round < 5; ++round) {
    device.finish();
    const double seconds = seconds_for([&] {
      for (int k = 0; k < 4; ++k) to.copy_from(from, bytes);
      device.finish();
    });
    best = std::max(best, 2.0 * 4.0 * static_cast<double>(bytes) / seconds);
  }
  return best;
}

/// What steps that follow each other are told.
sc_move move_of(const Fields& fields, double dt) {
  sc_move m{};
  m.scheme = SC_LEAPFROG;
  m.drag = fields.drag;
  m.kick = m.drift = dt;
  m.lag = 0.5 * dt;
  m.gravity = fields.uniform;
  return m;
}

/// Where and how steps are measured.
struct Target {
  opencl::Device device;
  Precision precision;

  const char* precision_name() const { return precision == Precision::mixed ? "mixed" : "double"; }
};

/// What one particle-step has to move on a device: the particle's state both ways, where it was listed, losses both
/// ways; where fields act, works and impulses of both kinds, both ways; of every candidate its entry and its place, of
/// every contact the rest of the partner's state, and its spring both ways. Both sides of a pair do this. In double
/// precision also the image; in mixed precision rows of others are half as long, and only the particle itself has to do
/// with the rests of its place, velocity and spin.
double bytes_on_device(Precision precision, double candidates, double contacts, bool fields) {
  constexpr double book = 32;
  const bool mixed = precision == Precision::mixed;
  const double row = mixed ? 16 : 32, image = mixed ? 0 : 16, rests = mixed ? 3 * 12 : 0;
  return 2 * (3 * row + rests) + image + row + 2 * book + (fields ? 6 * book : 0) + candidates * (4 + row) +
         contacts * (4 * row);
}

/// Steps on a device, one after the other with nothing between them.
class DeviceSteps {
 public:
  DeviceSteps(const Target& target, const ParticleSystem& system, const Fields& fields, double dt)
      : lists_(prepare_lists(system, 0)),
        particles_(target.device, target.precision, system, lists_, fields, {}, 1),
        move_(move_of(fields, dt)),
        time_{dt, 0.5 * dt, dt},
        walls_{system.walls.poses} {}

  void run(int steps) {
    for (int k = 0; k < steps; ++k) {
      particles_.step({move_, time_, walls_, {}, 0});
      if (particles_.is_full()) contacts_ += particles_.settle().contacts;
    }
    contacts_ += particles_.settle().contacts;
  }

  /// That acted, summed over the steps.
  std::int64_t contacts() const { return contacts_; }
  const DeviceParticles& particles() const { return particles_; }

 private:
  ContactLists lists_;
  DeviceParticles particles_;
  sc_move move_;
  sc_contact_time time_;
  WallsOfStep walls_;
  std::int64_t contacts_ = 0;
};

/// One system, warmed up, in rounds of steps.
DeviceFigures measure_size(const Target& target, const ParticleSystem& system, const Fields& fields, double dt,
                           int rounds, int round_steps) {
  DeviceSteps steps(target, system, fields, dt);
  steps.run(warm_steps);
  const std::int64_t contacts_before = steps.contacts();
  DeviceFigures f;
  f.device = target.device.info().name;
  f.precision = target.precision_name();
  f.particles = static_cast<std::int64_t>(system.particles.size());
  f.steps = round_steps;
  const double particle_steps = static_cast<double>(f.particles) * round_steps;
  std::vector<double> rates;
  for (int round = 0; round < rounds; ++round)
    rates.push_back(particle_steps / seconds_for([&] { steps.run(round_steps); }));
  f.rate = median(rates);
  f.slowest = *std::min_element(rates.begin(), rates.end());
  f.fastest = *std::max_element(rates.begin(), rates.end());
  f.contacts = static_cast<double>(steps.contacts() - contacts_before) / (particle_steps * rounds);
  f.shaped = system.particles.shaped();
  f.bytes =
      f.shaped ? 0
               : bytes_on_device(target.precision, steps.particles().candidates(), 2 * f.contacts, act_locally(fields));
  f.memory = static_cast<double>(steps.particles().bytes()) / static_cast<double>(f.particles);
  return f;
}

/// What limits spheres, and what shapes are compared by.
std::string measure_text(const DeviceFigures& f) {
  if (f.shaped) return fmt::format("{:.4g} M contacts/s", 1e-6 * f.rate * f.contacts);
  return fmt::format("{:.0f} bytes per particle-step, {:.0f} % of copying ({:.0f} GB/s)", f.bytes,
                     100 * f.rate * f.bytes / f.copy_bandwidth, 1e-9 * f.copy_bandwidth);
}

void print_figures(const DeviceFigures& f) {
  fmt::print(
      "{:<11} {:<6} {:>9} particles {:>8.4g} M particle-steps/s ({:.4g} to {:.4g}), {:.4g} s for {} steps; {:.2f} "
      "contacts per particle; {}; {:.0f} bytes of memory per particle\n",
      f.name, f.precision, f.particles, 1e-6 * f.rate, 1e-6 * f.slowest, 1e-6 * f.fastest,
      static_cast<double>(f.particles) * f.steps / f.rate, f.steps, f.contacts, measure_text(f), f.memory);
  std::fflush(stdout);
}

/// A bed, repeated sideways.
class Bed {
 public:
  explicit Bed(const BenchScene& scene)
      : case_(load_case((data_directory("bench") / (scene.file + ".toml")).string(), scene.changes)),
        fields_(build_fields(case_)),
        one_(build_system(case_, fields_)) {}

  std::int64_t particles(int tiles) const { return tiles * static_cast<std::int64_t>(one_.particles.size()); }
  bool is_shaped() const { return one_.particles.shaped(); }

  DeviceFigures measure(const Target& target, int tiles, int rounds) const {
    const std::array<int, 3> n = repeats(tiles);
    return measure_size(target, tiled(one_, n[0] * n[2], n[1]), fields_, *case_.simulation.time_step, rounds, 200);
  }

 private:
  Case case_;
  Fields fields_;
  ParticleSystem one_;
};

/// Periods of the vortex of 10 000 cohesive spheres each. The largest box does as many steps as the report's run of ten
/// million spheres.
class Vortex {
 public:
  std::int64_t particles(int periods) const { return periods * vortex_particles; }

  DeviceFigures measure(const Target& target, int periods, int rounds) const {
    const Simulation start(vortex_case(periods), 1);
    const bool largest = periods == vortex_periods.back();
    return measure_size(target, start.system(), start.fields(), start.clock().dt, largest ? 1 : rounds,
                        largest ? 10000 : 200);
  }
};

template <class Scene, std::size_t Count>
std::vector<DeviceFigures> measure_sizes(const Scene& scene, const std::string& name,
                                         const std::array<int, Count>& sizes, const Target& target,
                                         std::int64_t largest, int rounds) {
  const double bandwidth = copy_bandwidth(target.device);
  std::vector<DeviceFigures> all;
  for (const int size : sizes) {
    if (scene.particles(size) > largest) break;
    all.push_back(scene.measure(target, size, rounds));
    all.back().name = name;
    all.back().copy_bandwidth = bandwidth;
    print_figures(all.back());
  }
  return all;
}

Target target_of(const BenchOptions& o) {
  return {opencl::Device(find_device(o.device)), find_precision(o.precision, o.device)};
}

}  // namespace

std::vector<DeviceFigures> measure_bed_on_device(const std::string& benchmark, const BenchScene& scene,
                                                 const BenchOptions& o, std::int64_t largest, int rounds) {
  const Target target = target_of(o);
  const Bed bed(scene);
  if (bed.is_shaped()) return measure_sizes(bed, benchmark, shape_tiles, target, largest, rounds);
  return measure_sizes(bed, benchmark, bed_tiles, target, largest, rounds);
}

std::vector<DeviceFigures> measure_vortex_on_device(const BenchOptions& o, std::int64_t largest, int rounds) {
  return measure_sizes(Vortex(), "gpu-vortex", vortex_periods, target_of(o), largest, rounds);
}

nlohmann::json device_json(const DeviceFigures& f) {
  return {{"benchmark", f.name},
          {"device", f.device},
          {"precision", f.precision},
          {"steps", f.steps},
          {"particles", f.particles},
          {"particle_steps_per_second", f.rate},
          {"slowest_round", f.slowest},
          {"fastest_round", f.fastest},
          {"contacts_per_particle", f.contacts},
          {"contacts_per_second", f.rate * f.contacts},
          {"bytes_per_particle_step", f.bytes},
          {"copy_bytes_per_second", f.copy_bandwidth},
          {"memory_per_particle", f.memory}};
}

}  // namespace scree
