// A cloud of colliding spheres in a periodic box of fluid, everything in motion; what there is of momentum; and a
// single particle in a closed box.
#pragma once

#include <fmt/format.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "scree/app/simulation.h"
#include "scree/input/load.h"

namespace scree {

/// The particles' velocity and the cells of the fluid, and what else [fluid] and [coupling] say, may be replaced.
struct Cloud {
  double density = 2500, viscosity = 1e-3;
  double stiffness = 300;
  int subcycles = 1;
  std::string velocity = R"({ type = "random", value = [0.3, -0.2, 0.1], deviation = 0.3 })";
  std::string shape = R"(diameter = 0.002
count = 150)";
  std::string periodic = "[true, true, true]";
  std::string cells = "cells = [5, 4, 6]";
  std::string stream = R"x(["0.3 * sin(314.159265358979 * y)", "0", "0.2"])x";
  std::string accuracy = R"(correctors = 2
divergence_tolerance = 1e-13)";
  std::string coupling = R"(drag = "gidaspow_blend")";

  std::string text() const {
    return fmt::format(R"toml(
[simulation]
end = 1
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.02, 0.02, 0.02]
periodic = {}
[contact]
normal = "linear"
[[materials]]
name = "grain"
density = {}
stiffness = {}
restitution = 0.8
friction = 0.3
[[particles]]
name = "cloud"
material = "grain"
insert = "random"
{}
velocity = {}
[fluid]
type = "incompressible"
density = 10
viscosity = {}
{}
velocity = {}
convection = "van_leer"
{}
[coupling]
{}
subcycles = {}
)toml",
                       periodic, density, stiffness, shape, velocity, viscosity, cells, stream, accuracy, coupling,
                       subcycles);
  }
};

/// The tests are small: threads would cost more than they do.
inline Case case_of(const std::string& text) {
  omp_set_num_threads(1);
  return parse_case(text, "coupled.toml");
}

inline std::array<double, 3> particle_momentum(const Simulation& s) {
  const Particles& p = s.system().particles;
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int a = 0; a < 3; ++a) sum[a] += p.mass[i] * p.motion.row(i)[lane::vx + a];
  return sum;
}

/// Momentum of fluid, of particles and under way. With a backward formula of two steps the fluid's own is that of now
/// and half of its last change.
inline std::array<double, 3> momentum(const Simulation& s) {
  const FluidBooks& b = s.coupling()->fluid.state.books;
  const std::array<double, 3> particles = particle_momentum(s),
                              between = under_way(*s.coupling(), s.system().particles);
  std::array<double, 3> sum{};
  for (int a = 0; a < 3; ++a) sum[a] = b.content[a] + 0.5 * b.change[a] + particles[a] + between[a];
  return sum;
}

/// The largest change of the momentum in some steps, over the size of that of the particles. `spoil` is called after
/// each.
inline double drift_of(const Cloud& cloud, int steps, const std::function<void(Particles&)>& spoil = {}) {
  Simulation s(case_of(cloud.text()), 1);
  for (int n = 0; n < 20; ++n) s.step();
  const std::array<double, 3> first = momentum(s);
  double size = 0, drift = 0;
  for (const double m : particle_momentum(s)) size += std::abs(m);
  for (int n = 0; n < steps; ++n) {
    s.step();
    if (spoil) spoil(const_cast<Particles&>(s.system().particles));
    if (n % 50 != 0) continue;
    const std::array<double, 3> now = momentum(s);
    for (int a = 0; a < 3; ++a) drift = std::max(drift, std::abs(now[a] - first[a]) / size);
  }
  return drift;
}

/// A cube of side 1.2 mm with one particle in the middle.
inline std::string cube(int cells, double density, double viscosity, const std::string& particle,
                        const std::string& coupling) {
  return fmt::format(R"toml(
[simulation]
end = 1
time_step = 2e-5
[domain]
min = [0, 0, 0]
max = [0.0012, 0.0012, 0.0012]
[gravity]
type = "uniform"
acceleration = [0, 0, -9.81]
[contact]
normal = "linear"
[[materials]]
name = "stuff"
density = {1}
stiffness = 1
restitution = 0.8
[[particles]]
name = "body"
material = "stuff"
{3}
insert = "positions"
positions = [[0.00061, 0.00058, 0.0006]]
[fluid]
type = "incompressible"
density = 1000
viscosity = {2}
cells = [{0}, {0}, {0}]
[coupling]
{4}
)toml",
                     cells, density, viscosity, particle, coupling);
}

}  // namespace scree
