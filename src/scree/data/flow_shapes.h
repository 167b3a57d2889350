// What a flow wants to know of the forms of particles (physics/drag/body/flow_shape.h), made from their half axes and
// exponents.
#pragma once

#include <vector>

#include "scree/data/forms.h"
#include "scree/physics/drag/body/flow_shape.h"

namespace scree {

/// A form in a flow. The tables are empty where the shape is an ellipsoid or no superellipsoid.
struct FlowShape {
  sc_flow_shape shape{};
  std::vector<double>
      shadow;                // at the nodes of physics/shape/octant_table.h, of a direction scaled by the axis shadows
  std::vector<double> mean;  // the same of a direction
};

/// The shape of a superellipsoid. Shadows are right within 1e-3 for exponents up to 1.2 (flow_shapes_test.cpp has the
/// errors); resistances and added masses are those of the ellipsoid with half axes in the same proportion and the same
/// volume.
FlowShape make_flow_shape(const Axes& half_axes, double e1, double e2);

/// The shapes of all forms; those with equal exponents share the work. The shadows of shapes that are no
/// superellipsoids are exact; their resistances and added masses are those of the ellipsoid with their proportions and
/// volume.
std::vector<FlowShape> make_flow_shapes(const Forms& forms);

}  // namespace scree
