// Areas of superellipsoids: of the surface and of the shadow.
#pragma once

#include "scree/data/forms.h"

namespace scree {

/// Surface area, in the squared unit of the half axes, within about 1e-9 of itself; 0.1 <= e1, e2 <= 2.
double superellipsoid_surface(const Axes& half_axes, double e1, double e2);

/// Surface area of a form, over the square of its bounding radius.
double surface_of(const Form& form);

/// Area of the sphere of equal volume over that of the surface (Wadell 1935): 1 for spheres, less for all others.
double sphericity(double volume, double surface);
double sphericity(const Form& form);

/// Area of the shadow in parallel light along `direction` (of any length), in the squared unit of the half axes, within
/// about 1e-9 of itself with 8 `parts` of each quadrant, 2e-4 with 1. Its mean over all directions is a quarter of the
/// surface (Cauchy 1832).
double shadow_area(const Axes& half_axes, double e1, double e2, const Axes& direction, int parts = 8);

}  // namespace scree
