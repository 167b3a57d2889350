// What particles share out, spread further where they are large against the cells: implicit steps of diffusion, which
// conserve and are their own adjoint (Sun & Xiao 2015, J. Comput. Phys. 282, 1; Capecelatro & Desjardins 2013,
// J. Comput. Phys. 238, 1).
#pragma once

#include "scree/fluid/helmholtz.h"

namespace scree {

struct Diffusion {
  double length2 = 0;  // diffusivity times time of a step [m2]; 0: nothing is done
  Helmholtz equation;
  VectorField spare, rest;
};

/// Diffusion to the second moment of a Gaussian of full width at half maximum `width` [m].
Diffusion make_diffusion(const Mesh& mesh, const Ranks& ranks, double width);

/// Of three fields with one layer of ghosts: x = what `amount` [anything] of each cell becomes per volume. `levels`:
/// the sum over the steps of the first of them; the face coefficients times its differences are what has passed the
/// faces.
void diffuse(Diffusion& diffusion, const Mesh& mesh, const Ranks& ranks, const VectorField& amount, VectorField& x,
             Field* levels = nullptr);

}  // namespace scree
