// What the kernels on a device are told, by value, and what they report: the same layout for host and device.
#ifndef SCREE_KERNELS_OPENCL_PARAMETERS_H
#define SCREE_KERNELS_OPENCL_PARAMETERS_H

#include "scree/kernels/box.h"
#include "scree/kernels/fields.h"
#include "scree/kernels/move_sphere.h"
#include "scree/kernels/region.h"
#include "scree/physics/contact/contact.h"

#if defined(__OPENCL_VERSION__) || defined(SCREE_DEVICE)
typedef long sc_count;
#else
typedef long long sc_count;
#endif

/// An entry of a list: the partner or the face, and contact_code() in the two highest bits.
#define SC_PARTNER 0x3fffffffu
#define SC_CODE_SHIFT 30

/// Steps that may be given to a device before the host looks.
#define SC_MOST_GIVEN 32

/// Numbers that one item adds up in a scan; a group of SC_GROUP items does a block of them.
#define SC_SCAN_OWN 16

/// Where what acts besides contacts is found: nowhere, in the step itself, or by a kernel of its own before the step.
enum { SC_FIELDS_NONE = 0, SC_FIELDS_HERE = 1, SC_FIELDS_APART = 2 };

/// What is around the particles.
typedef struct {
  sc_body_force force;      // its rotation is that of the move
  sc_flow flow;             // prescribed
  real density, viscosity;  // of the fluid [kg/m3], [Pa s]
  real interval;            // over which the change of a flow with time is taken [s]
  real now;                 // time of the positions [s]
} sc_surroundings;

/// The cells that particles are sorted into; who is beyond them belongs to the outermost.
typedef struct {
  real from[3], width[3];                     // where they begin, and how wide one is [m]
  real middle[3], period[3], half_period[3];  // of the axis; who is there in several periods is where he is nearest to
                                              // the middle
  int count[3];                               // along each axis
  int around[3];                              // the first one comes after the last
} sc_cells;

/// How many there are.
typedef struct {
  int particles, room;  // room: contacts that a particle has place for
  int materials, faces, walls;
  int unused;  // keeps what follows aligned
} sc_counts;

/// Bodies whose motion is prescribed: ids that follow each other, and the number of the first among all such bodies.
typedef struct {
  sc_count first, count, number;
} sc_body_group;

/// The constants of a step.
typedef struct {
  sc_box box;
  sc_move move;
  sc_contact_time time;
  sc_surroundings around;
  sc_counts counts;
  real margin;        // how far apart bodies may be and still act on each other [m]
  real stale_square;  // lists hold while nobody has gone further than the root of this [m2]
  real max_overlap;   // over the smaller radius; a deeper one halts
  int book_gravity;   // book the angular impulse of uniform gravity
  int unused;         // keeps what follows aligned
} sc_device_step;

/// What one group of work items has found: of the last step, and of all since the host has asked.
typedef struct {
  real fastest_square;                       // last step [m2/s2]
  real deepest;                              // last step: largest overlap over the smaller radius
  sc_count contacts, wall_contacts;          // last step
  sc_count all_contacts, all_wall_contacts;  // summed over steps
  sc_count impacts, impact_speed;            // summed over steps; speeds in SC_SPEED_QUANTUM
  int unsound, outside;                      // in some step: a speed that is no number, a particle out of the box
} sc_findings;

/// Measured speeds are summed as integers, so that the sum does not depend on the order [m/s].
#define SC_SPEED_QUANTUM R(9.094947017729282e-13)

#endif
