#include "scree/particles/audit.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "scree/base/audit.h"
#include "scree/particles/migration.h"

namespace scree {
namespace {

double distance2(const ParticleSystem& s, std::size_t i, std::size_t j) {
  const sc_vec branch = s.domain.nearest_vector(s.particles.motion.row(i), s.particles.motion.row(j));
  return sc_dot(branch, branch);
}

double reach(const Particles& p, std::size_t i) { return p.motion.row(i)[lane::radius] + p.effect_excess[i]; }

void audit_candidates(const ParticleSystem& s, double skin) {
  const Candidates& c = s.contacts.pairs;
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    for (std::int32_t k = c.first[p]; k < c.first[p + 1]; ++k) {
      require(c.owner[k] == static_cast<std::int32_t>(p), "candidates are grouped by owner");
      require(c.partner[k] > c.owner[k], "the owner of a pair is stored first");
      require(k == c.first[p] || c.partner[k - 1] < c.partner[k], "candidates of an owner rise and do not repeat");
    }
  if (s.particles.size() > brute_force_limit) return;
  for (std::size_t i = 0; i < s.particles.size(); ++i)
    for (std::size_t j = i + 1; j < s.particles.held(); ++j) {
      const bool moves =
          s.particles.motion.row(i)[lane::inverse_mass] > 0 || s.particles.motion.row(j)[lane::inverse_mass] > 0;
      const double range = reach(s.particles, i) + reach(s.particles, j) + skin;
      if (!moves || distance2(s, i, j) >= range * range) continue;
      require(std::binary_search(c.partner.begin() + c.first[i], c.partner.begin() + c.first[i + 1],
                                 static_cast<std::int32_t>(j)),
              "every near pair is a candidate");
    }
}

/// Reads what particle p gathers; `holds` is the pair whose force is in each slot.
void audit_gather(const ParticleSystem& s, const SweepPlan& plan, std::int32_t p,
                  const std::vector<std::int32_t>& holds) {
  const Candidates& c = s.contacts.pairs;
  std::int64_t last = -1;
  for (std::int32_t k = plan.gather_first[p]; k < plan.gather_first[p + 1]; ++k) {
    const std::int32_t pair = holds[plan.gather[k] >> 1];
    require(pair >= 0, "a slot is gathered after it is written");
    const bool is_partner = plan.gather[k] & 1;
    require((is_partner ? c.partner[pair] : c.owner[pair]) == p, "a particle gathers its own pairs");
    const std::int64_t other = s.particles.id[is_partner ? c.owner[pair] : c.partner[pair]];
    require(other > last, "slots are gathered in the order of the partners' ids");
    last = other;
  }
}

/// Goes through a pass, range by range, as the threads do.
void audit_plan(const ParticleSystem& s, const SweepPlan& plan) {
  const Candidates& c = s.contacts.pairs;
  std::vector<std::int32_t> holds(plan.slots, -1);
  std::vector<int> readers(plan.slots, 0);
  const auto read = [&](std::int32_t p) {
    audit_gather(s, plan, p, holds);
    for (std::int32_t k = plan.gather_first[p]; k < plan.gather_first[p + 1]; ++k) --readers[plan.gather[k] >> 1];
  };
  for (const SweepRange& range : plan.ranges)
    for (std::size_t t = 0; t + 1 < range.tiles.size(); ++t) {
      for (std::int32_t k = c.first[range.tiles[t]]; k < c.first[range.tiles[t + 1]]; ++k) {
        require(readers[plan.slot[k]] == 0, "a slot is written only when both partners have read it");
        holds[plan.slot[k]] = k;
        readers[plan.slot[k]] = c.partner[k] < static_cast<std::int32_t>(s.particles.size()) ? 2 : 1;
      }
      for (std::int32_t p = range.tiles[t]; p < range.tiles[t + 1]; ++p)
        if (!plan.deferred[p]) read(p);
    }
  std::size_t moved = 0;
  for (const SweepRange& range : plan.ranges) {
    for (const std::int32_t p : range.deferred) read(p);
    moved += range.deferred.size();
    for (std::int32_t p = range.begin; p < range.end; ++p) moved += !plan.deferred[p];
  }
  require(moved == s.particles.size(), "every particle moves once");
  require(std::all_of(readers.begin(), readers.end(), [](int r) { return r == 0; }),
          "every slot is read by all partners that move here");
}

/// Two ranks that share a pair must remember the same of it.
void audit_shared_pairs(const ParticleSystem& s, const Ranks& ranks) {
  const KeyedContacts all = gather_shared_pairs(s, ranks);
  const std::size_t count = all.ids.size() / 2, width = count > 0 ? all.shape.size() / count : 0;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> places;
  for (std::size_t c = 0; c < count; ++c) places[{all.ids[2 * c], all.ids[2 * c + 1]}].push_back(c);
  for (const auto& [key, rows] : places) {
    const std::vector<std::size_t>& at = rows;
    require(at.size() == 2, "a pair of two ranks acts on both");
    const auto alike = [&at](const std::vector<double>& table, std::size_t columns) {
      const auto one = table.begin() + static_cast<std::ptrdiff_t>(columns * at[0]),
                 other = table.begin() + static_cast<std::ptrdiff_t>(columns * at[1]);
      return std::equal(one, one + static_cast<std::ptrdiff_t>(columns), other);
    };
    require(alike(all.memory, 9) && alike(all.shape, width), "two ranks that share a pair remember the same of it");
  }
}

}  // namespace

void audit_lists(const ParticleSystem& s, const ContactLists& lists) {
  audit_candidates(s, lists.skin);
  audit_plan(s, lists.plan);
  if (!lists.ranks.alone()) audit_shared_pairs(s, lists.ranks);
}

}  // namespace scree
