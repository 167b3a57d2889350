// Every way in which two bodies of a case may meet, and how long and how deep such an impact is.
#pragma once

#include <string>
#include <vector>

#include "scree/app/body_kinds.h"
#include "scree/app/sticking.h"
#include "scree/data/materials.h"
#include "scree/input/case.h"

namespace scree {

/// Two bodies that may meet, each the smallest or the largest of its kind, or a body and a wall.
struct Encounter {
  std::string what;  // in words
  std::string wall;  // its name, if it is one with a wall
  sc_pair_law law{};
  double restitution = 1;
  double mass = 0;            // reduced mass [kg]
  double radius = 0;          // effective radius R*, of shapes that of spheres of their volume [m]
  double least_mass = 0;      // that answers anywhere on their surfaces [kg]; of spheres the reduced mass
  ContactAt quickest;         // where an impact by Hertz's law is shortest; of spheres the above
  double smaller_radius = 0;  // of shapes that of the sphere inside [m]
  double reach = 0;           // how far apart the bodies are when linear cohesion begins [m]
};

/// The extremes of every pair of kinds and of every kind with every wall; pairs of two bodies of infinite mass are left
/// out.
std::vector<Encounter> encounters(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds);

/// The encounter of two particles of the mean volume of the most numerous kind with free particles; a second kind
/// takes part if that one has a single particle, a wall if there is no other. `what` is empty if nothing can meet.
Encounter typical_encounter(const Case& c, const Materials& materials, const std::vector<BodyKind>& kinds);

/// How long the bodies touch when they meet with `speed` [s], at the place where that is shortest: a shape that is hit
/// beside its centre gives way by turning, and on a flat face Hertz's contact is stiff. Linear laws: half a damped
/// period, whatever the speed. Hertz: 2.94 delta_max / v. With adhesion at most half the period of the bond, whose
/// stiffness is 6/5 E* a_0 at the contact radius a_0 = (9 pi W R*^2 / (2 E*))^(1/3) of no force. Infinite for Hertz at
/// no speed.
double contact_time(const Encounter& e, const sc_laws& laws, double speed);

/// The longest time step with which the dashpot of such contacts brings a packing to rest [s]; infinite where it is no
/// matter. The dashpot takes its velocity from the past, v_(n-1/2) + (v_(n-1/2) - v_(n-3/2))/2, and the quickest
/// oscillation, which alternates, feels it as twice as strong and turned round: it dies if x^2 + 8 zeta x < 4 / s with
/// x = dt sqrt(k/m) and s the square of its frequency over that of two bodies alone. In the densest packing of equal
/// spheres s is 4. Hertz: contacts at rest are softer than in the impact that the time step goes by; infinite.
double longest_damped_step(const Encounter& e, const sc_laws& laws);

/// Overlap over the smaller radius when they meet with `speed`, from energy alone: dashpots make it smaller. Infinite
/// if linear cohesion is as stiff as the bodies.
double overlap_fraction(const Encounter& e, const sc_laws& laws, double speed);

/// The encounter as an impact under linear cohesion.
CohesiveImpact cohesive_impact(const Encounter& e, const sc_laws& laws);

}  // namespace scree
