// What makes the sweeps of the phase of rest converge: the changes of sweeps, taken as conjugate directions.
//
// Silcowitz, Niebe and Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for interactive contact force
// problems", Visual Computer 26:893: a sweep of projected Gauss-Seidel is a step along a gradient, and Fletcher and
// Reeves' formula says how far to go on along the steps before. Gradients are measured in the energy of the change, the
// one in which a contact's visit is the gradient.
#pragma once

#include <vector>

#include "scree/particles/hard/bearings.h"

namespace scree {

class Course {
 public:
  /// Before the first sweep.
  explicit Course(const HardContacts& contacts);

  /// After a sweep, if another one follows: carries impulses and bodies on along the course.
  void go_on(HardContacts& contacts, Bearings& bearings);

 private:
  struct Motion {
    sc_vec velocity{}, spin{};
  };

  void move_bodies(HardContacts& contacts, double share, bool again);

  std::vector<Motion> before_, course_;
  double last_ = 0;  // size of the change by the sweep before, squared
};

}  // namespace scree
