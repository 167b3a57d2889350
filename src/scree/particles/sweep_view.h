// What one pass over the contacts reads and writes, as plain pointers.
//
// The pass is compiled once per instruction set (sweep_isa.cpp); nothing it includes may be library code with external
// linkage, or the linker could give the code of the newest instruction set to everybody.
#pragma once

#include <cstdint>

#include "scree/kernels/move_sphere.h"
#include "scree/physics/contact/contact.h"
#include "scree/physics/shape/form.h"
#include "scree/physics/touch/sphere_wall.h"

namespace scree {

/// Largest number of candidates in a tile, unless one particle alone owns more.
inline constexpr std::int32_t tile_size = 96;

/// What the list of contacts says of one in a byte: bit 0, it acted at the last evaluation; bit 1, it slid then.
constexpr std::uint8_t contact_code(bool acted, bool slid) {
  return static_cast<std::uint8_t>(acted ? 1 + 2 * static_cast<int>(slid) : 0);
}

/// Numbers that a contact of a shape with a particle or with a wall remembers besides, and the first of those that do
/// not last (of a pair those are free: its numbers fill a cache line).
inline constexpr int pair_memory = 8, pair_scratch = 6;
inline constexpr int wall_memory = 12, wall_scratch = 8;

/// Contacts with walls: those of particle p are first[p] ... first[p + 1] - 1, in the order of walls. They are
/// evaluated one by one and added after the contacts with particles.
struct WallView {
  const std::int32_t* first;
  const std::int32_t* wall;
  std::uint8_t* active;  // contact_code()
  double* slide;         // [contacts][4]: stretch x y z, approach
  double* roll;          // [contacts][4]: roll x y z, twist
  const sc_wall* shape;
  const sc_wall_pose* pose;  // of each wall of the case
  sc_wall_gap* gap;          // [contacts], written: the way to the wall
  double* load;              // [contacts][8] or null, written: force on the wall x y z, moment about its pivot x y z
  double* shape_memory;      // [contacts][wall_memory]: WallContacts::shape; null in a system of spheres
};

/// The vertices of a form in blocks of eight: data/vertices.h.
struct VertexView {
  const double* points;
  const double* spheres;
  int blocks;
  unsigned last;  // lanes of the last block that are no copies, a bit each
};

/// Most vertices of a form: 100 by 100.
inline constexpr int most_vertices_side = 100, most_vertex_blocks = most_vertices_side * most_vertices_side / 8;

/// What particles of any shape have besides; all null in a system of spheres.
struct ShapeView {
  const sc_form* forms;
  const std::int64_t* id;    // [n]: a pair is looked at from the lower
  const std::int32_t* form;  // [n]
  double* orientation;       // [n][4]
  double* angular_momentum;  // [n][4]
  const double* inertia;     // [n][4]
  double* memory;            // [pairs][pair_memory]: PairContacts::shape
  double* apart;             // [pairs]: PairContacts::apart
  // Which slots hold anything, for each gather entry of a particle, in blocks of eight: 0 or 1.
  std::uint8_t* full;
  const std::int32_t* mark_first;  // [n]: where those of a particle begin
  const std::int32_t* mark;        // [pairs][2]: that of the owner's entry, and of the partner's
  const VertexView* vertices;      // of the forms: contacts are found by these; null: by the growth distance
};

/// Numbers in a slot: of spheres, and of bodies of any shape, whose torques are not the same for both partners.
inline constexpr int sphere_slot = 8, shape_slot = 12;

struct SweepView {
  // particles
  double* motion;               // [n][8]
  double* spin;                 // [n][4]
  const double* effect_excess;  // [n]
  const std::int32_t* material;
  std::int32_t* image;      // [n][4]
  double* loss;             // [n][4]
  double* work;             // [n][4]
  double* impulse;          // [n][4]
  double* angular_impulse;  // [n][4]
  double* drag_impulse;     // [n][4] or null: Particles::drag_impulse
  ShapeView shapes;
  // pairs
  const std::int32_t* first;
  const std::int32_t* owner;
  const std::int32_t* partner;
  std::uint8_t* active;  // contact_code()
  double* slide;         // [pairs][4]: stretch x y z, approach
  double* roll;          // [pairs][4] or null: roll x y z, twist
  WallView walls;
  // plan
  const std::int32_t* slot;
  const std::int32_t* gather_first;
  const std::uint32_t* gather;
  const std::uint8_t* deferred;
  // Spheres: [slots][8]: force x y z on the owner, loss normal | lever * (normal x force) x y z, loss sliding.
  // Any shape: [slots][12]: force on the owner, loss normal | torque on the owner, loss sliding | torque on the
  // partner, loss rolling; no couples; where nothing acts the slot keeps what it held (ShapeView::full).
  double* slots;
  double* couples;  // [slots][4]: couple x y z on the owner, loss rolling; or null
  // laws
  sc_laws laws;
  const sc_pair_law* law;  // [materials][materials]
  int materials;
  sc_contact_time time;
  double shortest_period;            // of the domain [m]; infinite if none is periodic
  double margin;                     // how far apart bodies may be and still act on each other [m]
  double period[4], half_period[4];  // a fourth, neutral entry fills the vector
  // motion
  sc_move move;
  const sc_field* field;   // [n] or null: body acceleration and fluid velocity at each particle
  double* force;           // [n][4] or null: total contact force on each particle, written
  bool others;             // fields, or rotation of the frame: no particle moves freely
  bool book_gravity;       // book the angular impulse of uniform gravity (its work and impulse are known without)
  double low[3], high[3];  // the domain
};

/// Measured speeds are summed as integers, so that the sum does not depend on the order.
inline constexpr double speed_quantum = 0x1p-40;  // [m/s]

/// What a pass found out, for the guards and the series.
struct SweepFindings {
  double fastest2 = 0;             // largest speed squared [m2/s2]
  double deepest = 0;              // largest overlap over the smaller radius, of shapes that of the sphere inside [-]
  std::int64_t contacts = 0;       // pairs and walls that acted
  std::int64_t wall_contacts = 0;  // of these with walls
  std::int64_t impacts = 0;        // pairs that began to act
  std::int64_t impact_speed = 0;   // sum of their approach speeds [speed_quantum]
  bool sound = true;               // all speeds are numbers
  bool inside = true;              // nobody has left the domain
};

/// One thread's part of a pass: all pairs of the owners in tiles [0, count), then the motion of those particles that
/// no other range shares; and the motion of the shared ones, after every thread has done its part. Before the pass,
/// the fluid velocity of Taylor-Green vortices at particles [begin, end).
struct SweepKernels {
  void (*advance)(const SweepView&, const std::int32_t* tiles, int count, SweepFindings&);
  void (*advance_deferred)(const SweepView&, const std::int32_t* particles, int count, SweepFindings&);
  void (*taylor_green)(const double* motion, double amplitude, double wavenumber, std::int64_t begin, std::int64_t end,
                       sc_field*);
  const char* name;
};

}  // namespace scree
