#include "scree/app/body_kinds.h"

#include <algorithm>
#include <cmath>

#include "scree/app/build_exchange.h"
#include "scree/app/build_particles.h"
#include "scree/base/expression.h"

namespace scree {
namespace {

double length(const Vec3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

double distance(const Vec3& a, const Vec3& b) { return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]}); }

/// Smallest and largest diameter of the distribution, and the mean volume of the first bodies of a group.
void take_drawn(BodyKind& kind, const ParticleGroup& group, std::uint32_t index, std::uint64_t seed) {
  constexpr std::uint64_t drawn = 1000;
  kind.volume = 0;
  for (std::uint64_t i = 0; i < drawn; ++i)
    kind.volume += sphere_volume(draw_diameter(group.sizes, seed, index, i)) / drawn;
  kind.smallest = min_diameter(group.sizes);
  kind.largest = max_diameter(group.sizes);
}

/// Groups above this number are judged by a sample: their list of diameters alone could fill the memory.
constexpr double too_many_to_draw = 1e7;

void take_sizes(BodyKind& kind, const ParticleGroup& group, std::uint32_t index, std::uint64_t seed) {
  if (const double count = expected_number(group, index, seed); count > too_many_to_draw) {
    take_drawn(kind, group, index, seed);
    kind.count = static_cast<std::uint64_t>(std::min(count, 1e18));
    kind.volume *= count;
    return;
  }
  const std::vector<double> diameters = group_diameters(group, index, seed);
  kind.count = diameters.size();
  for (const double d : diameters) kind.volume += sphere_volume(d);
  if (diameters.empty()) return;
  const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
  const bool own = std::any_of(group.given.begin(), group.given.end(), [](const auto& g) { return g.diameter; });
  kind.smallest = own ? *smallest : min_diameter(group.sizes);
  kind.largest = own ? *largest : max_diameter(group.sizes);
}

/// As many as a feed is expected to let in; the mean size from the first of them.
void take_expected(BodyKind& kind, const ParticleGroup& group, const Feed& feed, const Case& c) {
  take_drawn(kind, group, feed.group, c.simulation.seed);
  const double count = expected_count(feed, group.density * kind.volume, c.simulation.end);
  kind.count = static_cast<std::uint64_t>(std::ceil(count));
  kind.volume *= static_cast<double>(kind.count);
}

void take_velocities(BodyKind& kind, const ParticleGroup& group) {
  std::vector<Vec3> own;
  for (const GivenParticle& given : group.given)
    if (given.velocity) own.push_back(*given.velocity);
  if (!own.empty()) {
    for (const Vec3& v : own)
      for (int k = 0; k < 3; ++k) kind.velocity[k] += v[k] / static_cast<double>(own.size());
    for (const Vec3& v : own) kind.spread = std::max(kind.spread, distance(v, kind.velocity));
    return;
  }
  if (group.start == ParticleGroup::Start::fluid) return;
  kind.velocity = group.velocity;
  // Four standard deviations: few particles are faster.
  if (group.start == ParticleGroup::Start::random) kind.spread = 4 * group.velocity_deviation;
}

/// The fastest that formulas of the prescribed motion get during the run, looked at from the middle of the region.
double prescribed_speed(const ParticleKeys& keys, const ParticleGroup& group, double end) {
  std::vector<Expression> v;
  for (const std::string& text : keys.motion_velocity)
    v.emplace_back(text, std::vector<std::string>{"x", "y", "z", "t"});
  Vec3 place;
  for (int k = 0; k < 3; ++k)
    place[k] = group.given.empty() ? 0.5 * (group.region_min[k] + group.region_max[k]) : group.given[0].position[k];
  constexpr int instants = 256;
  double fastest = 0;
  for (int i = 0; i <= instants; ++i) {
    const std::array<double, 4> at{place[0], place[1], place[2], end * i / instants};
    fastest = std::max(fastest, length({v[0](at), v[1](at), v[2](at)}));
  }
  return fastest;
}

/// The forms of a group that are no spheres, each once.
std::vector<Form> shapes_of(const ParticleGroup& group) {
  std::vector<Form> out;
  const auto add = [&](const Form& form) {
    const auto same = [&](const Form& f) { return same_shape(f, form); };
    if (!form.shape.is_sphere && std::none_of(out.begin(), out.end(), same)) out.push_back(form);
  };
  add(group.shape);
  for (const GivenParticle& given : group.given)
    if (given.shape) add(*given.shape);
  return out;
}

/// A body that tumbles about its middle axis has a tip with speed v sqrt(1 + R^2 m / I) at most,
/// where v is the speed of all its energy.
void take_shapes(BodyKind& kind, const ParticleGroup& group) {
  const std::vector<Form> forms = shapes_of(group);
  double thickness = 1;  // over the diameter by volume
  for (const Form& form : forms) {
    const Axes axes = form.half_axes();
    Axes inertia = form.inertia;
    std::sort(inertia.begin(), inertia.end());
    thickness = std::min(thickness, *std::min_element(axes.begin(), axes.end()) / form.equivalent_radius);
    kind.inscribed = std::min(kind.inscribed, form.shape.inscribed / form.equivalent_radius);
    kind.tip = std::max(kind.tip, std::sqrt(1 + 1 / inertia[1]));
    const std::vector<ContactPlace> places = quickest_places(form);
    kind.places.insert(kind.places.end(), places.begin(), places.end());
  }
  kind.places = quickest_of(std::move(kind.places));
  kind.thickness = kind.smallest * thickness;
}

}  // namespace

double expected_number(const ParticleGroup& group, std::uint32_t index, std::uint64_t seed) {
  if (group.placement != ParticleGroup::Placement::random || group.count > 0)
    return static_cast<double>(group_count(group));
  BodyKind kind;
  take_drawn(kind, group, index, seed);
  double region = 1;
  for (int k = 0; k < 3; ++k) region *= group.region_max[k] - group.region_min[k];
  return group.solid_fraction * region / kind.volume;
}

double BodyKind::typical() const {
  constexpr double pi = 3.141592653589793;
  return count == 0 ? 0.0 : std::cbrt(volume / static_cast<double>(count) * 6 / pi);
}

std::vector<BodyKind> body_kinds(const Case& c, const Particles* present) {
  std::vector<ParticleGroup> groups = build_groups(c, present ? Takeover::skip : Takeover::read);
  for (std::size_t i = 0; present && i < present->size(); ++i) {
    const auto g = static_cast<std::size_t>(present->group[i]);
    if (c.particles[g].insert == "checkpoint")
      groups[g].given.push_back({{}, {}, {}, 2 * present->radius_by_volume(i), {}, {}});
  }
  const std::vector<Feed> feeds = build_feeds(c);
  std::vector<BodyKind> kinds;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    BodyKind kind;
    kind.name = groups[g].name;
    kind.group = g;
    kind.material = groups[g].material;
    kind.free = groups[g].free;
    kind.density = groups[g].density;
    kind.effect_gap = groups[g].effect_gap;
    const auto feed = std::find_if(feeds.begin(), feeds.end(), [&](const Feed& f) { return f.group == g; });
    if (feed == feeds.end())
      take_sizes(kind, groups[g], g, c.simulation.seed);
    else
      take_expected(kind, groups[g], *feed, c);
    take_shapes(kind, groups[g]);
    take_velocities(kind, groups[g]);
    if (c.particles[g].motion == "prescribed")
      kind.spread = std::max(kind.spread, prescribed_speed(c.particles[g], groups[g], c.simulation.end));
    if (kind.count > 0) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace scree
