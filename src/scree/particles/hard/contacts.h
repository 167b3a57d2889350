// The contacts of one step of the hard model: who touches whom, and where.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scree/particles/hard/telling.h"
#include "scree/particles/system.h"
#include "scree/physics/impulse/impact.h"
#include "scree/physics/impulse/roll.h"

namespace scree {

/// A body as impulses see it, in the frame of the world.
struct HardBody {
  sc_vec velocity{}, spin{};  // [m/s], [rad/s]
  double inverse_mass = 0;    // [1/kg]; 0: nothing moves it
  sc_mat inverse_inertia{};   // [1/(kg m2)]
};

/// At most so many points bear a flat contact.
inline constexpr int hard_feet = 4;

/// One point of a contact.
struct HardPoint {
  sc_vec arm_a{}, arm_b{};  // from the centres [m]
  sc_vec surface{};         // velocity of the wall there [m/s]
  double overlap = 0;       // [m]
  double leave = 0;         // speed at which it may approach, because it is less deep than others [m/s]
  bool left_alone = false;  // in the middle of a step: it will be a collision
  sc_mat response{};        // K of both bodies, in collisions [1/kg]
  sc_vec struck{}, held{};  // impulses on A of the collision and of the rest of this step [N s]
};

/// Two bodies that touch, or a body and a wall. A is the particle with the lower id. The first point is where they
/// touch; a flat contact has that in the middle, and feet besides.
struct HardContact {
  static constexpr std::int32_t wall = -1;

  std::int32_t a = 0, b = wall;    // places of the particles
  std::int32_t memory = 0;         // place among the pairs, or among the contacts with walls
  std::int32_t face = -1;          // of a wall
  std::int64_t low = 0, high = 0;  // key: ids; number of the face
  bool began = false;              // did not touch one step before
  bool slid = false;               // slid at the end of the step before
  std::int8_t points = 1;          // how many there are
  sc_impact_law law{};
  sc_turn_law turning{};                  // of the two materials
  sc_vec push{};                          // unit normal from B to A
  sc_vec along{};                         // a direction across, of a flat contact
  bool known = false;                     // the search that found it says where it is:
  sc_vec arm_a{}, arm_b{};                // from the centres [m]
  double overlap = 0, smaller = 0;        // [m]; radius of the smaller body [m]
  double radius = 0;                      // effective, where something resists turning [m]
  sc_vec wall_spin{};                     // [rad/s]
  sc_vec struck{}, held{};                // sums over the points [N s]
  sc_vec struck_couple{}, held_couple{};  // on A, against rolling and twisting [N m s]
  double lean[2] = {0, 0};                // of the loads held by feet: their moments along and across [N s m]
  double twist = 0;                       // moment about the normal of what holds feet across [N s m]
  double rolled[2] = {0, 0};              // couple against rolling that holds, in the plane of the contact [N m s]
  double approach = 0;                    // speed at which the two met [m/s]
  double lost_normal = 0, lost_sliding = 0, lost_rolling = 0;  // in the present phase [J]

  bool at_wall() const { return b == wall; }
  bool resists_turning() const { return turning.rolling > 0 || turning.twisting > 0; }
  /// The point that bears in the phase of rest first: feet bear in place of the middle.
  int first_bearing() const { return points > 1 ? 1 : 0; }
};

/// All contacts in the order of their keys, pairs before walls; and the order in which sweeps visit them: colour by
/// colour, none of which has two contacts of one body that can move.
struct HardContacts {
  Team team{1};                             // shares the contacts of a colour
  Ranks ranks;                              // share the bodies
  std::size_t own = 0;                      // bodies of this rank; copies of others stand behind
  std::vector<HardBody> bodies;             // of all particles held
  std::vector<HardContact> all;             // by key
  std::vector<HardPoint> points;            // of every contact, with room for as many as a contact may have
  std::vector<std::uint32_t> order;         // by colour, then by key
  std::vector<std::uint32_t> colour_first;  // places in `order`, and the end
  Telling all_copies;                       // who is told of whom by whom
  std::vector<Telling> before_colour;       // the same of those whom the contacts of two ranks in a colour move
  int room = 1;                             // for points of a contact: one among spheres

  std::span<HardPoint> points_of(const HardContact& c) {
    return {&points[static_cast<std::size_t>(room * (&c - all.data()))], static_cast<std::size_t>(c.points)};
  }
  std::span<const HardPoint> points_of(const HardContact& c) const {
    return {&points[static_cast<std::size_t>(room * (&c - all.data()))], static_cast<std::size_t>(c.points)};
  }
};

/// Finds all pairs and walls that touch at the present places, and remembers that in the contacts of the system.
void find_hard_contacts(ParticleSystem& system, ContactLists& lists, HardContacts& out);

/// Whether a contact counts on this rank: a pair of two ranks does where the lower id is.
inline bool counts_here(const HardContacts& h, const HardContact& c) { return static_cast<std::size_t>(c.a) < h.own; }

/// Brings the velocities and spins of copies to those of their originals.
inline void tell_velocities(HardContacts& h, Telling& telling) {
  const auto put = [](double* to, sc_vec v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
  };
  tell<6>(
      telling, h.ranks,
      [&](std::int32_t i, double* to) {
        put(to, h.bodies[i].velocity);
        put(to + 3, h.bodies[i].spin);
      },
      [&](std::int32_t i, const double* from) {
        h.bodies[i].velocity = sc_make_vec(from[0], from[1], from[2]);
        h.bodies[i].spin = sc_make_vec(from[3], from[4], from[5]);
      });
}

/// Velocity of A at a point of the contact, seen from B [m/s].
inline sc_vec contact_velocity(const std::vector<HardBody>& bodies, const HardContact& c, const HardPoint& p) {
  const HardBody& a = bodies[c.a];
  const sc_vec at_a = sc_add(a.velocity, sc_cross(a.spin, p.arm_a));
  if (c.at_wall()) return sc_sub(at_a, p.surface);
  const HardBody& b = bodies[c.b];
  return sc_sub(at_a, sc_add(b.velocity, sc_cross(b.spin, p.arm_b)));
}

/// Spin of A seen from B [rad/s].
inline sc_vec contact_spin(const std::vector<HardBody>& bodies, const HardContact& c) {
  return sc_sub(bodies[c.a].spin, c.at_wall() ? c.wall_spin : bodies[c.b].spin);
}

/// What resists turning of the bodies of a contact against each other.
inline sc_turn_hold contact_turning(const HardContacts& h, const HardContact& c) {
  const sc_mat& mine = h.bodies[c.a].inverse_inertia;
  return sc_make_turn_hold(c.push, c.at_wall() ? mine : sc_add_mat(mine, h.bodies[c.b].inverse_inertia),
                           c.turning.rolling * c.radius, c.turning.twisting * c.radius);
}

/// K of both bodies.
inline sc_mat contact_response(const HardContacts& h, const HardContact& c, const HardPoint& p) {
  const HardBody& a = h.bodies[c.a];
  const sc_mat mine = sc_response(a.inverse_mass, a.inverse_inertia, p.arm_a);
  if (c.at_wall()) return mine;
  const HardBody& b = h.bodies[c.b];
  return sc_add_mat(mine, sc_response(b.inverse_mass, b.inverse_inertia, p.arm_b));
}

/// Gives A an impulse and B its opposite. Bodies that nothing moves are not touched: another thread may read them.
inline void give(HardContacts& h, const HardContact& c, const HardPoint& p, sc_vec impulse) {
  const auto hit = [](HardBody& body, sc_vec arm, sc_vec gift) {
    if (body.inverse_mass == 0) return;
    body.velocity = sc_add_scaled(body.velocity, body.inverse_mass, gift);
    body.spin = sc_add(body.spin, sc_turn(body.inverse_inertia, sc_cross(arm, gift)));
  };
  hit(h.bodies[c.a], p.arm_a, impulse);
  if (!c.at_wall()) hit(h.bodies[c.b], p.arm_b, sc_scale(-1, impulse));
}

/// Gives A a couple and B its opposite.
inline void give_couple(HardContacts& h, const HardContact& c, sc_vec couple) {
  const auto turn = [](HardBody& body, double sign, sc_vec gift) {
    if (body.inverse_mass == 0) return;
    body.spin = sc_add_scaled(body.spin, sign, sc_turn(body.inverse_inertia, gift));
  };
  turn(h.bodies[c.a], 1, couple);
  if (!c.at_wall()) turn(h.bodies[c.b], -1, couple);
}

/// Work of an impulse between the velocities before and after it, by direction: losses of the contact.
inline void book_loss(HardContact& c, sc_vec impulse, sc_vec before, sc_vec after) {
  const sc_vec sum = sc_scale(0.5, sc_add(before, after));
  const double all = -sc_dot(impulse, sum);
  const double normal = -sc_dot(impulse, c.push) * sc_dot(sum, c.push);
  c.lost_normal += normal;
  c.lost_sliding += all - normal;
}

/// The same of a couple, between the spins before and after it.
inline void book_turning_loss(HardContact& c, sc_vec couple, sc_vec before, sc_vec after) {
  c.lost_rolling -= 0.5 * sc_dot(couple, sc_add(before, after));
}

}  // namespace scree
