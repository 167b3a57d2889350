// The growth distance of two bodies by the ellipsoid method (Yudin and Nemirovski 1976, Shor 1977): slow, and
// certain to end, however little curvature bodies have and wherever they have edges.
//
// An ellipsoid that holds the place of the least value of a convex function is cut through its centre by the gradient
// there; the smallest ellipsoid around the half that is left is smaller by a constant factor. With the ellipsoid as the
// image of a ball under a matrix J of n columns, p = J^T g/|J^T g| and q = J p the centre moves by -q/(n + 1), and
// J becomes n/sqrt(n^2 - 1) (J - (1 - sqrt((n - 1)/(n + 1))) q p^T), which loses no digits where it gets thin.
//
// Once over points in space, for the larger gauge, and once over directions with n.d = 1, for the support value of
// both.
#ifndef SCREE_PHYSICS_TOUCH_CUTS_H
#define SCREE_PHYSICS_TOUCH_CUTS_H

#include "scree/physics/touch/portal.h"

/// Enough to bring an ellipsoid from the size of the bodies to that of rounding.
enum { SC_CUTS_OF_POINTS = 1200, SC_CUTS_OF_DIRECTIONS = 600 };

/// An ellipsoid around a centre, of `count` columns: 3, or 2 for one that is flat.
typedef struct {
  sc_vec centre, column[3];
  int count;
} sc_cut_region;

/// Leaves the half of the region where a convex function may be less than at the centre, with the gradient g there.
/// Returns by how much at most. 0: nowhere.
SC_FN real sc_cut(sc_cut_region* region, sc_vec g) {
  const int n = region->count;
  const real in_space = R(1.0606601717798213), in_plane = R(1.1547005383792515);        // n/sqrt(n^2 - 1)
  const real less_space = R(0.29289321881345248), less_plane = R(0.42264973081037424);  // 1 - sqrt((n - 1)/(n + 1))
  const real grows = n == 3 ? in_space : in_plane, less = n == 3 ? less_space : less_plane;
  real part[3], square = R(0);
  for (int k = 0; k < n; ++k) {
    part[k] = sc_dot(region->column[k], g);
    square += part[k] * part[k];
  }
  const real size = SC_SQRT(square);
  if (!(size > R(0))) return R(0);
  sc_vec q = sc_zero_vec();
  for (int k = 0; k < n; ++k) q = sc_add_scaled(q, part[k] / size, region->column[k]);
  region->centre = sc_add_scaled(region->centre, R(-1) / (real)(n + 1), q);
  for (int k = 0; k < n; ++k)
    region->column[k] = sc_scale(grows, sc_add_scaled(region->column[k], -less * (part[k] / size), q));
  return size;
}

/// A point and the larger gauge there.
typedef struct {
  sc_vec point;
  real high;
} sc_cut_point;

/// The point where the larger gauge is least, to rounding. No gauge is above `high` there.
SC_FN sc_cut_point sc_cut_points(sc_growth_pair p, sc_vec start, real high) {
  sc_cut_point best;
  best.point = start;
  best.high = high;
  sc_cut_region region;
  region.count = 3;
  region.centre = p.branch;
  // B, scaled by that, lies in a box, and the box in this ellipsoid.
  const real size = R(1.7320508075688772) * high;
  region.column[0] = sc_turn(p.turn, sc_make_vec(size / p.scale_b.x, R(0), R(0)));
  region.column[1] = sc_turn(p.turn, sc_make_vec(R(0), size / p.scale_b.y, R(0)));
  region.column[2] = sc_turn(p.turn, sc_make_vec(R(0), R(0), size / p.scale_b.z));
  for (int i = 0; i < SC_CUTS_OF_POINTS; ++i) {
    const sc_norm_value a = sc_growth_gauge_a(p, region.centre);
    const sc_norm_value b = sc_growth_gauge_b(p, region.centre);
    const real larger = SC_MAX(a.value, b.value);
    if (larger < best.high) {
      best.high = larger;
      best.point = region.centre;
    }
    if (!(sc_cut(&region, a.value > b.value ? a.gradient : b.gradient) > R(1e-15) * larger)) break;
  }
  return best;
}

/// Looks for the direction with the least support value; the portal keeps it with its bound.
SC_FN void sc_cut_directions(sc_portal* s, sc_growth_pair p) {
  // With the half axes of A as units, no component of the direction is above 1/low.
  const sc_vec scaled = sc_make_vec(p.scale_a.x * p.branch.x, p.scale_a.y * p.branch.y, p.scale_a.z * p.branch.z);
  const real inverse = R(1) / sc_norm(scaled);
  const sc_vec along = sc_scale(inverse, scaled);
  const sc_vec across = sc_perpendicular(along);
  const sc_vec third = sc_cross(along, across);
  const real radius = R(1.7320508075688772) / s->low;
  const sc_vec units[3] = {sc_scale(inverse, along), sc_scale(radius, across), sc_scale(radius, third)};
  sc_vec direction[3];
  for (int k = 0; k < 3; ++k)
    direction[k] = sc_make_vec(p.scale_a.x * units[k].x, p.scale_a.y * units[k].y, p.scale_a.z * units[k].z);
  sc_cut_region region;
  region.count = 2;
  region.centre = direction[0];
  region.column[0] = direction[1];
  region.column[1] = direction[2];
  for (int i = 0; i < SC_CUTS_OF_DIRECTIONS; ++i) {
    const sc_portal_column c = sc_portal_column_of(p, region.centre);
    sc_portal_bound(s, p, region.centre, c);
    if (!(sc_cut(&region, c.difference) > R(1e-15) * c.height)) break;
  }
}

#endif
