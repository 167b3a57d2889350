// Large eddy simulation: the viscosity of the eddies that the cells cannot show,
//
//   mu_t = rho C D^2 |S|,   S = the deviator of the rate of strain, |S| = sqrt(2 S:S), D the size of a cell
//
// C = constant^2 (Smagorinsky 1963), or found from the flow (Germano et al. 1991 with the least squares of Lilly 1992):
// a filter of two cells makes smaller eddies of the smallest ones there are,
//
//   L = ^(u u) - ^u ^u,   M = 2 (^(D^2 |S| S) - ^D^2 |^S| ^S),   C = <L:M> / <M:M>
//
// where <> is a mean along axes in which the flow is alike, along the paths of the fluid (Meneveau, Lund & Cabot 1996),
// or of the cells around. The filter weighs by volume and void fraction and does not reach through walls.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Makes the fields that the model needs.
void make_eddies(FluidSolver& s);

/// work.eddies from the present velocity [Pa s]. `dt`: how long the paths of the fluid are followed; 0: not at all.
void find_eddies(FluidSolver& s, double dt);

}  // namespace scree
