// The contact of two shapes as the laws see it: from a potential of the growth distance alone.
//
// With the overlap along the normal, (1 - growth) H, and the distance l of the centres along it where the bodies just
// touched when they met, the laws act on the overlap (l/H)(1 - growth) H = (1 - growth) l. Its energy depends on
// positions and orientations only, so force and torques are its derivatives and an elastic contact gives back what it
// took (Perram and Wertheim 1985 for the growth distance). The effective radius is kept from the first touch for the
// same reason. In the overlap along the normal the laws are as they are, with constants times powers of l/H.
//
// Cohesion acts on the same overlap, which goes on below zero where bodies are apart: (1 - growth) l is then how far
// either has to come towards the other for them to touch, along the normal at which they would after growing.
#ifndef SCREE_PHYSICS_TOUCH_SHAPE_CONTACT_H
#define SCREE_PHYSICS_TOUCH_SHAPE_CONTACT_H

#include "scree/physics/contact/cohesion/jkr.h"
#include "scree/physics/contact/contact.h"
#include "scree/physics/touch/bodies.h"
#include "scree/physics/touch/contact_radius.h"
#include "scree/physics/touch/shape_shape.h"

/// Bounds of the radii of curvature over the radius by volume: flat faces have infinite ones, edges none.
#define SC_LARGEST_CURVATURE_RADIUS R(10)
#define SC_LEAST_CURVATURE_RADIUS R(1e-4)

/// What a pair of shapes remembers between steps besides what the laws do.
typedef struct {
  sc_growth_point start;  // where the solver ended
  real reach;             // l [m]; 0 before the first touch
  real radius;            // effective radius R* [m]
} sc_shape_memory;

/// What a pair that touches for the first time will remember. `by_volume_...`: radii by volume [m]. The radius counts
/// the factor of elongated contacts.
SC_FN sc_shape_memory sc_shapes_meet(sc_body_shape first, sc_body_shape second, sc_shape_touch touch, real by_volume_a,
                                     real by_volume_b) {
  const real least = SC_LEAST_CURVATURE_RADIUS * SC_MIN(by_volume_a, by_volume_b);
  const real most = SC_LARGEST_CURVATURE_RADIUS * SC_MAX(by_volume_a, by_volume_b);
  const sc_contact_radius radius = sc_contact_radius_of_bodies(first, second, touch.normal, least, most);
  sc_shape_memory out;
  out.start = touch.start;
  out.reach = touch.support;
  out.radius = radius.radius * radius.factor * radius.factor;
  return out;
}

/// The place of the contact. Bodies that are out of reach or only graze it do not overlap.
SC_FN sc_contact_place sc_place_of_shapes(sc_shape_touch touch, real radius) {
  sc_contact_place p;
  p.normal = touch.normal;
  p.overlap = touch.verdict == SC_GROWTH_TOUCHING ? touch.overlap : SC_MIN(touch.overlap, R(0));
  p.arm_a = touch.arm;
  p.arm_b = touch.arm_second;
  p.radius = radius;
  return p;
}

/// The constants of the laws for the overlap along the normal, where the potential goes with `ratio` = l/H times it: a
/// linear spring has ratio^2 times the stiffness, Hertz's ratio^(5/2) times the modulus, and in a neck surfaces hold
/// each other with ratio times the work. Effect surfaces have 1/ratio times the excess.
SC_FN sc_pair_law sc_law_of_growth(sc_pair_law law, real ratio) {
  sc_pair_law out = law;
  out.stiffness = law.stiffness * (ratio * ratio);
  out.young = law.young * (ratio * ratio * SC_SQRT(ratio));
  out.cohesion_stiffness = law.cohesion_stiffness * (ratio * ratio);
  out.adhesion = law.adhesion * ratio;
  return out;
}

/// l/H, or 1 where there is no distance l to refer to: before the first touch, and with vertices.
SC_FN real sc_growth_ratio(real reach, sc_shape_touch touch) { return reach > R(0) ? reach / touch.support : R(1); }

/// The growth distance up to which it matters how two bodies meet. `acted`: they did in the step before, and are
/// followed to where that ends; `excess`: of the effect surfaces over both bodies [m]. A neck begins with a touch.
SC_FN real sc_growth_limit(sc_laws laws, sc_body_shape first, sc_body_shape second, int acted, real excess) {
  if (laws.cohesion == SC_COHESION_NONE) return R(1);
  if (acted) return SC_GROWTH_ANY;
  if (laws.cohesion == SC_COHESION_JKR) return R(1);
  // No support of both bodies is shorter than that of the spheres inside.
  const real least = first.radius * first.form.inscribed + second.radius * second.form.inscribed;
  return R(1) + (R(1) + R(1e-9)) * excess / least;
}

/// The largest effective radius that a contact of a body can have, with walls or others no larger than it [m].
/// `by_volume`: its radius by volume [m].
SC_FN real sc_largest_contact_radius(real by_volume) {
  const real factor = sc_elongation_factor(R(100));
  return SC_LARGEST_CURVATURE_RADIUS * by_volume * factor * factor;
}

/// How far a neck can be drawn out, as an overlap, for a contact radius up to `radius` [m]; nothing without adhesion.
SC_FN real sc_longest_neck(sc_laws laws, sc_pair_law law, real radius) {
  const int necks = laws.cohesion == SC_COHESION_JKR && law.adhesion > R(0);
  return necks ? -sc_jkr_scales(law, radius).broken : R(0);
}

/// The bounding radius of a body that has grown until a wall which still acts on it touches it [m]. `excess`: of its
/// effect surface [m].
SC_FN real sc_reach_at_wall(sc_laws laws, sc_pair_law law, sc_body_shape body, real by_volume, real excess) {
  if (laws.cohesion == SC_COHESION_NONE) return body.radius;
  const real neck = sc_longest_neck(laws, law, sc_largest_contact_radius(by_volume));
  return body.radius + (laws.cohesion == SC_COHESION_LINEAR ? excess : neck) / body.form.inscribed;
}

/// How far apart two bodies are at least along a direction (unit, from the first to the second) [m].
SC_FN real sc_shapes_gap(sc_body_shape first, sc_body_shape second, sc_vec branch, sc_vec normal) {
  const real reach = sc_support_in_world(first, normal).value + sc_support_in_world(second, normal).value;
  return sc_dot(normal, branch) - reach - R(1e-12) * (first.radius + second.radius);
}

#endif
