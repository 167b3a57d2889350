// Particles on the devices of several ranks: each moves those of its block, with copies of those near it. When lists
// are made, those near the borders come to the host, which lets them change the rank and tells whose copies go where;
// between that, copies are packed on the device in every step.
#include <algorithm>
#include <limits>
#include <unordered_map>

#include "scree/mpi/rows.h"
#include "scree/particles/device/particles.h"
#include "scree/particles/migration.h"

namespace scree {
namespace {

/// Of the particles of one rank to the mean, above which blocks are cut anew.
constexpr double uneven = 1.1;

std::vector<std::int32_t> numbers(std::size_t from, std::size_t to) {
  std::vector<std::int32_t> out;
  for (std::size_t i = from; i < to; ++i) out.push_back(static_cast<std::int32_t>(i));
  return out;
}

}  // namespace

const opencl::DeviceBuffer& DeviceParticles::ghost_flags() const {
  static const opencl::DeviceBuffer none;
  return borders_ ? columns_.at(ghost_column) : none;
}

void DeviceParticles::put_words(const std::vector<std::int32_t>& rows, std::int32_t word, opencl::DeviceBuffer& to) {
  if (rows.empty()) return;
  const std::vector<std::int32_t> words(rows.size(), word);
  scratch_.write(words.data(), words.size() * sizeof word);
  put(opencl::sent(device_, rows), rows.size(), sizeof word, scratch_, to);
}

/// The particles of the system are this rank's own ones and copies of those near its block.
void DeviceParticles::join(const ParticleSystem& system, const ContactLists& lists) {
  borders_.emplace();
  borders_->ranks = lists.ranks;
  borders_->blocks = lists.blocks;
  borders_->domain = system.domain;
  const std::size_t own = system.particles.size();
  borders_->ghosts = numbers(own, n_);
  for (const std::int32_t row : borders_->ghosts) borders_->ghost_ids.push_back(system.particles.id[row]);
}

/// Cuts the blocks anew where some have many more particles than others.
void DeviceParticles::share_evenly() {
  DeviceBorders& b = *borders_;
  const std::size_t own = n_ - b.ghosts.size();
  const double all = static_cast<double>(b.ranks.total(static_cast<std::int64_t>(own)));
  if (b.ranks.largest(static_cast<double>(own)) * b.ranks.count() <= uneven * all) return;
  Particles places;
  places.resize(n_);
  column("motion").read(places.motion.values.data(), n_ * row_bytes_.at("motion"));
  std::vector<std::int32_t> load(n_, 1);
  for (const std::int32_t row : b.ghosts) load[static_cast<std::size_t>(row)] = 0;
  balance(b.blocks, b.domain, places, load, b.ranks);
}

/// The cells cover the block and those near it.
void DeviceParticles::cover_block(double range) {
  const DeviceBorders& b = *borders_;
  const auto bounds = b.blocks.bounds(b.ranks.rank(), b.domain);
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = std::max(bounds[k][0], b.domain.min[k]), high = std::min(bounds[k][1], b.domain.max[k]);
    wraps_[k] = b.domain.periodic[k] && high - low + 2 * range >= b.domain.length(static_cast<int>(k));
    const bool whole = wraps_[k] || b.blocks.counts[k] == 1;
    least_[k] = whole ? b.domain.min[k] : low - range;
    greatest_[k] = whole ? b.domain.max[k] : high + range;
  }
}

/// Own particles that others may be near to, or that have left the block.
std::vector<std::int32_t> DeviceParticles::rows_at_borders(double range) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const DeviceBorders& b = *borders_;
  const auto bounds = b.blocks.bounds(b.ranks.rank(), b.domain);
  sc_region inner;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool alone = b.blocks.counts[k] == 1;
    inner.min[k] = alone ? -far : bounds[k][0] + range;
    inner.max[k] = alone ? far : bounds[k][1] - range;
  }
  const int none[2] = {0, 0};
  counters_.write(none, sizeof none);
  program_.run("sc_find_outside", n_, group, static_cast<int>(n_), inner, motion_[now_], columns_.at(ghost_column),
               scratch_, counters_);
  return found_rows();
}

/// The contacts of those who leave the block, each once.
Luggage DeviceParticles::luggage_of(const Particles& border, const std::vector<std::int32_t>& rows) {
  std::vector<std::int32_t> leaving;
  std::vector<std::int64_t> id;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (borders_->blocks.owner(border.motion.row(i)) == borders_->ranks.rank()) continue;
    leaving.push_back(rows[i]);
    id.push_back(border.id[i]);
  }
  return leaving.empty() ? Luggage() : contacts_of(leaving, id).contacts;
}

/// Those who have left the block go to other ranks, those who have come into it are taken in; all get copies of those
/// near their blocks. Rows change when the particles are sorted.
void DeviceParticles::meet_others() {
  DeviceBorders& b = *borders_;
  take_passings();
  share_evenly();
  const double reach = skin_ + beyond_, range = 2 * sizes_.effect_radius + reach;
  cover_block(range);
  const std::vector<std::int32_t> rows = rows_at_borders(range);
  Particles border = particles_at(rows);
  const Luggage leaving = luggage_of(border, rows);
  std::unordered_map<std::int64_t, std::int32_t> row_of;  // of those who may be known under another flag
  for (std::size_t k = 0; k < b.ghosts.size(); ++k) row_of[b.ghost_ids[k]] = b.ghosts[k];
  std::vector<std::uint8_t> gone;
  b.luggage = {};
  migrate(border, leaving, b.blocks, b.ranks, gone, b.luggage);
  std::vector<std::int32_t> stay, standing;  // places in `border`, and rows; -1: who comes
  for (std::size_t i = 0; i < border.size(); ++i) {
    // Those who have come stand behind those who are marked.
    if (i < gone.size() && gone[i]) {
      row_of[border.id[i]] = rows[i];
      continue;
    }
    stay.push_back(static_cast<std::int32_t>(i));
    standing.push_back(i < rows.size() ? rows[i] : -1);
  }
  Particles around = copies_of(border, stay);
  b.halo = make_halo(around, b.blocks, b.domain, sizes_.effect_radius, reach, b.ranks);
  standing.resize(around.held(), -1);
  take_places(around, row_of, standing);
  b.sent.clear();
  for (const auto& message : b.halo.rows)
    for (const std::int32_t i : message) b.sent.push_back(standing[static_cast<std::size_t>(i)]);
  b.ghosts.assign(standing.begin() + static_cast<std::ptrdiff_t>(around.size()), standing.end());
  b.ghost_ids.assign(around.id.values.data() + around.size(), around.id.values.data() + around.held());
}

/// Gives those of `around` who have no row yet one: that which `row_of` says they have had under another flag, or a new
/// one. Who is in `row_of` and not around is gone.
void DeviceParticles::take_places(const Particles& around, std::unordered_map<std::int64_t, std::int32_t>& row_of,
                                  std::vector<std::int32_t>& standing) {
  DeviceBorders& b = *borders_;
  b.come.clear();
  b.come_rows.clear();
  std::vector<std::int32_t> known, known_rows, fresh, own, ghosts;
  for (std::size_t i = 0; i < around.held(); ++i) {
    if (standing[i] >= 0) continue;
    const std::int64_t id = around.id[i];
    if (const auto found = row_of.find(id); found != row_of.end()) {
      standing[i] = found->second;
      known.push_back(static_cast<std::int32_t>(i));
      known_rows.push_back(found->second);
      row_of.erase(found);
    } else {
      standing[i] = static_cast<std::int32_t>(n_ + come_ + fresh.size());
      fresh.push_back(static_cast<std::int32_t>(i));
    }
    (i < around.size() ? own : ghosts).push_back(standing[i]);
    if (i >= around.size()) continue;
    b.come.push_back(id);
    b.come_rows.push_back(standing[i]);
  }
  std::vector<std::int32_t> gone;
  for (const auto& [id, row] : row_of) gone.push_back(row);
  put_rows(known_rows, copies_of(around, known));
  append(copies_of(around, fresh));
  dismiss(gone);
  put_words(own, 0, columns_.at(ghost_column));
  put_words(ghosts, 1, columns_.at(ghost_column));
}

/// Where rows have gone when the particles were sorted.
void DeviceParticles::follow(std::vector<std::int32_t>& rows) {
  if (rows.empty()) return;
  take(opencl::sent(device_, rows), rows.size(), sizeof rows[0], place_, scratch_);
  rows = scratch_.values<std::int32_t>(rows.size());
}

void DeviceParticles::follow_others() {
  DeviceBorders& b = *borders_;
  for (auto* rows : {&b.sent, &b.ghosts, &b.come_rows}) follow(*rows);
  b.sent_rows = opencl::sent(device_, b.sent);
  b.ghost_rows = opencl::sent(device_, b.ghosts);
  std::size_t all = 0, widest = 0;
  for_each_travelling(now_, [&](const opencl::DeviceBuffer&, std::size_t row_bytes) {
    all += row_bytes;
    widest = std::max(widest, row_bytes);
  });
  b.packed = opencl::DeviceBuffer(device_, std::max(b.sent.size(), b.ghosts.size()) * widest);
  for (std::size_t k = 0; k < b.halo.outgoing.size(); ++k) b.halo.outgoing[k].bytes.resize(b.halo.rows[k].size() * all);
}

/// Gives those who have come what their contacts remember.
void DeviceParticles::unpack_luggage() {
  DeviceBorders& b = *borders_;
  std::unordered_map<std::int64_t, std::int32_t> row_of;
  for (std::size_t k = 0; k < b.come.size(); ++k) row_of[b.come[k]] = b.come_rows[k];
  if (shapes_)
    put_pairs(b.luggage.pairs, row_of);
  else
    put_memory(b.luggage.pairs, row_of, lists_, false);
  if (faces_ > 0) put_memory(in_order(b.luggage.walls), row_of, face_lists_, true);
  b.luggage = {};
}

void DeviceParticles::put_memory(const KeyedContacts& contacts,
                                 const std::unordered_map<std::int64_t, std::int32_t>& row_of, Lists& lists,
                                 bool of_faces) {
  std::vector<std::int32_t> rows;
  std::vector<std::int64_t> partners;
  std::vector<std::uint32_t> codes;
  std::vector<double> slides, rolls, shapes;
  for (std::size_t c = 0; c < contacts.ids.size() / 2; ++c)
    for (std::size_t side = 0; side < (of_faces ? 1u : 2u); ++side) {
      const auto found = row_of.find(contacts.ids[2 * c + side]);
      if (found == row_of.end()) continue;
      rows.push_back(found->second);
      partners.push_back(contacts.ids[2 * c + 1 - side]);
      const double* m = &contacts.memory[9 * c];
      codes.push_back(contact_code(true, m[8] > 0));
      const double sign = side == 0 ? 1 : -1;
      slides.insert(slides.end(), {sign * m[0], sign * m[1], sign * m[2], m[3]});
      rolls.insert(rolls.end(), {sign * m[4], sign * m[5], sign * m[6], m[7]});
      if (contacts.shape.empty()) continue;
      const double* place = &contacts.shape[wall_scratch * c];
      shapes.insert(shapes.end(), place, place + wall_scratch);
    }
  if (rows.empty()) return;
  const int none[2] = {0, 0};
  counters_.write(none, sizeof none);
  program_.run("sc_put_memory", rows.size(), group, static_cast<int>(rows.size()), static_cast<int>(of_faces),
               static_cast<int>(lists.particles), opencl::sent(device_, rows), opencl::sent(device_, partners),
               opencl::sent(device_, codes), opencl::sent(device_, slides), opencl::sent(device_, rolls),
               opencl::sent(device_, shapes), columns_.at("id"), lists.counts, lists.entries, lists.slides, lists.rolls,
               lists.shapes, counters_);
  if (!of_faces) demand_none_lost();
}

/// Where what acts in a step is no number for one rank, no rank does the step.
void DeviceParticles::share_lost(int step) {
  std::int32_t lost = 0;
  const std::size_t at = static_cast<std::size_t>(step) * sizeof lost;
  fields_.lost().read(&lost, sizeof lost, at);
  lost = borders_->ranks.largest(lost) != 0;
  fields_.lost().write(&lost, sizeof lost, at);
}

/// Calls visit(rows, bytes of one) for every column that copies have anew from their originals in every step, in the
/// order of the table of Particles; motion and spin of the state `to`.
template <class Visit>
void DeviceParticles::for_each_travelling(int to, Visit&& visit) {
  alike_.for_each_field([&](std::string_view name, const auto&, Travels travels, auto...) {
    if (travels != Travels::always) return;
    visit(name == "motion" ? motion_[to] : name == "spin" ? spin_[to] : columns_.at(name), row_bytes_.at(name));
  });
}

/// Brings copies, in the state `to`, to that of their originals.
void DeviceParticles::renew_copies(int to) {
  DeviceBorders& b = *borders_;
  std::vector<std::size_t> at(b.halo.outgoing.size(), 0);  // how far each message has got
  for_each_travelling(to, [&](const opencl::DeviceBuffer& rows, std::size_t row_bytes) {
    take(b.sent_rows, b.sent.size(), row_bytes, rows, b.packed);
    const auto packed = b.packed.values<std::byte>(b.sent.size() * row_bytes);
    auto from = packed.begin();
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto bytes = static_cast<std::ptrdiff_t>(b.halo.rows[k].size() * row_bytes);
      std::copy_n(from, bytes, b.halo.outgoing[k].bytes.begin() + static_cast<std::ptrdiff_t>(at[k]));
      from += bytes;
      at[k] += static_cast<std::size_t>(bytes);
    }
  });
  b.ranks.swap(b.halo.outgoing, b.halo.incoming);
  at.assign(b.halo.incoming.size(), 0);
  for_each_travelling(to, [&](opencl::DeviceBuffer& rows, std::size_t row_bytes) {
    std::size_t first = 0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const std::size_t bytes = b.halo.count[k] * row_bytes;
      b.packed.write(b.halo.incoming[k].bytes.data() + at[k], bytes, first);
      first += bytes;
      at[k] += bytes;
    }
    put(b.ghost_rows, b.ghosts.size(), row_bytes, b.packed, rows);
  });
}

/// Whether step number `step` has set the flag of the next one on some rank.
bool DeviceParticles::some_rank_halts(int step) {
  std::int32_t flag = 0;
  stale_.read(&flag, sizeof flag, static_cast<std::size_t>(step + 1) * sizeof flag);
  return borders_->ranks.largest(flag) != 0;
}

}  // namespace scree
