// Heat between particles and a fluid that carries heat, in the fluid's step: K (T_p - T) per volume with T at its end.
// Each particle relaxes exactly towards the T that it meets then, at the rate of K, and takes what its cells have
// given.
#pragma once

#include "scree/coupling/coupling.h"

namespace scree {

/// What the fluid counts on for each particle in a step; empty where no heat is exchanged.
struct HeatPromise {
  std::vector<double> rate;  // heat flow over the difference of the temperatures now and at the end [W/K]
};

/// Before the fluid's step: tells the cells what their particles will take and give. To be called by all ranks.
HeatPromise load_heat(FluidCoupling& coupling, const Particles& particles, const CellBox& box);

/// After it: gives the particles their heat and enters it in the books. To be called by all ranks.
void keep_promise(FluidCoupling& coupling, const HeatPromise& promise, const CellBox& box, Particles& particles);

}  // namespace scree
