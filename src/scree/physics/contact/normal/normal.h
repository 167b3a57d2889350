// What every normal law tells the composer.
#ifndef SCREE_PHYSICS_CONTACT_NORMAL_NORMAL_H
#define SCREE_PHYSICS_CONTACT_NORMAL_NORMAL_H

#include "scree/physics/contact/contact.h"

typedef struct {
  int joined;        // the bodies are in contact
  real spring;       // repulsion of the spring [N]
  real attraction;   // adhesion inside the contact [N]
  real stiffness;    // d(spring)/d(overlap) with the contact area as it is [N/m]
  real damping;      // coefficient of the dashpot [N s/m]
  real area_radius;  // radius of the contact area [m]
  real depth;        // overlap with whose square root area_radius grows as it does here [m]
  real elastic;      // energy of the spring [J]
  real cohesive;     // energy of the adhesion, negative [J]
} sc_normal;

#endif
