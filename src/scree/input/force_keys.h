// The keys of what a fluid does to particles besides drag: the same words for flows that are given and that are solved.
#pragma once

#include "scree/input/key.h"

namespace scree {

/// For the keys S of a table, which are FluidForceKeys, too.
template <class S>
std::vector<Key> fluid_force_keys() {
  const std::vector<std::string> choice = {"auto", "on", "off"};
  return {key<S, std::string>("shape_lift", &S::shape_lift,
                              "lift by shape: across the flow, of bodies that are inclined to it; auto: with drag that "
                              "goes by shape and orientation")
              .one_of(choice),
          key<S, std::string>("pitching_torque", &S::pitching_torque,
                              "torque of the flow past bodies, which turns them broadside; auto: with drag that goes "
                              "by shape and orientation beyond creeping flow")
              .one_of(choice),
          key<S, std::string>("viscous_torque", &S::viscous_torque,
                              "torque of vorticity and strain against the body's own rotation (Jeffery 1922; of "
                              "spheres Stokes and Dennis et al. 1980); auto: with drag that goes by shape")
              .one_of(choice),
          key<S, bool>("saffman", &S::saffman,
                       "lift of particles in a sheared flow (Saffman 1965, Mei 1992), on the sphere of equal volume"),
          key<S, bool>(
              "magnus", &S::magnus,
              "lift of particles that spin (Rubinow and Keller 1961, Lun and Liu 1997), on the sphere of equal volume"),
          key<S, bool>("added_mass", &S::added_mass,
                       "the fluid that particles push aside is accelerated with them: half of their volume for "
                       "spheres, more among others; what is much lighter than the fluid needs it")};
}

}  // namespace scree
