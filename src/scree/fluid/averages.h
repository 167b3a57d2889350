// Means of the flow over time, and the mean products of what fluctuates about them.
#pragma once

#include "scree/fluid/flow.h"

namespace scree {

/// Means are weighted with the time steps. They and the products move with every sample (West 1979, Comm. ACM 22, 532):
/// nothing large is subtracted from something large.
struct FluidAverages {
  static constexpr int products = 6;  // xx, yy, zz, xy, yz, zx

  double time = 0;        // in all [s]; 0: nothing yet
  VectorField velocity;   // mean [m/s]
  Field pressure;         // mean [Pa]
  VectorField square;     // time times mean product of fluctuations: xx, yy, zz
  VectorField cross;      // xy, yz, zx
  Field pressure_square;  // likewise
};

/// Room for the averages of a mesh, empty.
FluidAverages make_averages(const Mesh& mesh);

/// Adds the present state with a weight [s].
void add_sample(FluidAverages& averages, const Mesh& mesh, const FluidState& state, double weight);

/// Calls visit(name, field) for all that continuing to the last bit needs, beside `time`.
template <class Averages, class Visit>
void for_each_average(Averages& a, Visit&& visit) {
  constexpr const char* axes[] = {"x", "y", "z"};
  constexpr const char* pairs[] = {"xy", "yz", "zx"};
  for (int c = 0; c < 3; ++c) {
    visit(std::string("fluid_mean_velocity_") + axes[c], a.velocity[c]);
    visit(std::string("fluid_square_") + axes[c], a.square[c]);
    visit(std::string("fluid_product_") + pairs[c], a.cross[c]);
  }
  visit(std::string("fluid_mean_pressure"), a.pressure);
  visit(std::string("fluid_pressure_square"), a.pressure_square);
}

}  // namespace scree
