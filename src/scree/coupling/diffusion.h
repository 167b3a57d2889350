// What particles share out, spread further where they are large against the cells: implicit steps of diffusion, which
// conserve and are their own adjoint (Sun & Xiao 2015, J. Comput. Phys. 282, 1; Capecelatro & Desjardins 2013,
// J. Comput. Phys. 238, 1).
//
// With the operator L, (L x)_cell = sum over faces of face (x_cell - x_neighbour) / volume, n steps take densities r to
// (1 + L)^-n r. What has passed the faces on the way is what the levels g = sum of (1 + L)^-s r, s = 1 to n, let
// through: (1 + L)^-n r = r - L g. So g is what is looked for, as a series of Chebyshev polynomials in L over the
// interval of its eigenvalues; and r - L g conserves, leaves uniform what is uniform and is its own adjoint to rounding
// wherever the series is cut. To solve one step after the other took six times as many sweeps over the cells and more.
#pragma once

#include <span>
#include <vector>

#include "scree/fluid/mesh.h"

namespace scree {

struct Diffusion {
  double length2 = 0;          // diffusivity times time of a step [m2]; 0: nothing is done
  VectorField face;            // of L [m3]; 0 where closed
  Field per_volume;            // [1/m3]; 0 where there is no fluid
  double reach = 0;            // no eigenvalue of L is larger, on any rank
  std::vector<double> series;  // coefficients of the polynomials for g, that of the first halved
  VectorField densities, levels, spare;
};

/// Diffusion to the second moment of a Gaussian of full width at half maximum `width` [m].
Diffusion make_diffusion(const Mesh& mesh, const Ranks& ranks, double width);

/// Of up to three fields: x = what `amount` [anything] of each cell becomes per volume, without ghosts. `levels`: g of
/// the first of them; `face` times its differences are what has passed the faces.
void diffuse(Diffusion& diffusion, const Mesh& mesh, const Ranks& ranks, std::span<const Field> amount,
             std::span<Field> x, Field* levels = nullptr);

}  // namespace scree
