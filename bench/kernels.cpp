// Time per item of the parts of a step, each on its own: the pass over contacts, neighbour search, sorting, planning,
// energy, agglomerates.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <random>
#include <string>

#include "scree/analysis/measure.h"
#include "scree/app/simulation.h"
#include "scree/input/load.h"
#include "scree/particles/neighbours.h"
#include "scree/particles/sample.h"

namespace {

using namespace scree;

/// Reports the processor's time per item.
void count_items(benchmark::State& state, std::size_t items_per_iteration) {
  state.counters["items"] = static_cast<double>(items_per_iteration);
  state.counters["per_item"] =
      benchmark::Counter(static_cast<double>(items_per_iteration),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

constexpr double diameter = 2e-3, spacing = 0.99 * diameter;  // [m]

/// A crystal of `side`^3 spheres in a periodic box, each pressed 1 % into its six neighbours and trembling a little.
Case crystal(const std::string& laws, const std::string& material, int side) {
  std::string text = fmt::format(
      "[simulation]\nend = 1\ntime_step = 1e-6\n"
      "[domain]\nmin = [0, 0, 0]\nmax = [{0}, {0}, {0}]\nperiodic = [true, true, true]\n[contact]\n{1}\n"
      "[[materials]]\nname = \"grain\"\ndensity = 2500\nrestitution = 0.8\n{2}\n"
      "[[particles]]\nname = \"crystal\"\nmaterial = \"grain\"\ndiameter = {3}\n"
      "velocity = {{ type = \"random\", deviation = 1e-3 }}\ninsert = \"positions\"\npositions = [\n",
      spacing * side, laws, material, diameter);
  for (int i = 0; i < side * side * side; ++i)
    text +=
        fmt::format("[{}, {}, {}],\n", spacing * (i % side), spacing * (i / side % side), spacing * (i / side / side));
  return parse_case(text + "]\n", "crystal.toml");
}

/// A system with its lists, ready for passes.
struct Scene {
  Fields fields;
  ParticleSystem system;
  ContactLists lists;

  explicit Scene(const Case& c, int threads = 1)
      : fields(build_fields(c)), system(build_system(c, fields)), lists(prepare_lists(system, c.simulation.skin)) {
    refresh_lists(system, lists, threads);
  }

  SweepFindings pass(double time_step) {
    sc_move move{};
    move.scheme = SC_LEAPFROG;
    move.kick = move.drift = time_step;
    const SweepView view = view_of(system, lists, move, {time_step, 0.5 * time_step, time_step}, nullptr);
    return sweep(lists.kernels, view, lists.plan);
  }
};

// Contacts and motion, per contact that acted; 1000 spheres stay in the second cache.
void pass_over_contacts(benchmark::State& state, const std::string& laws, const std::string& material) {
  Scene scene(crystal(laws, material, 10));
  std::int64_t contacts = 0;
  for (auto _ : state) contacts += scene.pass(1e-6).contacts;
  count_items(state, static_cast<std::size_t>(contacts / static_cast<std::int64_t>(state.iterations())));
  state.SetLabel(scene.lists.kernels.name);
}

const std::string linear = "stiffness = 1e4\n", hertz = "young = 25e6\npoisson = 0.3\n";
BENCHMARK_CAPTURE(pass_over_contacts, linear_frictionless, "normal = \"linear\"\ntangential = \"none\"", linear);
BENCHMARK_CAPTURE(pass_over_contacts, linear_history, "normal = \"linear\"\ntangential = \"history\"",
                  linear + "friction = 0.5");
BENCHMARK_CAPTURE(pass_over_contacts, linear_history_cohesion,
                  "normal = \"linear\"\ntangential = \"history\"\ncohesion = \"linear\"",
                  linear + "friction = 0.5\ncohesion_stiffness = 100");
BENCHMARK_CAPTURE(pass_over_contacts, hertz_mindlin, "normal = \"hertz\"\ntangential = \"mindlin\"",
                  hertz + "friction = 0.5");
BENCHMARK_CAPTURE(pass_over_contacts, hertz_mindlin_rolling,
                  "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"spring\"",
                  hertz + "friction = 0.5\nrolling_friction = 0.1");
BENCHMARK_CAPTURE(pass_over_contacts, hertz_mindlin_jkr,
                  "normal = \"hertz\"\ntangential = \"mindlin\"\ncohesion = \"jkr\"",
                  hertz + "friction = 0.5\nadhesion = 0.05");

/// Spheres anywhere in a periodic cube, in the order of storage. Equal ones, or half of the volume in spheres ten times
/// as large as the others.
struct Cloud {
  Domain domain;
  Particles particles;
  double skin = 0.1;

  explicit Cloud(bool ten_to_one, std::size_t count = 50000, double solid_fraction = 0.5) {
    particles.resize(count);
    const std::size_t large = ten_to_one ? count / 1001 : 0;
    std::mt19937_64 random(1);
    double volume = 0;
    for (std::size_t i = 0; i < count; ++i) {
      double* m = particles.motion.row(i);
      m[lane::radius] = i < large ? 5.0 : 0.5;
      m[lane::inverse_mass] = 1;
      volume += 4.0 / 3.0 * 3.14159265358979 * m[lane::radius] * m[lane::radius] * m[lane::radius];
      particles.id[i] = static_cast<std::int64_t>(i);
    }
    const double side = std::cbrt(volume / solid_fraction);
    domain = {{0, 0, 0}, {side, side, side}, {true, true, true}};
    std::uniform_real_distribution<double> uniform(0, side);
    for (std::size_t i = 0; i < count; ++i)
      for (int k = 0; k < 3; ++k) particles.motion.row(i)[k] = uniform(random);
    particles.permute(storage_order(particles, domain, 1.1));
  }
};

// Per candidate found.
void neighbour_search(benchmark::State& state, bool ten_to_one) {
  const Cloud cloud(ten_to_one);
  std::size_t found = 0;
  for (auto _ : state) found = find_candidates(cloud.particles, cloud.domain, cloud.skin).count;
  count_items(state, found);
}
BENCHMARK_CAPTURE(neighbour_search, equal, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(neighbour_search, ten_to_one, true)->Unit(benchmark::kMillisecond);

// Per particle.
void order_of_storage(benchmark::State& state) {
  const Cloud cloud(false);
  for (auto _ : state) benchmark::DoNotOptimize(storage_order(cloud.particles, cloud.domain, 1.1).data());
  count_items(state, cloud.particles.size());
}
BENCHMARK(order_of_storage)->Unit(benchmark::kMillisecond);

// Per particle: all its fields move.
void permutation(benchmark::State& state) {
  Cloud cloud(false);
  const std::vector<std::uint32_t> order = storage_order(cloud.particles, cloud.domain, 1.3);
  for (auto _ : state) cloud.particles.permute(order);
  count_items(state, cloud.particles.size());
}
BENCHMARK(permutation)->Unit(benchmark::kMillisecond);

// Per candidate: a plan for this many threads, made by one.
void plan_of_the_pass(benchmark::State& state) {
  const Cloud cloud(false);
  const Candidates pairs = find_candidates(cloud.particles, cloud.domain, cloud.skin);
  const WallContacts walls = find_wall_contacts(cloud.particles, {}, cloud.skin);
  const int threads = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(plan_sweep(pairs, walls, cloud.particles, threads).slots);
  count_items(state, pairs.count);
}
BENCHMARK(plan_of_the_pass)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond);

/// A crystal after its first pass: all contacts act.
Scene pressed_crystal(int side) {
  Scene scene(crystal("normal = \"hertz\"\ntangential = \"mindlin\"", hertz + "friction = 0.5", side));
  scene.pass(1e-6);
  return scene;
}

// Per contact.
void energy_in_contacts(benchmark::State& state) {
  const Scene scene = pressed_crystal(30);
  for (auto _ : state) benchmark::DoNotOptimize(stored_energy(scene.system).elastic);
  count_items(state, scene.system.contacts.pairs.count);
}
BENCHMARK(energy_in_contacts)->Unit(benchmark::kMillisecond);

// Per bond: who belongs to whom, and shape and size of one large agglomerate.
void agglomerates(benchmark::State& state) {
  const Scene scene = pressed_crystal(30);
  std::size_t bonds = 0;
  for (auto _ : state) {
    const std::vector<Bond> found = bonds_of(scene.system);
    bonds = found.size();
    benchmark::DoNotOptimize(find_agglomerates(scene.system.particles, scene.system.domain, found).list.data());
  }
  count_items(state, bonds);
}
BENCHMARK(agglomerates)->Unit(benchmark::kMillisecond);

}  // namespace

// One thread does all: the time that counts is the processor's, so that other programs disturb less.
int main(int argc, char** argv) {
  omp_set_num_threads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
