// Everything that a step of the particles reads and changes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scree/compute/team.h"
#include "scree/data/domain.h"
#include "scree/data/forms.h"
#include "scree/data/materials.h"
#include "scree/data/particles.h"
#include "scree/data/vertices.h"
#include "scree/data/walls.h"
#include "scree/mpi/blocks.h"
#include "scree/mpi/halo.h"
#include "scree/particles/contacts.h"
#include "scree/particles/hard/settings.h"
#include "scree/particles/luggage.h"
#include "scree/particles/sweep.h"
#include "scree/particles/wall_contacts.h"

namespace scree {

/// Particles with their contacts. The lists (pairs, walls, plan) may be made again at any time without changing a bit
/// of what follows.
struct ParticleSystem {
  Domain domain;
  sc_laws laws{};
  Materials materials;
  Walls walls;
  Forms forms;                                      // empty in a system of spheres
  std::shared_ptr<const SurfaceVertices> vertices;  // of the forms, if contacts are found by them
  Particles particles;
  PairContacts contacts;
  WallContacts wall_contacts;
  std::optional<HardSettings> hard;  // collisions are impulses: contacts remember these
};

/// What keeps the lists valid and how the next pass goes.
struct ContactLists {
  Ranks ranks;
  Blocks blocks;
  Halo halo;
  Luggage luggage;
  // If there are several ranks: ids of the particles held when the lists were made, and pairs that the rank of the
  // partner counts.
  std::vector<std::int64_t> listed_ids;
  std::vector<std::int32_t> counted_elsewhere;
  bool ghosts_current = false;  // copies are as their originals
  SweepKernels kernels{};
  SweepPlan plan;
  SweepSlots slots;
  Buffer<sc_form> shapes;            // of the forms
  std::vector<VertexView> vertices;  // of the forms, if contacts are found by them
  Buffer<double> listed_at;          // [n][3]: positions when the lists were made [m]
  double skin = 0;                   // [m]
  double travelled = 0;              // no particle has moved further since then [m]
  double walls_travelled = 0;        // nor any wall [m]
  double margin = 0;                 // how far apart bodies may be and still act on each other [m]
  std::int64_t passes = 0;           // since the lists were made
  std::int64_t rebuilds = 0;
  bool made = false;
  bool adapts = true;  // the skin follows the motion
};

/// Kernels, margin and a first skin for a system; `skin` 0 lets the program choose and adapt it.
ContactLists prepare_lists(const ParticleSystem& system, double skin);

/// Makes the lists again if some particle may have come near another one unlisted. True if it did.
bool refresh_lists(ParticleSystem& system, ContactLists& lists, const Team& team);

/// The system has been put together from elsewhere, in another order, its contacts in lists of their own: lists have to
/// be made again before they are used.
void forget_lists(const ParticleSystem& system, ContactLists& lists);

/// Brings copies of other ranks' particles to the state of their originals, if they are not.
void update_ghosts(ParticleSystem& system, ContactLists& lists);

/// Whether the candidate pair c counts on this rank: a pair of two ranks does where the lower id is.
bool counts_here(const ParticleSystem& system, std::size_t c);

/// Particles marked in `gone` ([particles]; may be empty) go, those of `fresh` come; the contacts of the others keep
/// their memory. Makes the lists again. Of several ranks all have the same `fresh`, and take those in their blocks.
void change_population(ParticleSystem& system, ContactLists& lists, const std::vector<std::uint8_t>& gone,
                       const Particles& fresh, const Team& team);

/// Notes that particles moved by at most `distance` [m] since the last call.
void note_travel(ContactLists& lists, double distance);

/// Notes that parts of walls near particles moved by at most `distance` [m] since the last call.
void note_wall_travel(ContactLists& lists, double distance);

/// The view of the system for a pass. `field` is what acts at each particle, or null.
SweepView view_of(ParticleSystem& system, ContactLists& lists, const sc_move& move, const sc_contact_time& time,
                  const sc_field* field);

/// One pass over all contacts and particles: sweep() with the copies of other ranks' particles as they are now, and
/// with every pair of two ranks counted once.
SweepFindings pass(ParticleSystem& system, ContactLists& lists, const SweepView& view);

/// Numbers in a slot of the pass over the system.
std::size_t slot_size(const ParticleSystem& system);

/// The square of the largest speed of all particles [m2/s2].
double fastest_square(const Particles& particles);

/// Greatest distance of two centres at which bodies of the system may act on each other [m].
double longest_range(const ParticleSystem& system);

}  // namespace scree
