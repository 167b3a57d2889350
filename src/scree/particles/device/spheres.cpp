#include "scree/particles/device/spheres.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "scree/compute/opencl/text.h"
#include "scree/particles/keyed_contacts.h"
#include "scree/particles/reach.h"

namespace scree {
namespace {

constexpr int first_room = 12;  // partners of a particle that there is place for before more are found

static_assert(SC_SPEED_QUANTUM == speed_quantum);

/// The laws are constants of the kernels, so that the choice folds away.
std::string options_for(const sc_laws& laws, std::size_t group) {
  return fmt::format(
      "-cl-std=CL1.2 -DSC_GROUP={} -DSC_CHOSEN_NORMAL={} -DSC_CHOSEN_TANGENTIAL={} -DSC_CHOSEN_ROLLING={} "
      "-DSC_CHOSEN_TWISTING={} -DSC_CHOSEN_COHESION={}",
      group, laws.normal, laws.tangential, laws.rolling, laws.twisting, laws.cohesion);
}

sc_flow flow_of(const Fields& f) {
  sc_flow out{};
  out.kind = f.flow == FlowKind::uniform        ? SC_FLOW_UNIFORM
             : f.flow == FlowKind::taylor_green ? SC_FLOW_TAYLOR_GREEN
             : f.flow == FlowKind::shear        ? SC_FLOW_SHEAR
                                                : SC_FLOW_NONE;
  out.stream = f.stream;
  out.amplitude = f.amplitude;
  out.wavenumber = f.wavenumber;
  out.shear_rate = f.shear_rate;
  out.shear_origin = f.shear_origin;
  return out;
}

sc_box box_of(const Domain& domain) {
  sc_box box{};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = domain.low(k);
    box.high[k] = domain.high(k);
    box.period[k] = domain.period(k);
    box.half_period[k] = domain.half_period(k);
  }
  return box;
}

template <class T>
opencl::DeviceBuffer sent(const opencl::Device& device, const T* values, std::size_t count) {
  opencl::DeviceBuffer buffer(device, count * sizeof(T));
  buffer.write(values, count * sizeof(T));
  return buffer;
}

constexpr bool is_state(std::string_view name) { return name == "motion" || name == "spin"; }

}  // namespace

DeviceSpheres::DeviceSpheres(const opencl::Device& device, const ParticleSystem& s, const ContactLists& lists,
                             const Fields& fields, double max_overlap)
    : device_(device),
      program_(device, opencl::kernel_text, options_for(s.laws, group)),
      laws_of_run_(s.laws),
      first_law_(s.materials.law[0]),
      rolls_(s.contacts.remembers_rolling),
      n_(s.particles.size()),
      materials_(s.materials.count()),
      walls_(s.walls.size()),
      skin_(lists.skin),
      adapts_(lists.adapts) {
  const Sizes sizes = sizes_of(s.particles);
  beyond_ = reach_beyond_effects(s, sizes);
  range_ = 2 * sizes.effect_radius + beyond_;
  shortest_skin_ = 0.08 * sizes.mean_radius;
  longest_skin_ = sizes.mean_radius;
  constants_.box = box_of(s.domain);
  constants_.flow = flow_of(fields);
  constants_.fields = act_locally(fields);
  constants_.margin = lists.margin;
  constants_.max_overlap = max_overlap;
  laws_ = sent(device_, s.materials.law.data(), s.materials.law.size());
  check_kernels();
  send_particles(s.particles);
  send_walls(s);
  send_contacts(s);
  fresh_ = make_room(first_room);
}

std::size_t DeviceSpheres::groups() const { return (n_ + group - 1) / group; }

sc_counts DeviceSpheres::counts() const {
  return {static_cast<int>(n_), lists_.room, materials_, static_cast<int>(walls_)};
}

DeviceSpheres::Lists DeviceSpheres::make_room(int room) const {
  const std::size_t slots = n_ * static_cast<std::size_t>(room);
  return {room,
          {device_, n_ * sizeof(std::int32_t)},
          {device_, slots * sizeof(std::uint32_t)},
          {device_, slots * 4 * sizeof(double)},
          {device_, rolls_ ? slots * 4 * sizeof(double) : 0}};
}

void DeviceSpheres::send_particles(const Particles& particles) {
  particles.for_each_field([&](std::string_view name, const auto& column, auto...) {
    using Value = typename std::decay_t<decltype(column)>::value_type;
    const std::size_t width = static_cast<std::size_t>(std::decay_t<decltype(column)>::components);
    row_bytes_[name] = width * sizeof(Value);
    opencl::DeviceBuffer values = sent(device_, column.values.data(), n_ * width);
    if (is_state(name)) {
      opencl::DeviceBuffer* both = name == "motion" ? motion_ : spin_;
      both[0] = std::move(values);
      both[1] = opencl::DeviceBuffer(device_, both[0].bytes());
    } else {
      columns_[name] = std::move(values);
    }
  });
  listed_ = opencl::DeviceBuffer(device_, n_ * 4 * sizeof(double));
  for (opencl::DeviceBuffer* places : {&cell_of_, &order_, &place_})
    *places = opencl::DeviceBuffer(device_, n_ * sizeof(std::int32_t));
  scratch_ = opencl::DeviceBuffer(device_, n_ * 4 * sizeof(double));
  found_ = opencl::DeviceBuffer(device_, groups() * sizeof(sc_findings));
  stale_ = opencl::DeviceBuffer(device_, (most_given + 1) * sizeof(std::int32_t));
  counters_ = opencl::DeviceBuffer(device_, 2 * sizeof(std::int32_t));
}

void DeviceSpheres::send_walls(const ParticleSystem& s) {
  wall_faces_ = sent(device_, s.walls.faces.data(), s.walls.faces.size());
  wall_poses_ = sent(device_, s.walls.poses.data(), s.walls.poses.size());
  std::vector<std::uint32_t> codes(n_ * walls_);
  std::vector<double> slides(4 * n_ * walls_), rolls(rolls_ ? 4 * n_ * walls_ : 0);
  const WallContacts& w = s.wall_contacts;
  for (std::size_t p = 0; p + 1 < w.first.size(); ++p)
    for (std::int32_t c = w.first[p]; c < w.first[p + 1]; ++c) {
      const std::size_t slot = static_cast<std::size_t>(w.wall[c]) * n_ + p;
      codes[slot] = w.active[c];
      std::copy_n(&w.slide[4 * c], 4, &slides[4 * slot]);
      if (rolls_) std::copy_n(&w.roll[4 * c], 4, &rolls[4 * slot]);
    }
  wall_codes_ = sent(device_, codes.data(), codes.size());
  wall_slides_ = sent(device_, slides.data(), slides.size());
  wall_rolls_ = sent(device_, rolls.data(), rolls.size());
}

/// Contacts that act are sent as lists of their own, each from both sides; the first real lists take them over.
void DeviceSpheres::send_contacts(const ParticleSystem& s) {
  const PairContacts& c = s.contacts;
  std::vector<std::int32_t> count(n_);
  const auto acting = [&](auto&& visit) {
    for (std::size_t k = 0; k < c.pairs.count; ++k)
      if (c.active[k]) visit(k, c.pairs.owner[k], c.pairs.partner[k]);
  };
  acting([&](std::size_t, std::int32_t a, std::int32_t b) { ++count[a], ++count[b]; });
  lists_ = make_room(n_ ? *std::max_element(count.begin(), count.end()) : 0);
  const std::size_t slots = n_ * static_cast<std::size_t>(lists_.room);
  std::vector<std::uint32_t> partners(slots);
  std::vector<double> slides(4 * slots), rolls(rolls_ ? 4 * slots : 0);
  std::fill(count.begin(), count.end(), 0);
  const auto put = [&](std::size_t k, std::int32_t self, std::int32_t other, double sign) {
    const std::size_t slot = static_cast<std::size_t>(count[self]++) * n_ + static_cast<std::size_t>(self);
    partners[slot] = static_cast<std::uint32_t>(other) | static_cast<std::uint32_t>(c.active[k]) << SC_CODE_SHIFT;
    for (std::size_t l = 0; l < 4; ++l) slides[4 * slot + l] = (l < 3 ? sign : 1) * c.slide[4 * k + l];
    for (std::size_t l = 0; rolls_ && l < 4; ++l) rolls[4 * slot + l] = (l < 3 ? sign : 1) * c.roll[4 * k + l];
  };
  acting([&](std::size_t k, std::int32_t a, std::int32_t b) {
    put(k, a, b, 1);
    put(k, b, a, -1);
  });
  lists_.counts.write(count.data(), n_ * sizeof(std::int32_t));
  lists_.partners.write(partners.data(), slots * sizeof(std::uint32_t));
  lists_.slides.write(slides.data(), slides.size() * sizeof(double));
  lists_.rolls.write(rolls.data(), rolls.size() * sizeof(double));
}

void DeviceSpheres::step(const sc_move& move, const sc_contact_time& time) {
  if (is_full()) throw std::logic_error("a device that is full has to settle first");
  if (!listed_already_) make_lists();
  given_.push_back({move, time});
  launch(given_.back(), static_cast<int>(given_.size()) - 1);
}

/// Step number `number` since the steps were last settled.
void DeviceSpheres::launch(const Given& given, int number) {
  constants_.move = given.move;
  constants_.time = given.time;
  constants_.counts = counts();
  constants_.stale_square = 0.25 * skin_ * skin_;
  const sc_vec& g = given.move.gravity;
  constants_.book_gravity =
      constants_.box.period[0] + constants_.box.period[1] + constants_.box.period[2] == 0 && sc_dot(g, g) > 0;
  const int from = (now_ + number) % 2, to = 1 - from;
  program_.run("sc_pass", n_, group, constants_, number, stale_, motion_[from], spin_[from], motion_[to], spin_[to],
               columns_.at("effect_excess"), columns_.at("material"), listed_, laws_, lists_.counts, lists_.partners,
               lists_.slides, lists_.rolls, wall_faces_, wall_poses_, wall_codes_, wall_slides_, wall_rolls_,
               columns_.at("image"), columns_.at("loss"), columns_.at("work"), columns_.at("impulse"),
               columns_.at("angular_impulse"), found_);
}

/// What the steps have found since the last time.
void DeviceSpheres::add_findings(DeviceFindings& to) {
  to.last = {};
  for (const sc_findings& f : found_.values<sc_findings>(groups())) {
    to.last.fastest2 = std::max(to.last.fastest2, f.fastest_square);
    to.last.deepest = std::max(to.last.deepest, f.deepest);
    to.last.contacts += f.contacts;
    to.last.wall_contacts += f.wall_contacts;
    to.last.sound = to.last.sound && !f.unsound;
    to.last.inside = to.last.inside && !f.outside;
    to.contacts += f.all_contacts;
    to.wall_contacts += f.all_wall_contacts;
    to.impacts += f.impacts;
    to.impact_speed += f.impact_speed;
  }
  found_.clear();
}

DeviceFindings DeviceSpheres::settle() {
  DeviceFindings out;
  while (!given_.empty()) {
    const auto stale = stale_.values<std::int32_t>(given_.size() + 1);
    const auto halt = std::find_if(stale.begin() + 1, stale.end(), [](std::int32_t s) { return s != 0; });
    const std::ptrdiff_t done = halt == stale.end() ? std::ssize(given_) : halt - stale.begin();
    now_ = static_cast<int>((now_ + done) % 2);
    steps_listed_ += done;
    out.steps += done;
    given_.erase(given_.begin(), given_.begin() + done);
    add_findings(out);
    stale_.clear();
    if (halt != stale.end()) listed_already_ = false;
    if (!out.last.sound || !out.last.inside || out.last.deepest > constants_.max_overlap) break;
    if (given_.empty()) break;
    make_lists();
    for (std::size_t k = 0; k < given_.size(); ++k) launch(given_[k], static_cast<int>(k));
  }
  out.undone = std::ssize(given_);
  given_.clear();
  return out;
}

void DeviceSpheres::bring_back(const ParticleSystem& system, ParticleSystem& whole) const {
  whole.domain = system.domain;
  whole.laws = system.laws;
  whole.materials = system.materials;
  whole.walls = system.walls;
  Particles& p = whole.particles;
  p = Particles(false);
  p.resize(n_);
  p.for_each_field([&](std::string_view name, auto& column, auto...) {
    const opencl::DeviceBuffer& values = name == "motion" ? motion_[now_]
                                         : name == "spin" ? spin_[now_]
                                                          : columns_.at(name);
    values.read(column.values.data(), n_ * row_bytes_.at(name));
  });
  const std::vector<std::int64_t> id(p.id.values.begin(), p.id.values.end());
  KeyedContacts pairs, walls;
  const auto remember = [this](KeyedContacts& to, std::int64_t a, std::int64_t b, const double* slide,
                               const double* roll, std::uint32_t code) {
    to.ids.insert(to.ids.end(), {a, b});
    to.memory.insert(to.memory.end(), slide, slide + 4);
    for (int l = 0; l < 4; ++l) to.memory.push_back(rolls_ ? roll[l] : 0.0);
    to.memory.push_back(code == contact_code(true, true) ? 1.0 : 0.0);
  };
  const auto row = [](const std::vector<double>& rows, std::size_t slot) {
    return rows.empty() ? nullptr : &rows[4 * slot];
  };
  const auto count = lists_.counts.values<std::int32_t>(n_);
  const auto read_slot = [&](int k, auto&& buffer) {
    std::vector<double> rows(buffer.bytes() ? 4 * n_ : 0);
    buffer.read(rows.data(), rows.size() * sizeof(double), static_cast<std::size_t>(k) * 4 * n_ * sizeof(double));
    return rows;
  };
  const int most = n_ ? *std::max_element(count.begin(), count.end()) : 0;
  for (int k = 0; k < most; ++k) {
    std::vector<std::uint32_t> entry(n_);
    lists_.partners.read(entry.data(), n_ * sizeof(std::uint32_t),
                         static_cast<std::size_t>(k) * n_ * sizeof(std::uint32_t));
    const auto slide = read_slot(k, lists_.slides), roll = read_slot(k, lists_.rolls);
    for (std::size_t i = 0; i < n_; ++i) {
      if (k >= count[i] || entry[i] >> SC_CODE_SHIFT == 0) continue;
      const std::int64_t other = id[entry[i] & SC_PARTNER];
      if (id[i] < other) remember(pairs, id[i], other, row(slide, i), row(roll, i), entry[i] >> SC_CODE_SHIFT);
    }
  }
  const auto codes = wall_codes_.values<std::uint32_t>(n_ * walls_);
  const auto slides = wall_slides_.values<double>(4 * n_ * walls_);
  const auto rolls = wall_rolls_.values<double>(rolls_ ? 4 * n_ * walls_ : 0);
  for (std::size_t slot = 0; slot < n_ * walls_; ++slot)
    if (codes[slot])
      remember(walls, id[slot % n_], static_cast<std::int64_t>(slot / n_), row(slides, slot), row(rolls, slot),
               codes[slot]);
  p.permute(order_by_id(p));
  const RowsById rows = rows_of_held(p);
  whole.contacts = pairs_of(pairs, rows, rolls_, false);
  whole.wall_contacts = walls_of(walls, rows, p, walls_);
}

double DeviceSpheres::candidates() const {
  const auto count = lists_.counts.values<std::int32_t>(n_);
  return static_cast<double>(std::accumulate(count.begin(), count.end(), std::int64_t{0})) / static_cast<double>(n_);
}

std::size_t DeviceSpheres::bytes() const {
  std::size_t sum = 0;
  for (const auto& [name, column] : columns_) sum += column.bytes();
  for (const opencl::DeviceBuffer* b :
       {&motion_[0], &motion_[1], &spin_[0], &spin_[1], &listed_, &wall_codes_, &wall_slides_, &wall_rolls_, &cell_of_,
        &cell_first_, &cursor_, &order_, &place_, &scratch_, &found_})
    sum += b->bytes();
  for (const Lists* l : {&lists_, &fresh_})
    sum += l->counts.bytes() + l->partners.bytes() + l->slides.bytes() + l->rolls.bytes();
  return sum;
}

}  // namespace scree
