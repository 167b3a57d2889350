// Particles as the narrow phase of shapes wants them.
#pragma once

#include "scree/data/forms.h"
#include "scree/data/particles.h"
#include "scree/physics/rotation.h"
#include "scree/physics/touch/body_wall.h"
#include "scree/physics/touch/shape_shape.h"

namespace scree {

/// Whether particle i is one.
inline bool is_sphere(const Particles& particles, std::size_t i) {
  return !particles.shaped() || particles.form[i] == 0;
}

/// Radius of a sphere inside particle i; of a sphere its own. Who overlaps by that much may come out on the other side.
inline double inscribed_radius(const Particles& particles, std::size_t i, const Forms& forms) {
  const double radius = particles.motion.row(i)[lane::radius];
  return is_sphere(particles, i) ? radius : radius * forms[static_cast<std::size_t>(particles.form[i])].shape.inscribed;
}

inline sc_quat orientation_of(const Particles& particles, std::size_t i) {
  const double* q = particles.orientation.row(i);
  return sc_make_quat(q[0], q[1], q[2], q[3]);
}

/// A particle of any shape in the world.
inline sc_body_shape body_shape(const Particles& particles, std::size_t i, const Forms& forms) {
  return {forms[static_cast<std::size_t>(particles.form[i])].shape, particles.motion.row(i)[lane::radius],
          sc_quat_mat(orientation_of(particles, i))};
}

/// sc_touch_shapes_within and sc_body_to_wall as functions that are called: the search is long, and only the pass over
/// the contacts asks so often that it is worth having in place.
sc_shape_touch touch_shapes(const sc_body_shape& first, const sc_body_shape& second, const sc_vec& branch, bool warm,
                            const sc_growth_point& start, double limit = 1);
int body_to_wall(const sc_wall& wall, const sc_wall_pose& pose, const sc_body_shape& body, const sc_vec& centre,
                 double reach, sc_body_gap gaps[SC_FRUSTUM_GAPS]);

}  // namespace scree
