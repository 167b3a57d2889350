// A norm of a vector with its derivatives: what the gauge and the support function of every shape give.
#ifndef SCREE_PHYSICS_SHAPE_NORM_VALUE_H
#define SCREE_PHYSICS_SHAPE_NORM_VALUE_H

#include "scree/physics/vec.h"

/// Value and gradient; the Hessian is inner_bend i i^T + outer_bend o o^T. (That of a norm in space has rank two.)
typedef struct {
  real value;
  sc_vec gradient;
  real inner_bend, outer_bend;
  sc_vec inner, outer;
} sc_norm_value;

/// What nothing has: zero throughout.
SC_FN sc_norm_value sc_no_norm_value(void) {
  sc_norm_value out;
  out.value = out.inner_bend = out.outer_bend = R(0);
  out.gradient = out.inner = out.outer = sc_zero_vec();
  return out;
}

#endif
