#include "scree/particles/insert_random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scree/base/error.h"
#include "scree/particles/deviates.h"
#include "scree/particles/insert_check.h"
#include "scree/particles/insert_region.h"
#include "scree/particles/shapes.h"

namespace scree {

int OccupiedSpace::octave(double radius) const {
  return std::min(static_cast<int>(levels_.size()) - 1, std::max(0, std::ilogb(largest_ / radius)));
}

OccupiedSpace::OccupiedSpace(const Domain& domain, const std::vector<double>& radii) : domain_(domain) {
  if (radii.empty()) return;
  const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
  largest_ = *largest;
  levels_.resize(std::ilogb(largest_ / *smallest) + 1);
  std::vector<std::int64_t> members(levels_.size(), 0);
  for (const double r : radii) {
    ++members[octave(r)];
    levels_[octave(r)].reach = std::max(levels_[octave(r)].reach, r);
  }
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    if (members[l] == 0) continue;
    levels_[l].lattice = CellLattice(domain, domain.min, domain.max, 2 * levels_[l].reach, 2 * members[l] + 64);
    levels_[l].head.assign(levels_[l].lattice.count(), -1);
  }
  spheres_.reserve(radii.size());
}

void OccupiedSpace::add(const std::array<double, 3>& position, double radius,
                        const std::optional<sc_body_shape>& body) {
  if (body) bodies_.push_back(*body);
  Level& level = levels_[octave(radius)];
  std::int32_t& head = level.head[level.lattice.cell(position.data())];
  spheres_.push_back({position, radius, head, body ? static_cast<std::int32_t>(bodies_.size()) - 1 : -1});
  head = static_cast<std::int32_t>(spheres_.size() - 1);
}

bool OccupiedSpace::overlap(const std::array<double, 3>& position, const sc_body_shape* body,
                            const Sphere& sphere) const {
  if (!body || sphere.body < 0) return true;
  const sc_vec branch = domain_.nearest_vector(position.data(), sphere.position.data());
  return touch_shapes(*body, bodies_[sphere.body], branch, false, {}).verdict == SC_GROWTH_TOUCHING;
}

bool OccupiedSpace::is_free(const std::array<double, 3>& position, double radius,
                            const std::optional<sc_body_shape>& body) const {
  const sc_body_shape* const shape = body ? &*body : nullptr;
  bool clear = true;
  for (const Level& level : levels_) {
    if (level.head.empty()) continue;
    level.lattice.for_each_run(position.data(), radius + level.reach, [&](std::int64_t c0, std::int64_t c1) {
      for (std::int64_t c = c0; clear && c < c1; ++c)
        for (std::int32_t s = level.head[c]; s >= 0; s = spheres_[s].next) {
          const double range = radius + spheres_[s].radius;
          if (distance2(position.data(), spheres_[s].position.data(), domain_) < range * range)
            clear = clear && !overlap(position, shape, spheres_[s]);
        }
    });
    if (!clear) return false;
  }
  return true;
}

namespace {

[[noreturn]] void refuse_narrow_region(const ParticleGroup& group, const Newcomer& newcomer, double width, int axis) {
  if (group.shape.shape.is_sphere)
    throw InputError(fmt::format(
        "particle group '{}': particles {:g} m in diameter do not fit into the region, {:g} m wide along {}\n"
        "  = help: enlarge the region or reduce the diameter",
        group.name, width, region_extent(group, axis), "xyz"[axis]));
  throw InputError(fmt::format(
      "particle group '{}': its particle {} is {:g} m wide along {} as it is turned and does not fit into the region, "
      "{:g} m wide there\n"
      "  = help: enlarge the region, make the particles smaller, or turn them   (scree explain particles.orientation)",
      group.name, newcomer.number, width, "xyz"[axis], region_extent(group, axis)));
}

[[noreturn]] void refuse_crowd(const ParticleGroup& group, const std::vector<double>& diameters,
                               const std::vector<std::uint32_t>& order, std::size_t placed) {
  double room = 1, wanted = 0, reached = 0;
  for (int k = 0; k < 3; ++k) room *= region_extent(group, k);
  for (std::size_t i = 0; i < order.size(); ++i) {
    wanted += sphere_volume(diameters[order[i]]);
    if (i < placed) reached += sphere_volume(diameters[order[i]]);
  }
  const std::string fractions =
      room > 0 ? fmt::format(" (solid fraction {:.3f} of the {:.3f} wanted)", reached / room, wanted / room) : "";
  throw InputError(
      fmt::format("particle group '{}': only {} of {} particles found room at random places{} after {} tries\n"
                  "  = help: place fewer particles, enlarge the region, raise `attempts`, or use insert = \"lattice\"; "
                  "equal spheres placed one by one at random jam near a solid fraction of 0.38{}",
                  group.name, placed, order.size(), fractions, group.attempts * order.size(),
                  group.shape.shape.is_sphere ? "" : ", long and flat bodies below"));
}

}  // namespace

std::optional<sc_body_shape> body_of(const ParticleGroup& group, std::uint32_t index, const Newcomer& newcomer,
                                     const InsertionSetting& setting) {
  if (setting.forms.empty()) return {};
  const Form& form = shape_of(group, newcomer.number);
  const sc_quat orientation = orientation_of(group, index, newcomer.number, setting.seed);
  return sc_body_shape{form.shape, radius_around(form, newcomer.diameter),
                       sc_quat_mat(sc_quat_of_length_one(orientation))};
}

PlaceRange range_of_places(const ParticleGroup& group, const Newcomer& newcomer,
                           const std::optional<sc_body_shape>& body, const InsertionSetting& setting) {
  const std::array<double, 3> half = half_widths(radius_around(group.shape, newcomer.diameter), body);
  PlaceRange range;
  for (int k = 0; k < 3; ++k) {
    const bool anywhere = spans_period(group, setting.domain, k) || region_extent(group, k) == 0;
    const double margin = anywhere ? 0.0 : half[k];
    range.low[k] = group.region_min[k] + margin;
    range.width[k] = region_extent(group, k) - 2 * margin;
    if (range.width[k] < 0) refuse_narrow_region(group, newcomer, 2 * margin, k);
  }
  return range;
}

std::array<double, 3> random_place(const PlaceRange& range, std::uint32_t index, std::uint64_t number,
                                   std::uint32_t attempt, const InsertionSetting& setting) {
  const std::uint32_t stream = random_stream(Purpose::position, index);
  const auto xy = uniform_pair({setting.seed, stream, number, 2 * attempt});
  const double z = uniform({setting.seed, stream, number, 2 * attempt + 1});
  const std::array<double, 3> u{xy[0], xy[1], z};
  std::array<double, 3> x;
  for (int k = 0; k < 3; ++k) x[k] = wrapped(range.low[k] + u[k] * range.width[k], setting.domain, k);
  return x;
}

std::vector<std::array<double, 3>> random_positions(const ParticleGroup& group, std::uint32_t index,
                                                    const std::vector<double>& diameters,
                                                    const InsertionSetting& setting, OccupiedSpace& space) {
  std::vector<std::uint32_t> order(diameters.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return diameters[a] > diameters[b]; });
  std::vector<std::array<double, 3>> positions(diameters.size());
  std::uint64_t tries_left = group.attempts * diameters.size();
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::uint32_t i = order[k];
    const double radius = radius_around(group.shape, diameters[i]);
    const Newcomer newcomer{i, diameters[i], {}};
    const std::optional<sc_body_shape> body = body_of(group, index, newcomer, setting);
    const PlaceRange range = range_of_places(group, newcomer, body, setting);
    for (std::uint32_t attempt = 0;; ++attempt) {
      if (tries_left-- == 0) refuse_crowd(group, diameters, order, k);
      if (setting.watch) setting.watch(group.name, k, order.size());
      positions[i] = random_place(range, index, i, attempt, setting);
      if (clear_of_walls(setting.walls, positions[i], radius, body) && space.is_free(positions[i], radius, body)) break;
    }
    space.add(positions[i], radius, body);
  }
  if (setting.watch) setting.watch(group.name, order.size(), order.size());
  return positions;
}

}  // namespace scree
