// The forms of particles, and what follows from a form: volume, moments of inertia, bounding radius.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "scree/physics/shape/form.h"

namespace scree {

using Axes = std::array<double, 3>;

/// A shape beside superellipsoids, of the list SC_OTHER_SHAPES: its word in input files, what its half axes must be,
/// and its geometry by the half axes, in their unit (inertia over the mass).
struct OtherShape {
  std::string_view name, rule;
  int shape;  // SC_SHAPE_...
  int (*fits)(sc_vec);
  double (*bounding)(sc_vec);
  double (*volume)(sc_vec);
  sc_vec (*inertia)(sc_vec);
  double (*surface)(sc_vec);
};

std::span<const OtherShape> other_shapes();

/// The one of that word; nullptr of superellipsoids and of words that mean nothing.
const OtherShape* other_shape(std::string_view name);

/// A form of particles at bounding radius 1. A particle of this form with bounding radius R has R times its lengths, so
/// R^3 times its volume and m R^2 times its moments of inertia.
struct Form {
  sc_form shape{};
  std::array<double, 2> exponents{1, 1};  // e1 along z, e2 in the plane of x and y
  double volume = 0;                      // over R^3
  Axes inertia{};                         // principal moments about the axes of the form, over m R^2
  double equivalent_radius = 0;           // of the sphere of equal volume, over R

  Axes half_axes() const { return {shape.axes.x, shape.axes.y, shape.axes.z}; }  // over R
  const OtherShape* other() const;                                               // nullptr of superellipsoids
  std::string_view shape_name() const;                                           // "superellipsoid", or its word
};

/// All forms of a run; a particle has the index of its form. The first is always the sphere.
using Forms = std::vector<Form>;

/// The largest distance of a point of a superellipsoid from its centre, in the unit of the half axes.
double bounding_radius(const Axes& half_axes, double e1, double e2);

/// Volume of a superellipsoid, in the cubed unit of the half axes (Jaklic, Leonardis, Solina 2000).
double superellipsoid_volume(const Axes& half_axes, double e1, double e2);

/// Principal moments of inertia over the mass, in the squared unit of the half axes (as above).
Axes superellipsoid_inertia(const Axes& half_axes, double e1, double e2);

/// The form of a superellipsoid with half axes in proportion to `half_axes`; 0.1 <= e1, e2 <= 1.9.
Form make_form(const Axes& half_axes, double e1, double e2);

/// The same of half axes that are those at bounding radius 1 to the last bit, as Form::half_axes() gives them.
Form make_form_at_radius_one(const Axes& half_axes, double e1, double e2);

/// Of any shape by its word; the exponents are those of a superellipsoid and nothing to others.
Form make_form(std::string_view shape, const Axes& half_axes, double e1, double e2);
Form make_form_at_radius_one(std::string_view shape, const Axes& half_axes, double e1, double e2);
double bounding_radius(std::string_view shape, const Axes& half_axes, double e1, double e2);

/// Whether some are no superellipsoids.
bool has_other_shapes(const Forms& forms);

/// Whether two forms are the same to the last bit.
bool same_shape(const Form& a, const Form& b);

/// The sphere.
Form sphere_form();

}  // namespace scree
