// Fine dust at rest in a column of fluid 16 cells tall, periodic all around: it follows whatever the fluid does.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "scree/app/simulation.h"

namespace scree::dust {

constexpr double wave_number = 125 * std::numbers::pi;                  // of one wave in the column [1/m]
inline const double solids = std::numbers::pi / 6 * std::pow(0.25, 3);  // of the volume

/// The case, with what else the dust's material, its particles, the fluid and the coupling say, and further tables.
inline std::string column(const std::string& material, const std::string& particles, const std::string& fluid,
                          const std::string& coupling, const std::string& tables = "") {
  return R"toml(
[simulation]
end = 10
time_step = 2e-3
[domain]
min = [0, 0, 0]
max = [0.001, 0.001, 0.016]
periodic = [true, true, true]
[contact]
normal = "linear"
[[materials]]
name = "dust"
density = 2500
stiffness = 1e-9
)toml" + material +
         R"toml(
[[particles]]
material = "dust"
diameter = 1.25e-4
insert = "lattice"
spacing = 5e-4
)toml" + particles +
         R"toml(
[fluid]
type = "incompressible"
density = 1000
viscosity = 1e-3
cells = [1, 1, 16]
)toml" + fluid +
         "\n[coupling]\nsubcycles = 1\n" + coupling + "\n" + tables;
}

/// The height of a wave of a field of the fluid.
inline double wave_in(const Simulation& s, const Field& field) {
  double sum = 0;
  for (int k = 0; k < 16; ++k)
    sum += field[s.coupling()->fluid.mesh.index(0, 0, k)] * std::sin(std::numbers::pi / 8 * (k + 0.5));
  return sum / 8;
}

/// How fast the wave of a field fades once the dust follows the fluid, over a time of 3 s [1/s].
template <class FieldOf>
double fading(Simulation& s, FieldOf field) {
  while (s.clock().now() < 0.1) s.step();
  const double before = wave_in(s, field());
  while (s.clock().now() < 3.1) s.step();
  return std::log(before / wave_in(s, field())) / 3;
}

}  // namespace scree::dust
