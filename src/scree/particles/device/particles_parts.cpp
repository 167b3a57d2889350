// Particles and contacts that come back from a device, all or some of them.
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "scree/mpi/rows.h"
#include "scree/particles/device/particles.h"
#include "scree/particles/keyed_contacts.h"

namespace scree {
namespace {

bool everything(Travels) { return true; }

/// The properties of a system that are no particles and no contacts.
void take_properties(const ParticleSystem& from, ParticleSystem& to) {
  to.domain = from.domain;
  to.laws = from.laws;
  to.materials = from.materials;
  to.walls = from.walls;
  to.forms = from.forms;
}

/// Adds a contact by its key; no roll where none is remembered.
void remember(KeyedContacts& to, std::int64_t a, std::int64_t b, const double* slide, const double* roll,
              std::uint32_t code) {
  to.ids.insert(to.ids.end(), {a, b});
  to.memory.insert(to.memory.end(), slide, slide + 4);
  for (int l = 0; l < 4; ++l) to.memory.push_back(roll ? roll[l] : 0.0);
  to.memory.push_back(code == contact_code(true, true) ? 1.0 : 0.0);
}

/// Makes lists of the contacts that act.
void put_contacts(ParticleSystem& system, const Luggage& acting, bool rolls) {
  const RowsById rows = rows_of_held(system.particles);
  system.contacts = pairs_of(acting.pairs, rows, rolls, system.particles.shaped());
  system.wall_contacts = walls_of(acting.walls, rows, system.particles, system.walls.size());
}

/// How deep shapes were in walls in the last step, which the guard asks for; contacts of a particle stay in their
/// order.
void note_overlaps(ParticleSystem& system, const Luggage& acting, const std::vector<double>& overlaps) {
  const RowsById rows = rows_of_held(system.particles);
  WallContacts& walls = system.wall_contacts;
  std::vector<std::int32_t> next(walls.first.begin(), walls.first.end());
  for (std::size_t c = 0; c < overlaps.size(); ++c) {
    const auto w = static_cast<std::size_t>(next[static_cast<std::size_t>(rows.at(acting.walls.ids[2 * c]))]++);
    walls.shape[wall_memory * w + wall_scratch + 1] = overlaps[c];
  }
}

}  // namespace

opencl::DeviceBuffer& DeviceParticles::column(std::string_view name) {
  const int rows = mixed_ ? 0 : now_;
  return name == "motion" ? motion_[rows] : name == "spin" ? spin_[rows] : columns_.at(name);
}

const opencl::DeviceBuffer& DeviceParticles::column(std::string_view name) const {
  return const_cast<DeviceParticles*>(this)->column(name);
}

/// An empty buffer for what the particles do not have.
const opencl::DeviceBuffer& DeviceParticles::column_or_none(std::string_view name) const {
  static const opencl::DeviceBuffer none;
  return row_bytes_.contains(name) ? column(name) : none;
}

/// The rows of own particles, rising.
std::vector<std::int32_t> DeviceParticles::own_rows() const {
  const std::vector<std::int32_t> ghost = ghosts();
  std::vector<std::int32_t> out;
  for (std::size_t row = 0; row < ghost.size(); ++row)
    if (ghost[row] == 0) out.push_back(static_cast<std::int32_t>(row));
  return out;
}

/// In mixed precision, brings the rows in double of the first `count` to the present state.
void DeviceParticles::widen_state(std::size_t count) {
  if (mixed_) mixed_->give(program_, now_, count, column("motion"), column("spin"));
}

void DeviceParticles::read_columns(std::span<const std::string_view> names, Particles& to) {
  widen_state(n_);
  to.resize(count());
  const opencl::DeviceBuffer rows = borders_ ? opencl::sent(device_, own_rows()) : opencl::DeviceBuffer();
  to.for_each_field([&](std::string_view name, auto& values, auto...) {
    if (std::ranges::find(names, name) == names.end()) return;
    const std::size_t row_bytes = row_bytes_.at(name);
    if (borders_) take(rows, count(), row_bytes, column(name), scratch_);
    (borders_ ? scratch_ : column(name)).read(values.values.data(), count() * row_bytes);
  });
}

void DeviceParticles::write_columns(std::span<const std::string_view> names, const Particles& from) {
  const opencl::DeviceBuffer rows = borders_ ? opencl::sent(device_, own_rows()) : opencl::DeviceBuffer();
  from.for_each_field([&](std::string_view name, const auto& values, auto...) {
    if (std::ranges::find(names, name) == names.end()) return;
    const std::size_t row_bytes = row_bytes_.at(name);
    (borders_ ? scratch_ : column(name)).write(values.values.data(), count() * row_bytes);
    if (borders_) put(rows, count(), row_bytes, scratch_, column(name));
  });
}

Buffer<sc_field> DeviceParticles::bring_back_fields() const {
  const auto id = columns_.at("id").values<std::int64_t>(n_);
  const auto found = fields_.found().values<sc_field>(n_);
  std::vector<std::uint32_t> order(n_);
  std::iota(order.begin(), order.end(), 0U);
  const std::vector<std::int32_t> ghost = ghosts();
  std::erase_if(order, [&](std::uint32_t row) { return ghost[row] != 0; });
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return id[a] < id[b]; });
  Buffer<sc_field> out(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) out[i] = found[order[i]];
  return out;
}

/// Calls visit(contact) for every contact that acts, slot by slot.
template <class Visit>
void DeviceParticles::for_each_acting(const Lists& lists, Visit&& visit) const {
  if (lists.remembers == Remembers::nothing) return;
  const std::size_t n = lists.particles;
  const auto count = lists.counts.values<std::int32_t>(n);
  const auto read_slot = [&](int k, const opencl::DeviceBuffer& buffer, const std::optional<MemoryUnits>& units) {
    return buffer.bytes() ? read_memory(buffer, static_cast<std::size_t>(k) * n, n, units) : std::vector<double>();
  };
  const auto read_wide = [&](int k, const opencl::DeviceBuffer& buffer, std::size_t width) {
    std::vector<double> rows(buffer.bytes() ? width * n : 0);
    const std::size_t bytes = rows.size() * sizeof(double);
    buffer.read(rows.data(), bytes, static_cast<std::size_t>(k) * bytes);
    return rows;
  };
  const auto row = [](const std::vector<double>& rows, std::size_t width, std::size_t i) {
    return rows.empty() ? nullptr : &rows[width * i];
  };
  const int most = n ? *std::max_element(count.begin(), count.end()) : 0;
  for (int k = 0; k < most; ++k) {
    std::vector<std::uint32_t> entry(n);
    lists.entries.read(entry.data(), n * sizeof(std::uint32_t),
                       static_cast<std::size_t>(k) * n * sizeof(std::uint32_t));
    const auto slide = read_slot(k, lists.slides, slide_units(lists.remembers)),
               roll = read_slot(k, lists.rolls, roll_units(lists.remembers)),
               shape = read_wide(k, lists.shapes, wall_scratch),
               place = &lists == &face_lists_ && shapes_ ? read_wide(k, shapes_->places, 12) : std::vector<double>();
    for (std::size_t i = 0; i < n; ++i)
      if (k < count[i] && entry[i] >> SC_CODE_SHIFT != 0)
        visit(Acting{i, entry[i] & SC_PARTNER, entry[i] >> SC_CODE_SHIFT, &slide[4 * i], row(roll, 4, i),
                     row(shape, wall_scratch, i), place.empty() ? 0.0 : place[12 * i + 7]});
  }
}

/// What the contacts in lists of the particles `id` remember, each once; `id_of` tells the ids of partners by their
/// rows.
template <class IdOf>
Luggage DeviceParticles::remembered(const Lists& pairs, const Lists& faces, const std::vector<std::int64_t>& id,
                                    IdOf&& id_of) const {
  Luggage out;
  for_each_acting(pairs, [&](const Acting& c) {
    const auto [other, listed] = id_of(c.other);
    // Both sides know a pair. It is told from the lower id, or from the only one that is asked.
    const std::int64_t own = id[c.particle];
    if (own < other) return remember(out.pairs, own, other, c.slide, c.roll, c.code);
    if (listed) return;
    double turned[8];
    for (int l = 0; l < 8; ++l) turned[l] = (l % 4 < 3 ? -1 : 1) * (l < 4 ? c.slide[l] : c.roll ? c.roll[l - 4] : 0.0);
    remember(out.pairs, other, own, turned, turned + 4, c.code);
  });
  for_each_acting(faces, [&](const Acting& c) {
    remember(out.walls, id[c.particle], c.other, c.slide, c.roll, c.code);
    if (c.shape) out.walls.shape.insert(out.walls.shape.end(), c.shape, c.shape + wall_scratch);
  });
  return out;
}

/// Marks of the rows that are copies of others' particles.
std::vector<std::int32_t> DeviceParticles::ghosts() const {
  std::vector<std::int32_t> out(n_, 0);
  if (borders_) ghost_flags().read(out.data(), n_ * sizeof out[0]);
  return out;
}

/// The rows of the owner and the partner of every pair of bodies of any shape that acts, and its number.
std::vector<DeviceParticles::ActingPair> DeviceParticles::acting_pairs() const {
  const auto rows = shapes_->pairs.rows.values<std::array<std::uint32_t, 2>>(shapes_->pairs.count);
  std::vector<ActingPair> out;
  for (std::size_t c = 0; c < rows.size(); ++c)
    if (const std::uint32_t code = rows[c][0] >> SC_CODE_SHIFT)
      out.push_back({c, code, {rows[c][0] & SC_PARTNER, rows[c][1]}});
  return out;
}

/// What pairs of bodies of any shape remember; `id_of` tells ids by rows.
template <class IdOf>
KeyedContacts DeviceParticles::remembered_by(const std::vector<ActingPair>& acting, IdOf&& id_of) {
  KeyedContacts out;
  if (acting.empty()) return out;
  std::vector<std::int32_t> numbers;
  for (const ActingPair& pair : acting) numbers.push_back(static_cast<std::int32_t>(pair.number));
  const opencl::DeviceBuffer wanted = opencl::sent(device_, numbers);
  const std::size_t number = mixed_ ? sizeof(float) : sizeof(double);
  opencl::DeviceBuffer packed(device_, numbers.size() * pair_memory * number);
  const auto rows_of = [&](const opencl::DeviceBuffer& all, std::size_t width,
                           const std::optional<MemoryUnits>& units) {
    take(wanted, numbers.size(), width * number, all, packed);
    return read_memory(packed, 0, width / 4 * numbers.size(), units);
  };
  const DevicePairs& pairs = shapes_->pairs;
  const auto units = slide_units(pairs_remember()), none = roll_units(pairs_remember());
  const auto slides = rows_of(pairs.slides, 4, units), shapes = rows_of(pairs.shapes, pair_memory, none),
             rolls = rolls_ ? rows_of(pairs.rolls, 4, none) : std::vector<double>();
  for (std::size_t c = 0; c < acting.size(); ++c) {
    const ActingPair& pair = acting[c];
    remember(out, id_of(pair.rows[0]), id_of(pair.rows[1]), &slides[4 * c], rolls_ ? &rolls[4 * c] : nullptr,
             pair.code);
    out.shape.insert(out.shape.end(), &shapes[pair_memory * c], &shapes[pair_memory * c] + pair_scratch);
  }
  return out;
}

void DeviceParticles::bring_back(ParticleSystem& system) {
  widen_state(n_);
  Particles& p = system.particles;
  p.resize(n_);
  p.for_each_field([&](std::string_view name, auto& values, auto...) {
    column(name).read(values.values.data(), n_ * row_bytes_.at(name));
  });
  const std::vector<std::int64_t> id(p.id.values.begin(), p.id.values.end());
  const std::vector<std::int32_t> ghost = ghosts();
  const auto id_of = [&](std::uint32_t row) { return std::pair(id[row], ghost[row] == 0); };
  Luggage acting = remembered(lists_, face_lists_, id, id_of);
  if (shapes_) acting.pairs = remembered_by(acting_pairs(), [&](std::uint32_t row) { return id[row]; });
  std::vector<std::uint32_t> own = order_by_id(p);
  std::erase_if(own, [&](std::uint32_t row) { return ghost[row] != 0; });
  Bytes copies;
  if (borders_) pack_rows(p, borders_->ghosts, everything, copies);
  p.permute(own);
  if (borders_) {
    p.resize_ghosts(borders_->ghosts.size());
    unpack_rows(p, own.size(), borders_->ghosts.size(), everything, copies.data());
  }
  put_contacts(system, acting, rolls_);
  if (!shapes_) return;
  std::vector<double> overlaps;
  for_each_acting(face_lists_, [&](const Acting& c) {
    if (c.shape) overlaps.push_back(c.overlap);
  });
  note_overlaps(system, acting, overlaps);
}

/// The rows of the particles in regions, rising.
std::vector<std::int32_t> DeviceParticles::rows_in(const std::vector<sc_region>& regions) {
  const int none[2] = {0, 0};
  counters_.write(none, sizeof none);
  opencl::DeviceBuffer all(device_, regions.size() * sizeof(sc_region));
  all.write(regions.data(), all.bytes());
  program_.run("sc_find_in_regions", n_, group, static_cast<int>(n_), static_cast<int>(regions.size()), all,
               column("motion"), columns_.at("effect_excess"), scratch_, counters_);
  return found_rows();
}

/// What a search has left in `scratch_`, rising.
std::vector<std::int32_t> DeviceParticles::found_rows() {
  auto rows = scratch_.values<std::int32_t>(static_cast<std::size_t>(counters_.values<std::int32_t>(1)[0]));
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// Copies of the lists of some particles.
DeviceParticles::Lists DeviceParticles::taken(const Lists& lists, const std::vector<std::int32_t>& rows) {
  Lists out = make_room(rows.size(), lists.room, lists.remembers);
  if (rows.empty()) return out;
  const bool single = lists.remembers == Remembers::laws_in_single;
  program_.run(single ? "sf_take_lists" : "sc_take_lists", rows.size(), group, static_cast<int>(rows.size()),
               opencl::sent(device_, rows), static_cast<int>(lists.particles), lists.counts, lists.entries,
               lists.slides, lists.rolls, lists.shapes, out.counts, out.entries, out.slides, out.rolls, out.shapes);
  return out;
}

Particles DeviceParticles::particles_at(const std::vector<std::int32_t>& rows) {
  Particles out = alike_;
  out.resize(rows.size());
  if (rows.empty()) return out;
  const opencl::DeviceBuffer from = opencl::sent(device_, rows);
  out.for_each_field([&](std::string_view name, auto& values, auto...) {
    const std::size_t row_bytes = row_bytes_.at(name);
    take(from, rows.size(), row_bytes, column(name), scratch_);
    scratch_.read(values.values.data(), rows.size() * row_bytes);
  });
  return out;
}

/// The acting pairs of which one side at least is among the rows.
std::vector<DeviceParticles::ActingPair> DeviceParticles::pairs_of_some(const std::vector<std::int32_t>& asked) const {
  std::vector<ActingPair> out = acting_pairs();
  std::erase_if(out, [&](const ActingPair& pair) {
    return std::none_of(pair.rows.begin(), pair.rows.end(), [&](std::uint32_t row) {
      return std::binary_search(asked.begin(), asked.end(), static_cast<std::int32_t>(row));
    });
  });
  return out;
}

/// The contacts of the particles in `rows`, whose ids are `id`.
DeviceParticles::ContactsOfSome DeviceParticles::contacts_of(const std::vector<std::int32_t>& rows,
                                                             const std::vector<std::int64_t>& id) {
  ContactsOfSome out;
  const Lists pairs = shapes_ ? Lists{} : taken(lists_, rows);
  const Lists faces = faces_ > 0 ? taken(face_lists_, rows) : Lists{};  // without walls they are never made
  const std::vector<ActingPair> of_shapes = shapes_ ? pairs_of_some(rows) : std::vector<ActingPair>();
  for_each_acting(pairs, [&](const Acting& c) { out.partners.push_back(static_cast<std::int32_t>(c.other)); });
  for (const ActingPair& pair : of_shapes)
    for (const std::uint32_t row : pair.rows) out.partners.push_back(static_cast<std::int32_t>(row));
  const std::vector<std::int64_t> partner_ids = ids_at(out.partners);
  std::unordered_map<std::uint32_t, std::int64_t> partner;
  for (std::size_t k = 0; k < partner_ids.size(); ++k)
    partner[static_cast<std::uint32_t>(out.partners[k])] = partner_ids[k];
  const std::unordered_set<std::int32_t> asked(rows.begin(), rows.end());
  out.contacts = remembered(pairs, faces, id, [&](std::uint32_t row) {
    return std::pair(partner.at(row), asked.contains(static_cast<std::int32_t>(row)));
  });
  if (shapes_) out.contacts.pairs = remembered_by(of_shapes, [&](std::uint32_t row) { return partner.at(row); });
  return out;
}

std::vector<std::int64_t> DeviceParticles::ids_at(const std::vector<std::int32_t>& rows) {
  if (rows.empty()) return {};
  opencl::DeviceBuffer ids(device_, rows.size() * sizeof(std::int64_t));
  take(opencl::sent(device_, rows), rows.size(), sizeof(std::int64_t), columns_.at("id"), ids);
  return ids.values<std::int64_t>(rows.size());
}

PartOfDevice DeviceParticles::part_in(const std::vector<sc_region>& regions, const ParticleSystem& system) {
  widen_state(n_);
  const std::vector<std::int32_t> asked = rows_in(regions);
  const ContactsOfSome some = contacts_of(asked, ids_at(asked));
  std::vector<std::int32_t> rows = asked;
  rows.insert(rows.end(), some.partners.begin(), some.partners.end());
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  PartOfDevice part;
  take_properties(system, part.system);
  Particles& p = part.system.particles;
  p = particles_at(rows);
  const std::vector<std::uint32_t> order = order_by_id(p);
  for (const std::uint32_t i : order) part.rows.push_back(rows[i]);
  p.permute(order);
  part.id.assign(p.id.values.begin(), p.id.values.end());
  put_contacts(part.system, some.contacts, rolls_);
  return part;
}

}  // namespace scree
