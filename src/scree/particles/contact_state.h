// One contact at a time, as the sample and the books look at it: geometry, memory and energy.
#pragma once

#include "scree/particles/system.h"
#include "scree/physics/contact/contact.h"
#include "scree/physics/touch/bodies.h"
#include "scree/physics/touch/body_face.h"
#include "scree/physics/touch/shape_shape.h"
#include "scree/physics/touch/sphere_sphere.h"

namespace scree {

/// From the centre of the owner of candidate pair c to that of the partner, to the nearest image [m].
sc_vec branch_of_pair(const ParticleSystem& system, std::size_t c);

/// How the partners of candidate pair c, of which one is no sphere, meet now, seen from the owner.
sc_shape_touch touch_of_shapes(const ParticleSystem& system, std::size_t c);

/// Of the places where shape p meets the face of its contact w with a wall, the one nearest to where the contact was.
sc_body_gap gap_of_shape(const ParticleSystem& system, std::size_t p, std::int32_t w);

/// How the spheres of candidate pair c meet now, seen from the owner.
sc_sphere_touch touch_of_pair(const ParticleSystem& system, std::size_t c);

/// By how much candidate pair c overlaps [m]; negative when apart.
double overlap_of_pair(const ParticleSystem& system, std::size_t c);

/// By how much particle p overlaps the face of its contact w with a wall [m]; negative when apart.
double overlap_of_wall(const ParticleSystem& system, std::size_t p, std::int32_t w);

/// What candidate pair c remembers.
sc_contact_state state_of_pair(const ParticleSystem& system, std::size_t c);

/// Energy stored in candidate pair c [J]; nothing unless it acts.
sc_contact_energy energy_of_pair(const ParticleSystem& system, std::size_t c);

/// Energy stored in contact w of particle p with a wall [J]; nothing unless it acts.
sc_contact_energy energy_of_wall(const ParticleSystem& system, std::size_t p, std::int32_t w);

}  // namespace scree
