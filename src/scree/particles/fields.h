// What acts on particles at their places besides contacts: body forces and the velocity of a prescribed flow.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scree/base/expression.h"
#include "scree/compute/buffer.h"
#include "scree/data/particles.h"
#include "scree/kernels/fields.h"
#include "scree/particles/fluid_forces.h"
#include "scree/particles/sweep_view.h"

namespace scree {

/// Three formulas of x, y, z [m] and t [s].
using VectorExpression = std::array<Expression, 3>;

enum class BodyForce { none, uniform, central, expression, rotating };
enum class FlowKind { none, still, uniform, taylor_green, shear, expression };

/// Gravity and flow of a case. Members that a kind does not use are ignored.
struct Fields {
  BodyForce body = BodyForce::none;
  sc_vec uniform{};               // gravity, also in a rotating frame [m/s2]
  sc_vec center{};                // the attracting point, or a point on the axis of the frame [m]
  double strength = 0;            // G M [m3/s2]
  sc_vec angular_velocity{};      // of the frame at t = 0 [rad/s]
  sc_vec angular_acceleration{};  // [rad/s2]
  std::optional<VectorExpression> acceleration;

  FlowKind flow = FlowKind::none;
  sc_vec stream{};          // [m/s]
  double amplitude = 0;     // Taylor-Green A [m/s]
  double wavenumber = 0;    // Taylor-Green a [1/m]
  double shear_rate = 0;    // [1/s]
  double shear_origin = 0;  // [m]
  std::optional<VectorExpression> velocity;

  int drag = 0;           // SC_DRAG_...
  double density = 0;     // of the fluid [kg/m3]
  double viscosity = 0;   // of the fluid [Pa s]
  bool buoyancy = false;  // the fluid carries its part of the weight in uniform gravity
  FluidForces forces;     // beyond the drag of spheres
  double interval = 0;    // over which the change of the flow with time is taken [s]
};

/// True if some particle needs more than uniform gravity.
bool act_locally(const Fields& fields);

/// True if a field may be no finite number somewhere.
bool may_fail(const Fields& fields);

/// The kinds and their numbers as the text that is common to all devices wants them (kernels/fields.h).
int body_force_number(const Fields& fields);
int flow_number(const Fields& fields);
sc_body_force body_force_of(const Fields& fields, double time);
sc_flow flow_of(const Fields& fields);

/// Angular velocity of the frame at time t [rad/s].
sc_vec frame_rotation(const Fields& fields, double time);

/// The torques of a prescribed flow act on all particles for `dt` [s] at the places and orientations they have; whether
/// there are any.
bool turn_by_flow(const Fields& fields, Particles& particles, double time, double dt);

/// Velocity of the undisturbed flow at a point [m/s]; zero without a flow.
std::array<double, 3> flow_velocity(Fields& fields, const double* position, double time);

/// Fills out[p] for every particle with what acts at its place at `time`. Coriolis forces depend on the velocity and
/// are part of the motion (sc_move), not of the field.
void evaluate(const Fields& fields, const Particles& particles, double time, const SweepKernels& kernels,
              Buffer<sc_field>& out);

}  // namespace scree
