// Particles as the narrow phase of shapes wants them.
#pragma once

#include "scree/data/forms.h"
#include "scree/data/particles.h"
#include "scree/physics/rotation.h"
#include "scree/physics/touch/body_face.h"

namespace scree {

/// Whether particle i is one.
inline bool is_sphere(const Particles& particles, std::size_t i) {
  return !particles.shaped() || particles.form[i] == 0;
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

}  // namespace scree
