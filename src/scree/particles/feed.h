// Particles of a group that come in one after the other while the run goes on, at a rate.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "scree/particles/insert.h"

namespace scree {

/// When a group's particles come. One of the two rates is given, the other is 0.
struct Feed {
  std::uint32_t group = 0;                                           // index of the group
  double mass_rate = 0;                                              // [kg/s]
  double number_rate = 0;                                            // [1/s]
  double from = 0, until = std::numeric_limits<double>::infinity();  // [s]
  double total_mass = std::numeric_limits<double>::infinity();       // [kg]
  std::int64_t total_count = std::numeric_limits<std::int64_t>::max();
  double max_delay = std::numeric_limits<double>::infinity();  // the run stops when the feed is later than this [s]
};

/// How far a feed has come. With the case it is all that is needed to go on.
struct FeedState {
  std::int64_t count = 0;  // particles that have come in
  double mass = 0;         // theirs [kg]
  std::int64_t tries = 0;  // places tried in vain for the next one
};

/// Particles as they come in, and the ids they get.
struct Newcomers {
  Particles particles;
  std::int64_t next_id = 0;
};

/// What feeding looks at.
struct FeedContext {
  const Feed& feed;
  const ParticleGroup& group;
  const InsertionSetting& setting;
  double time = 0;                        // [s]
  const Particles& present;               // those that are there
  const std::vector<std::uint8_t>& gone;  // marks those of them that are just leaving; may be empty
};

/// The places of those present that may be in the way of the particles that are due now; empty if nobody is due.
std::optional<std::vector<std::int32_t>> in_the_way(const FeedContext& context, const FeedState& state);

/// The part of the domain that the particles which are due now can touch; empty if nobody is due. Whom they may touch
/// are those that reach into it with their effect surfaces.
std::optional<Domain> room_of_due(const FeedContext& context, const FeedState& state);

/// Adds the particles of a feed that are due now and find room: at random places of the group's region, where their
/// effect surfaces touch no wall, no particle that stays and none of the other newcomers, which is decided as contacts
/// are. The next one waits when it
/// finds none in group.attempts tries, and all later ones with it, so that the sizes keep their distribution; it goes
/// on trying at the next call. A particle is due when half of it is, so that the sums of the feed follow the rate
/// without bias. Throws PhysicsError when the one that waits is later than max_delay.
void feed(const FeedContext& context, FeedState& state, Newcomers& newcomers);

}  // namespace scree
