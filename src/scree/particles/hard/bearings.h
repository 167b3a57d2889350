// The contacts of the phase of rest as the sweeps read them: in the order of visits, each with the points that bear.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/particles/hard/contacts.h"
#include "scree/physics/impulse/roll.h"

namespace scree {

/// A point that bears.
struct BearingPoint {
  sc_vec arm_a{}, arm_b{};  // from the centres [m]
  sc_vec offset{};  // what is taken off the velocity of A seen from B, of the wall and of what may approach [m/s]
  sc_hold hold{};
  sc_vec held{};    // impulse on A [N s]
  sc_vec before{};  // this one before the present visit [N s]
  sc_vec course{};  // how it has changed from sweep to sweep [N s]
};

/// A contact with its points.
struct Bearing {
  std::int32_t a = 0, b = HardContact::wall;
  std::uint32_t first = 0, count = 0;
};

/// What resists turning in a contact.
struct BearingTurn {
  sc_turn_hold hold{};
  double radius = 0;  // [m]; 0: nothing does
  sc_vec offset{};    // spin of the wall [rad/s]
  sc_vec couple{};    // on A [N m s]
  sc_vec before{};    // this one before the present visit [N m s]
  sc_vec course{};    // how it has changed from sweep to sweep [N m s]
};

/// All of them, in the order of visits.
struct Bearings {
  std::vector<Bearing> all;
  std::vector<BearingPoint> points;
  std::vector<BearingTurn> turns;  // of every contact, or empty
  std::vector<double> change;      // of every contact by the last visit: change times K times change [J]
};

/// Visits a contact once: every point gets the impulse that it needs, twice, since the points of a contact act on the
/// same two bodies. Notes what that changed. Returns the square of the largest speed that it changed [m2/s2].
double visit(HardContacts& contacts, Bearings& bearings, std::size_t k);

}  // namespace scree
