#include "scree/app/sticking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/physics/contact/cohesion/jkr.h"
#include "scree/physics/contact/collision_time.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;

struct Overlap {
  double depth = 0, rate = 0;  // y, y'
};

/// A head-on impact of two adhesive bodies.
struct AdhesiveImpact {
  sc_pair_law law{};
  sc_jkr scales{};
  double radius = 0, mass = 0;  // effective radius [m], reduced mass [kg]
};

/// y'' of the overlap; the plain law may pull, the other one is cut off at zero.
double acceleration(const CohesiveImpact& c, const Overlap& y) {
  const double dashpot = 2 * c.damping * std::sqrt(c.mass * c.stiffness);
  const double repulsion = c.stiffness * y.depth + dashpot * y.rate;
  return (c.cohesion * (c.reach + y.depth) - (c.tension ? repulsion : std::max(0.0, repulsion))) / c.mass;
}

/// y'' of the overlap of two adhesive bodies that have touched; spring and dashpot together never pull.
double acceleration(const AdhesiveImpact& c, const Overlap& y) {
  sc_touch touch{};
  touch.overlap = y.depth;
  touch.radius = c.radius;
  touch.mass = c.mass;
  const sc_normal n = sc_normal_jkr(c.law, touch, c.scales, 1);
  return (n.attraction - std::max(0.0, n.spring + n.damping * y.rate)) / c.mass;
}

/// One step of the classical Runge-Kutta method.
template <class Impact>
Overlap advanced(const Impact& c, const Overlap& y, double h) {
  const auto shifted = [&](double t, double v, double a) { return Overlap{y.depth + t * v, y.rate + t * a}; };
  const double v1 = y.rate, a1 = acceleration(c, y);
  const Overlap y2 = shifted(h / 2, v1, a1);
  const double a2 = acceleration(c, y2);
  const Overlap y3 = shifted(h / 2, y2.rate, a2);
  const double a3 = acceleration(c, y3);
  const Overlap y4 = shifted(h, y3.rate, a3);
  const double a4 = acceleration(c, y4);
  return {y.depth + h / 6 * (v1 + 2 * y2.rate + 2 * y3.rate + y4.rate), y.rate + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}

/// Cohesion that leaves less than a ten-thousandth of the stiffness counts as being as stiff as the bodies.
bool as_stiff(const CohesiveImpact& c) { return c.cohesion > (1 - 1e-4) * c.stiffness; }

/// Whether the neck breaks after an impact.
bool escapes(const AdhesiveImpact& c, double speed) {
  // Stiffness of the bond at rest, 6/5 E* a, or of a faster impact.
  const double bond = std::sqrt(c.mass / (1.2 * c.law.young * c.scales.root * c.scales.root));
  const double step = std::min(bond, sc_hertz_contact_time(c.mass, speed, c.law.young, c.radius)) / 300;
  Overlap y{0, speed};
  bool returning = false;
  while (y.depth > c.scales.broken) {
    y = advanced(c, y, step);
    if (returning && -y.rate < 1e-6 * speed) return false;
    returning = y.rate < 0;
  }
  return true;
}

bool escapes(const CohesiveImpact& c, double speed) {
  const double parting = parting_speed(c, touching_speed(c, speed));
  return parting >= 0 && c.mass * parting * parting > c.cohesion * c.reach * c.reach;
}

/// The least speed at which bodies escape, by bisection; infinite if 2^60 times the guess is not enough.
template <class Impact>
double least_escape(const Impact& c, double guess) {
  double low = 0, high = guess;
  for (int doublings = 0; !escapes(c, high); ++doublings) {
    if (doublings == 60) return std::numeric_limits<double>::infinity();
    low = high;
    high *= 2;
  }
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (escapes(c, middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double touching_speed(const CohesiveImpact& c, double speed) {
  return std::sqrt(speed * speed + c.cohesion * c.reach * c.reach / c.mass);
}

double parting_speed(const CohesiveImpact& c, double touching) {
  if (as_stiff(c)) return -1;
  const double step = std::sqrt(c.mass / (c.stiffness - c.cohesion)) / 500;
  Overlap y{0, touching};
  bool returning = false;
  for (;;) {
    const Overlap next = advanced(c, y, step);
    if (next.depth <= 0) break;
    if (returning && next.rate >= 0) return -1;
    returning = next.rate < 0;
    // A strongly damped approach to rest has no turning point; it ends where it no longer moves.
    if (returning && -next.rate < 1e-9 * touching) return -1;
    y = next;
  }
  double early = 0, late = step;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (early + late);
    (advanced(c, y, middle).depth > 0 ? early : late) = middle;
  }
  return -advanced(c, y, early).rate;
}

double sticking_speed(const CohesiveImpact& c) {
  if (c.cohesion <= 0 || c.reach <= 0 || c.damping <= 0) return 0;
  if (as_stiff(c)) return std::numeric_limits<double>::infinity();
  return least_escape(c, c.reach * std::sqrt(c.cohesion / c.mass));
}

double stickiness_number(const CohesiveImpact& c, double speed) {
  const double bond = c.reach * c.reach * c.cohesion;
  return std::sqrt(bond) / (c.restitution * std::sqrt(bond + c.mass * speed * speed));
}

double pull_off_force(double adhesion, double radius) { return 1.5 * pi * adhesion * radius; }

double adhesive_sticking_speed(const sc_pair_law& law, double radius, double mass) {
  if (law.adhesion <= 0) return 0;
  return least_escape(AdhesiveImpact{law, sc_jkr_scales(law, radius), radius, mass},
                      elastic_sticking_speed(law.adhesion, radius, law.young, mass));
}

double elastic_sticking_speed(double adhesion, double radius, double young, double mass) {
  const double scale = std::pow(adhesion, 5) * std::pow(radius, 4) / (young * young);
  return std::sqrt(14.18 / mass) * std::pow(scale, 1.0 / 6.0);
}

}  // namespace scree
