// Particles on a device: putting them in the order of their cells, and finding partners.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "scree/particles/device/particles.h"

namespace scree {
namespace {

constexpr std::int64_t most_cells = std::int64_t{1} << 30;

}  // namespace

/// Cells as wide as bodies reach, but not many more than there are particles.
void DeviceParticles::fit_cells() {
  // Nobody has no width.
  double width = std::max(range_ + skin_, 1e-6 * (greatest_[0] - least_[0]));
  for (;; width *= 1.26) {
    double all = 1;
    for (int k = 0; k < 3; ++k) {
      const double length = greatest_[k] - least_[k];
      cells_.from[k] = least_[k];
      cells_.count[k] = static_cast<int>(std::clamp(std::floor(length / width), 1.0, 1e6));
      cells_.width[k] = length / cells_.count[k];
      cells_.middle[k] = 0.5 * (greatest_[k] + least_[k]);
      cells_.period[k] = wraps_[k] ? 0 : constants_.box.period[k];
      cells_.half_period[k] = wraps_[k] ? std::numeric_limits<double>::infinity() : constants_.box.half_period[k];
      cells_.around[k] = wraps_[k];
      all *= cells_.count[k];
    }
    if (all <= std::min(4.0 * static_cast<double>(n_ + come_) + 64, static_cast<double>(most_cells))) return;
  }
}

/// Replaces numbers by the sums of those before them.
void DeviceParticles::scan(opencl::DeviceBuffer& values, int count) {
  constexpr std::size_t scan_block = SC_SCAN_OWN * group;
  const int blocks = static_cast<int>((static_cast<std::size_t>(count) + scan_block - 1) / scan_block);
  opencl::DeviceBuffer sums(device_, static_cast<std::size_t>(blocks) * sizeof(std::int32_t));
  program_.run("sc_scan_blocks", static_cast<std::size_t>(blocks) * group, group, count, values, sums);
  if (blocks == 1) return;
  scan(sums, blocks);
  program_.run("sc_add_blocks", static_cast<std::size_t>(count), group, count, values, sums);
}

/// Packs the `count` rows of `from` with these numbers.
void DeviceParticles::take(const opencl::DeviceBuffer& rows, std::size_t count, std::size_t row_bytes,
                           const opencl::DeviceBuffer& from, opencl::DeviceBuffer& packed) {
  if (count == 0) return;
  const std::size_t words = row_bytes / sizeof(std::uint32_t);
  program_.run("sc_take_rows", count * words, group, static_cast<int>(count), static_cast<int>(words), rows, from,
               packed);
}

/// Puts packed rows where these numbers say.
void DeviceParticles::put(const opencl::DeviceBuffer& rows, std::size_t count, std::size_t row_bytes,
                          const opencl::DeviceBuffer& packed, opencl::DeviceBuffer& to) {
  if (count == 0) return;
  const std::size_t words = row_bytes / sizeof(std::uint32_t);
  program_.run("sc_put_rows", count * words, group, static_cast<int>(count), static_cast<int>(words), rows, packed, to);
}

/// Puts the first `count` rows in order.
void DeviceParticles::permute(opencl::DeviceBuffer& rows, std::size_t row_bytes, std::size_t count) {
  take(order_, count, row_bytes, rows, scratch_);
  rows.copy_from(scratch_, count * row_bytes);
}

/// Puts the state of the first `count` in order.
void DeviceParticles::permute_state(std::size_t count) {
  if (mixed_) {
    for (const char* name : {"motion", "spin"}) permute(column(name), row_bytes_.at(name), count);
    mixed_->for_each_row(now_, [&](opencl::DeviceBuffer& rows, std::size_t bytes) { permute(rows, bytes, count); });
    return;
  }
  // The state of the next step is free to take the rows in their new order.
  for (const auto& [name, both] : {std::pair("motion", motion_), std::pair("spin", spin_)})
    take(order_, count, row_bytes_.at(name), both[now_], both[1 - now_]);
  now_ = 1 - now_;
}

/// Puts those who are there from now on in the order of their cells; those who are gone get no place.
void DeviceParticles::sort_particles() {
  fit_cells();
  widen_state(n_ + come_);
  const std::size_t held = n_ + come_, stay = held - gone_count_;
  const int n = static_cast<int>(held), cells = cells_.count[0] * cells_.count[1] * cells_.count[2];
  const std::size_t bytes = (static_cast<std::size_t>(cells) + 1) * sizeof(std::int32_t);
  if (cell_first_.bytes() < bytes) {
    cell_first_ = opencl::DeviceBuffer(device_, bytes);
    cursor_ = opencl::DeviceBuffer(device_, bytes);
  }
  cell_first_.clear();
  program_.run("sc_count_cells", held, group, cells_, n, column("motion"), gone_, cell_of_, cell_first_, place_);
  scan(cell_first_, cells + 1);
  cursor_.copy_from(cell_first_, bytes);
  program_.run("sc_scatter", held, group, n, cell_of_, cursor_, order_);
  program_.run("sc_sort_cells", static_cast<std::size_t>(cells), group, cells, cell_first_, columns_.at("id"), order_);
  const int staying = static_cast<int>(stay);
  program_.run("sc_invert", stay, group, staying, order_, place_);
  permute_state(stay);
  for (auto& [name, column] : columns_) permute(column, row_bytes_.at(name), stay);
  if (planes_) permute(planes_->passed, planes_->row_bytes(), stay);
  if (gone_count_ > 0) gone_.clear();
  n_ = stay;
  come_ = gone_count_ = 0;
}

/// A list that lasts long costs candidates that do not touch, a short one costs making: hold the balance.
void DeviceParticles::adapt_skin() {
  if (!adapts_ || steps_listed_ == 0) return;
  if (steps_listed_ < 20) skin_ *= 1.3;
  if (steps_listed_ > 80) skin_ /= 1.2;
  skin_ = std::clamp(skin_, shortest_skin_, longest_skin_);
}

/// Runs a search into lists with more room until all that it finds has place; the search leaves the largest number that
/// a particle has in the first of the counters.
template <class Search>
void DeviceParticles::search_into(Lists& lists, Search&& search) {
  const int none[2] = {0, 0};
  for (;;) {
    counters_.write(none, sizeof none);
    if (lists.particles != n_) lists = make_room(n_, lists.room, lists.remembers);
    sc_counts sizes = counts();
    sizes.room = lists.room;
    search(sizes);
    const int most = counters_.values<std::int32_t>(1)[0];
    if (most <= lists.room) return;
    lists = make_room(n_, most + most / 8 + 1, lists.remembers);
  }
}

void DeviceParticles::find_partners(Lists& to) {
  search_into(to, [&](const sc_counts& sizes) {
    program_.run("sc_find_partners", n_, group, constants_.box, cells_, sizes, skin_ + beyond_, column("motion"),
                 columns_.at("effect_excess"), columns_.at("id"), ghost_flags(), cell_first_, to.counts, to.entries,
                 counters_);
  });
}

void DeviceParticles::find_faces() {
  Lists& to = fresh_face_lists_;
  search_into(to, [&](const sc_counts& sizes) {
    program_.run("sc_find_faces", n_, group, sizes, skin_ + beyond_, column("motion"), columns_.at("effect_excess"),
                 column_or_none("form"), wall_faces_, wall_poses_, ghost_flags(), to.counts, to.entries, counters_);
  });
}

/// A wall may jump away from a contact, or a body whose motion is prescribed; two other particles cannot part so fast.
void DeviceParticles::demand_none_lost() const {
  if (!bodies_ && counters_.values<std::int32_t>(1)[0] != 0)
    throw std::logic_error("a contact that acts is on no list of the device");
}

/// Gives fresh lists the memory of those before, and their place.
void DeviceParticles::carry_over(Lists& from, Lists& to, bool of_faces) {
  const int none[2] = {0, 0};
  counters_.write(none, sizeof none);
  to.shapes.clear();  // spheres among shapes have nothing there
  const bool single = from.remembers == Remembers::laws_in_single;
  program_.run(single ? "sf_carry_over" : "sc_carry_over", n_, group, static_cast<int>(n_),
               static_cast<int>(from.particles), static_cast<int>(of_faces), order_, place_, ghost_flags(), from.counts,
               from.entries, from.slides, from.rolls, from.shapes, to.counts, to.entries, to.slides, to.rolls,
               to.shapes, counters_);
  if (!of_faces) demand_none_lost();
  std::swap(from, to);
  if (to.room < from.room) to = make_room(n_, from.room, from.remembers);
}

/// Notes where everybody is.
void DeviceParticles::note_places() {
  if (mixed_)
    mixed_->listed.copy_from(mixed_->near[now_], n_ * 4 * sizeof(std::uint32_t));
  else
    program_.run("sc_note_places", n_, group, static_cast<int>(n_), motion_[now_], listed_);
}

void DeviceParticles::list_faces() {
  find_faces();
  carry_over(face_lists_, fresh_face_lists_, true);
  const std::size_t slots = n_ * static_cast<std::size_t>(face_lists_.room);
  if (corners_.bytes() >= slots * sizeof(std::int32_t)) return;
  gaps_ = opencl::DeviceBuffer(device_, slots * 4 * sizeof(double));
  corners_ = opencl::DeviceBuffer(device_, slots * sizeof(std::int32_t));
  if (shapes_) shapes_->places = opencl::DeviceBuffer(device_, slots * 3 * 4 * sizeof(double));
}

void DeviceParticles::make_lists() {
  adapt_skin();
  if (borders_) meet_others();
  sort_particles();
  if (borders_) follow_others();
  if (bodies_) find_bodies();
  if (shapes_) {
    find_partners(lists_);
    list_pairs();
  } else {
    find_partners(fresh_);
    carry_over(lists_, fresh_, false);
  }
  if (faces_ > 0) list_faces();
  if (borders_) unpack_luggage();
  note_places();
  steps_listed_ = 0;
  walls_travelled_ = 0;
  listed_already_ = true;
}

}  // namespace scree
