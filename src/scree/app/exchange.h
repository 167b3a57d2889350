// Particles come and go: what the feeds and outlets of a run have done so far, and their turn in the step.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/input/case.h"
#include "scree/kernels/region.h"
#include "scree/output/archive.h"
#include "scree/particles/feed.h"
#include "scree/particles/fields.h"
#include "scree/particles/outlet.h"
#include "scree/particles/passage.h"
#include "scree/particles/system.h"

namespace scree {

class Exchange {
 public:
  /// Feeds, outlets and groups of a case; `next_id` is the first id that is free.
  /// Throws InputError when the particles of a feed do not fit into its region.
  Exchange(const Case& c, std::int64_t next_id);

  /// True at the steps at which particles may come and go.
  bool due(std::int64_t step) const { return active() && step % every_ == 0; }

  /// True if the case lets particles come or go at all.
  bool active() const { return !feeds_.empty() || !outlets_.empty(); }

  /// Where those are who may leave at `time`, or may be in the way of those who are due. Who may be in the way reaches
  /// into it with his effect surface. Empty if nobody can come or go.
  std::vector<sc_region> regions(const Domain& domain, double time) const;

  /// Takes out what is in the outlets, then lets in what is due. `lists` must be made; `field` as in a pass. True if
  /// anybody came or went. Throws PhysicsError, with nothing changed, when a feed is too late. Of several ranks all
  /// call it and get the same answer.
  bool run(ParticleSystem& system, ContactLists& lists, Fields& fields, const sc_field* field, const Moment& moment,
           const Team& team);

  /// The first id that is free.
  std::int64_t next_id() const { return next_id_; }

  /// The books; of several ranks, those of the root.
  const Passage& passage() const { return passage_; }
  const std::vector<Outlet>& outlets() const { return outlets_; }
  const std::vector<OutletCount>& outlet_counts() const { return outlet_counts_; }

  void save(Archive& archive) const;
  /// Throws InputError when the archive is of another case.
  void restore(const Archive& archive);

 private:
  Newcomers newcomers(const ParticleSystem& system, const Ranks& ranks, Fields& fields, double time,
                      const std::vector<std::uint8_t>& gone, std::vector<FeedState>& states) const;
  Bytes take_out(ParticleSystem& system, ContactLists& lists, const std::vector<std::uint8_t>& taken,
                 const sc_field* field, const Moment& moment) const;
  void enter_books(const std::vector<Bytes>& gone);

  std::int64_t every_;
  std::uint64_t seed_;
  std::vector<ParticleGroup> groups_;  // those with a feed, in the order of feeds_
  std::vector<Feed> feeds_;
  std::vector<FeedState> states_;
  std::vector<Outlet> outlets_;
  std::vector<OutletCount> outlet_counts_;
  Passage passage_;
  std::int64_t next_id_;
};

}  // namespace scree
