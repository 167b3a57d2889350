// Where a body may be hit, and what answers there: what an impact of shapes lasts.
#pragma once

#include <vector>

#include "scree/data/forms.h"

namespace scree {

/// A place of a body's surface. An impulse along the normal n at the arm r meets 1/m + (r x n).I^-1 (r x n).
struct ContactPlace {
  double response = 1;  // that, times the mass m: 1 where the normal goes through the centre
  double radius = 1;    // effective radius against a plane, with the factor of elongated contacts, over that by volume
};

/// The places of a form where impacts may be shortest: whatever answers more than all others that are as flat. Found
/// on a grid of the surface, so that the response is short of the greatest by less than three thousandths. Of the
/// sphere one.
std::vector<ContactPlace> quickest_places(const Form& form);

/// Those places of some that neither answer less nor are rounder than another, the greatest response first.
std::vector<ContactPlace> quickest_of(std::vector<ContactPlace> places);

/// The reduced mass [kg] and the effective radius [m] of an impact at the places of two bodies.
struct ContactAt {
  double mass = 0, radius = 0;
};

/// A body that may be hit at some places; `inverse_mass` [1/kg], `radius` by volume [m].
struct HitBody {
  const std::vector<ContactPlace>* places;
  double inverse_mass, radius;
};

/// The least mass that two bodies, or a body and a wall (`second` is null), can meet each other with [kg].
double least_mass(const HitBody& first, const HitBody* second);

/// Where an impact by Hertz's law is shortest: the least mass^2/radius, which the fifth power of the duration goes
/// with.
ContactAt quickest_hertz(const HitBody& first, const HitBody* second);

}  // namespace scree
