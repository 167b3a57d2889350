// The contacts of one step of the hard model: who touches whom, and where.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/particles/system.h"
#include "scree/physics/impulse/hold.h"

namespace scree {

/// A body as impulses see it, in the frame of the world.
struct HardBody {
  sc_vec velocity{}, spin{};  // [m/s], [rad/s]
  double inverse_mass = 0;    // [1/kg]; 0: nothing moves it
  sc_mat inverse_inertia{};   // [1/(kg m2)]
};

/// One point at which two bodies touch, or a body and a wall. A is the particle with the lower id.
struct HardContact {
  static constexpr std::int32_t wall = -1;

  std::int32_t a = 0, b = wall;              // places of the particles
  std::int32_t memory = 0;                   // place among the pairs, or among the contacts with walls
  std::int32_t face = -1;                    // of a wall
  std::int64_t low = 0, high = 0;            // key: ids; number of the face
  bool began = false;                        // did not touch one step before
  bool slid = false;                         // slid at the end of the step before
  bool left_alone = false;                   // in the middle of a step: it will be a collision
  sc_impact_law law{};                       // of the two materials
  sc_vec push{};                             // unit normal from B to A
  sc_vec arm_a{}, arm_b{};                   // from the centres to the point [m]
  double overlap = 0, smaller = 0;           // [m]; radius of the smaller body [m]
  sc_vec surface{};                          // velocity of the wall at the point [m/s]
  sc_hold hold{};                            // response and what follows from it
  sc_vec struck{}, held{};                   // impulses on A of the collision and of the rest of this step [N s]
  double approach = 0;                       // speed at which the two met [m/s]
  double lost_normal = 0, lost_sliding = 0;  // in the present phase [J]

  bool at_wall() const { return b == wall; }
};

/// All contacts in the order of their keys, pairs before walls; and the order in which sweeps visit them: colour by
/// colour, none of which has two contacts of one body that can move.
struct HardContacts {
  Team team{1};                             // shares the contacts of a colour
  std::vector<HardBody> bodies;             // of all particles
  std::vector<HardContact> all;             // by key
  std::vector<std::uint32_t> order;         // by colour, then by key
  std::vector<std::uint32_t> colour_first;  // places in `order`, and the end
  bool leftover = false;                    // the last colour holds what no other one took: to be visited in its order
};

/// Finds all pairs and walls that touch at the present places, and remembers that in the contacts of the system.
void find_hard_contacts(ParticleSystem& system, ContactLists& lists, HardContacts& out);

/// Velocity of A at the contact point, seen from B [m/s].
inline sc_vec contact_velocity(const std::vector<HardBody>& bodies, const HardContact& c) {
  const HardBody& a = bodies[c.a];
  const sc_vec at_a = sc_add(a.velocity, sc_cross(a.spin, c.arm_a));
  if (c.at_wall()) return sc_sub(at_a, c.surface);
  const HardBody& b = bodies[c.b];
  return sc_sub(at_a, sc_add(b.velocity, sc_cross(b.spin, c.arm_b)));
}

/// K of both bodies.
inline sc_mat contact_response(const HardContacts& h, const HardContact& c) {
  const HardBody& a = h.bodies[c.a];
  const sc_mat mine = sc_response(a.inverse_mass, a.inverse_inertia, c.arm_a);
  if (c.at_wall()) return mine;
  const HardBody& b = h.bodies[c.b];
  return sc_add_mat(mine, sc_response(b.inverse_mass, b.inverse_inertia, c.arm_b));
}

/// Gives A an impulse and B its opposite. Bodies that nothing moves are not touched: another thread may read them.
inline void give(HardContacts& h, const HardContact& c, sc_vec impulse) {
  const auto hit = [](HardBody& body, sc_vec arm, sc_vec p) {
    if (body.inverse_mass == 0) return;
    body.velocity = sc_add_scaled(body.velocity, body.inverse_mass, p);
    body.spin = sc_add(body.spin, sc_turn(body.inverse_inertia, sc_cross(arm, p)));
  };
  hit(h.bodies[c.a], c.arm_a, impulse);
  if (!c.at_wall()) hit(h.bodies[c.b], c.arm_b, sc_scale(-1, impulse));
}

}  // namespace scree
