// The contacts of particles that are sent to a device.
#include <algorithm>

#include "scree/particles/device/particles.h"

namespace scree {
namespace {

std::uint32_t entry_of(std::int32_t other, std::uint8_t code) {
  return static_cast<std::uint32_t>(other) | static_cast<std::uint32_t>(code) << SC_CODE_SHIFT;
}

}  // namespace

/// Contacts that act are sent as lists of their own; the first real lists take them over.
void DeviceParticles::send_contacts(const ParticleSystem& s) {
  if (shapes_)
    send_pairs(s);
  else
    send_sides(s);
  std::vector<Side> sides;
  const WallContacts& w = s.wall_contacts;
  for (std::size_t p = 0; p + 1 < w.first.size(); ++p)
    for (std::size_t k = std::size_t(w.first[p]); k < std::size_t(w.first[p + 1]); ++k)
      if (w.active[k])
        sides.push_back({p, entry_of(w.wall[k], w.active[k]), &w.slide[4 * k], rolls_ ? &w.roll[4 * k] : nullptr,
                         shapes_ ? &w.shape[wall_memory * k] : nullptr, 1});
  face_lists_ = sent_sides(sides, shapes_ ? Remembers::laws_and_places : Remembers::laws);
}

/// Each pair of spheres from both sides.
void DeviceParticles::send_sides(const ParticleSystem& s) {
  const PairContacts& c = s.contacts;
  std::vector<Side> sides;
  for (std::size_t k = 0; k < c.pairs.count; ++k) {
    if (!c.active[k]) continue;
    const std::int32_t a = c.pairs.owner[k], b = c.pairs.partner[k];
    const double *slide = &c.slide[4 * k], *roll = rolls_ ? &c.roll[4 * k] : nullptr;
    sides.push_back({static_cast<std::size_t>(a), entry_of(b, c.active[k]), slide, roll, nullptr, 1});
    sides.push_back({static_cast<std::size_t>(b), entry_of(a, c.active[k]), slide, roll, nullptr, -1});
  }
  lists_ = sent_sides(sides, pairs_remember());
}

DeviceParticles::Lists DeviceParticles::sent_sides(const std::vector<Side>& sides, Remembers remembers) const {
  std::vector<std::int32_t> count(n_);
  for (const Side& side : sides) ++count[side.particle];
  Lists lists = make_room(n_, n_ ? *std::max_element(count.begin(), count.end()) : 0, remembers);
  const std::size_t slots = n_ * static_cast<std::size_t>(lists.room);
  std::vector<std::uint32_t> entries(slots);
  std::vector<double> slides(4 * slots), rolls(rolls_ ? 4 * slots : 0);
  std::vector<double> shapes(remembers == Remembers::laws_and_places ? 8 * slots : 0);
  std::fill(count.begin(), count.end(), 0);
  for (const Side& side : sides) {
    const std::size_t slot = static_cast<std::size_t>(count[side.particle]++) * n_ + side.particle;
    entries[slot] = side.entry;
    for (std::size_t l = 0; l < 4; ++l) slides[4 * slot + l] = (l < 3 ? side.sign : 1) * side.slide[l];
    for (std::size_t l = 0; rolls_ && l < 4; ++l) rolls[4 * slot + l] = (l < 3 ? side.sign : 1) * side.roll[l];
    if (!shapes.empty()) std::copy_n(side.shape, wall_scratch, &shapes[wall_scratch * slot]);
  }
  lists.counts.write(count.data(), n_ * sizeof(std::int32_t));
  lists.entries.write(entries.data(), slots * sizeof(std::uint32_t));
  write_memory(lists.slides, slides, slide_units(remembers));
  write_memory(lists.rolls, rolls, roll_units(remembers));
  lists.shapes.write(shapes.data(), shapes.size() * sizeof(double));
  return lists;
}

}  // namespace scree
