// What a contact law is given and what it returns. One law, one file; the composer is law.h.
//
// Conventions, for every law: A is the partner with the lower id (a particle before a wall); `normal` points from A to
// B; velocities are those of A relative to B; forces and couples are those on A, and B gets exactly their negatives.
// The contact point divides the line of centres in the ratio of the radii, so the two lever arms add up to the
// distance.
#ifndef SCREE_PHYSICS_CONTACT_CONTACT_H
#define SCREE_PHYSICS_CONTACT_CONTACT_H

#include "scree/physics/vec.h"

/// The laws, chosen independently of each other by plain integers: a device passes them as constants.
enum { SC_NORMAL_LINEAR = 0, SC_NORMAL_LINEAR_PLAIN = 1, SC_NORMAL_HERTZ = 2 };
enum {
  SC_TANGENTIAL_NONE = 0,
  SC_TANGENTIAL_SLIDING = 1,                  // Coulomb friction only (report, figure 3.3)
  SC_TANGENTIAL_STEP_SPRING = 2,              // spring stretched by one time step's sliding (report, figure 3.4)
  SC_TANGENTIAL_COLLISION_SPRING = 3,         // spring stretched by v_t times the collision time (report, figure 3.5)
  SC_TANGENTIAL_COLLISION_SPRING_DAMPED = 4,  // the same with a dashpot (report, 3.2.3; thesis 3.43 to 3.47)
  SC_TANGENTIAL_HISTORY = 5,                  // spring with memory, linear
  SC_TANGENTIAL_MINDLIN = 6,                  // spring with memory, stiffness of Mindlin, never gaining energy
  SC_TANGENTIAL_MINDLIN_STRETCH = 7           // the same stiffness times the whole stretch, as most codes have it
};
enum { SC_ROLLING_NONE = 0, SC_ROLLING_SPRING = 1 };
enum { SC_TWISTING_NONE = 0, SC_TWISTING_SPRING = 1 };
enum { SC_COHESION_NONE = 0, SC_COHESION_LINEAR = 1, SC_COHESION_JKR = 2 };

/// Which laws a run uses.
typedef struct {
  int normal, tangential, rolling, twisting, cohesion;
} sc_laws;

/// Laws whose tangential spring has a memory.
SC_FN int sc_tangential_remembers(sc_laws laws) {
  return laws.tangential == SC_TANGENTIAL_HISTORY || laws.tangential == SC_TANGENTIAL_MINDLIN ||
         laws.tangential == SC_TANGENTIAL_MINDLIN_STRETCH;
}

/// Laws whose tangential stiffness follows the contact area.
SC_FN int sc_tangential_grows(sc_laws laws) {
  return laws.tangential == SC_TANGENTIAL_MINDLIN || laws.tangential == SC_TANGENTIAL_MINDLIN_STRETCH;
}

/// The constants of a pair of materials, derived once from the materials.
typedef struct {
  real stiffness;             // k_n of the linear laws [N/m]
  real damping;               // damping ratio of the normal law, from the restitution [-]
  real young;                 // effective modulus E* [Pa]
  real shear;                 // effective shear modulus G* [Pa]
  real tangential_stiffness;  // k_t of the linear laws [N/m]
  real tangential_damping;    // damping ratio of the tangential law [-]
  real friction_static;       // coefficient of static friction [-]
  real friction_sliding;      // coefficient of sliding friction [-]
  real rolling_stiffness;     // as a fraction of k_t R^2 [-]
  real rolling_damping;       // damping ratio [-]
  real rolling_friction;      // [-]
  real twisting_stiffness;    // as a fraction of k_t R^2 [-]
  real twisting_damping;      // [-]
  real twisting_friction;     // [-]
  real cohesion_stiffness;    // k_c [N/m]
  real adhesion;              // work of adhesion W of JKR [J/m2]
} sc_pair_law;

/// How two bodies meet at one contact point.
typedef struct {
  sc_vec normal;    // unit normal from A to B
  real overlap;     // of the bodies, delta [m]; negative when apart
  real reach;       // overlap of the effect surfaces, delta_e [m]
  sc_vec velocity;  // of A relative to B at the contact point [m/s]
  sc_vec spin;      // angular velocity of A minus that of B [rad/s]; read by rolling and twisting laws only
  real mass;        // which the normal force accelerates at the contact point; of spheres the reduced mass [kg]
  real reduced;     // reduced mass [kg]
  real radius;      // effective radius R* [m]
} sc_touch;

/// What a contact remembers between steps; it travels and is saved with the pair.
typedef struct {
  sc_vec slide;   // stretch of the tangential spring xi [m]
  sc_vec roll;    // stretch of the rolling spring [rad]
  real twist;     // stretch of the twisting spring [rad]
  real approach;  // normal velocity at the last evaluation [m/s]
  real acted;     // 1 if the contact acted at the last evaluation (JKR: the neck holds), else 0
  real slid;      // 1 if its tangential spring slid then, else 0
} sc_contact_state;

/// When the force is taken. Velocities belong to the time `lead` before the positions (half a step in the leapfrog, 0
/// for schemes that keep both at the same time). `dt` is the time since the last evaluation, over which springs stretch
/// (0 at the very first); `kick` is the time over which the force acts, over which dashpots and friction dissipate.
typedef struct {
  real dt, lead, kick;
} sc_contact_time;

/// Force and couple on A; the energy that the contact took out of the motion during this step, by channel.
typedef struct {
  sc_vec normal_force;      // along the normal, dashpot and cohesion included [N]
  sc_vec tangential_force;  // [N]
  sc_vec couple;            // rolling and twisting couple on A [N m]
  real loss_normal;         // [J]
  real loss_sliding;        // [J]
  real loss_rolling;        // rolling and twisting [J]
  int touching;             // the contact acts: state is kept; else it is forgotten
} sc_contact_action;

/// Energy stored in a contact: what comes back when the bodies part.
typedef struct {
  real elastic;   // normal and tangential, rolling and twisting springs [J]
  real cohesive;  // negative while bonded [J]
} sc_contact_energy;

#endif
