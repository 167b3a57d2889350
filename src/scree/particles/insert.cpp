#include "scree/particles/insert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/audit.h"
#include "scree/base/error.h"
#include "scree/particles/deviates.h"
#include "scree/particles/insert_check.h"
#include "scree/particles/insert_lattice.h"
#include "scree/particles/insert_random.h"
#include "scree/particles/insert_region.h"

namespace scree {
namespace {

using Place = std::array<double, 3>;

/// Volume of the part of space that a group's solid fraction refers to [m3].
double region_volume(const ParticleGroup& group) {
  double volume = 1;
  for (int k = 0; k < 3; ++k) volume *= region_extent(group, k);
  return volume;
}

std::vector<double> diameters_by_fraction(const ParticleGroup& group, std::uint32_t index, std::uint64_t seed) {
  const double wanted = group.solid_fraction * region_volume(group);
  std::vector<double> diameters;
  for (double sum = 0;;) {
    const double d = draw_diameter(group.sizes, seed, index, diameters.size());
    if (sum + 0.5 * sphere_volume(d) > wanted) return diameters;
    sum += sphere_volume(d);
    diameters.push_back(d);
  }
}

std::vector<Place> places_of(const ParticleGroup& group, std::uint32_t index, const std::vector<double>& diameters,
                             const InsertionSetting& setting, OccupiedSpace& space) {
  if (group.placement == ParticleGroup::Placement::random)
    return random_positions(group, index, diameters, setting, space);
  std::vector<Place> places;
  if (group.placement == ParticleGroup::Placement::lattice) {
    places = lattice_positions(group, index, diameters, setting);
  } else {
    for (const GivenParticle& given : group.given) {
      places.push_back(given.position);
      for (int k = 0; k < 3; ++k)
        if (given.position[k] == setting.domain.max[k])
          places.back()[k] = wrapped(given.position[k], setting.domain, k);
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Newcomer newcomer{i, diameters[i], places[i]};
    space.add(places[i], radius_around(shape_of(group, i), diameters[i]), body_of(group, index, newcomer, setting));
  }
  return places;
}

Place start_velocity(const ParticleGroup& group, std::uint32_t index, std::uint64_t count, const Place& place,
                     const InsertionSetting& setting) {
  if (group.placement == ParticleGroup::Placement::given && group.given[count].velocity)
    return *group.given[count].velocity;
  Place v = group.velocity;
  if (group.start == ParticleGroup::Start::fluid && setting.fluid) v = setting.fluid(place);
  if (group.start == ParticleGroup::Start::random) {
    const std::uint32_t stream = random_stream(Purpose::velocity, index);
    const auto xy = normal_pair({setting.seed, stream, count, 0});
    const double z = normal({setting.seed, stream, count, 1});
    v[0] += group.velocity_deviation * xy[0];
    v[1] += group.velocity_deviation * xy[1];
    v[2] += group.velocity_deviation * z;
  }
  return v;
}

bool same(const Form& a, const Form& b) { return same_shape(a, b) && a.shape.is_sphere == b.shape.is_sphere; }

/// What a particle of a shape has besides: where its axes lie, and its inertia. The radius around it is there already.
void fill_shape(Particles& particles, std::size_t row, const Forms& forms, const Form& shape, const sc_quat& q,
                double diameter, const Place& w) {
  const auto form = std::find_if(forms.begin(), forms.end(), [&](const Form& f) { return same(f, shape); });
  require(form != forms.end(), "every shape of the groups is among the forms");
  particles.form[row] = static_cast<std::int32_t>(form - forms.begin());
  const sc_quat unit = sc_quat_of_length_one(q);
  const double lanes[4] = {unit.w, unit.x, unit.y, unit.z};
  std::copy_n(lanes, 4, particles.orientation.row(row));
  double* inertia = particles.inertia.row(row);
  inertia[lane::radius_by_volume] = 0.5 * diameter;
  const double radius = particles.motion.row(row)[lane::radius], mass = particles.mass[row];
  if (particles.motion.row(row)[lane::inverse_mass] == 0) return;
  const sc_mat axes = sc_quat_mat(unit);
  const sc_vec spin = sc_turn_back(axes, {w[0], w[1], w[2]});
  const std::array<double, 3> own{spin.x, spin.y, spin.z};
  std::array<double, 3> turning;
  for (std::size_t k = 0; k < 3; ++k) {
    const double moment = mass * radius * radius * shape.inertia[k];
    inertia[k] = 1 / moment;
    turning[k] = moment * own[k];
  }
  const sc_vec world = sc_turn(axes, {turning[0], turning[1], turning[2]});
  const double momentum[4] = {world.x, world.y, world.z, 0};
  std::copy_n(momentum, 4, particles.angular_momentum.row(row));
}

void fill_row(Particles& particles, std::size_t row, const ParticleGroup& group, double radius, double diameter,
              const Place& x, const Place& v, const Place& w) {
  const double mass = group.density * sphere_volume(diameter);
  double* m = particles.motion.row(row);
  double* s = particles.spin.row(row);
  for (int k = 0; k < 3; ++k) {
    m[lane::x + k] = x[k];
    m[lane::vx + k] = v[k];
    s[lane::sx + k] = radius * w[k];
  }
  m[lane::radius] = radius;
  m[lane::inverse_mass] = group.free ? 1 / mass : 0.0;
  s[lane::inverse_radius] = 1 / radius;
  particles.id[row] = static_cast<std::int64_t>(row);
  particles.material[row] = group.material;
  particles.mass[row] = mass;
  particles.effect_excess[row] = 0.5 * group.effect_gap;
}

}  // namespace

std::uint64_t group_count(const ParticleGroup& group) {
  if (group.placement == ParticleGroup::Placement::feed) return 0;
  if (group.placement == ParticleGroup::Placement::given) return group.given.size();
  if (group.placement == ParticleGroup::Placement::lattice && group.count == 0) return lattice_sites(group).count();
  return group.count;
}

const Form& shape_of(const ParticleGroup& group, std::uint64_t number) {
  const bool own = group.placement == ParticleGroup::Placement::given && group.given[number].shape;
  return own ? *group.given[number].shape : group.shape;
}

sc_quat orientation_of(const ParticleGroup& group, std::uint32_t index, std::uint64_t number, std::uint64_t seed) {
  const bool own = group.placement == ParticleGroup::Placement::given && group.given[number].orientation;
  return own ? *group.given[number].orientation : draw_orientation(group.orientations, seed, index, number);
}

void write_particle(Particles& particles, std::size_t row, const ParticleGroup& group, std::uint32_t index,
                    const Newcomer& newcomer, const InsertionSetting& setting) {
  const bool own_spin =
      group.placement == ParticleGroup::Placement::given && group.given[newcomer.number].angular_velocity;
  const Place spin = own_spin ? *group.given[newcomer.number].angular_velocity : group.angular_velocity;
  const Form& shape = shape_of(group, newcomer.number);
  fill_row(particles, row, group, radius_around(shape, newcomer.diameter), newcomer.diameter, newcomer.position,
           start_velocity(group, index, newcomer.number, newcomer.position, setting), spin);
  particles.group[row] = static_cast<std::int32_t>(index);
  if (particles.shaped())
    fill_shape(particles, row, setting.forms, shape, orientation_of(group, index, newcomer.number, setting.seed),
               newcomer.diameter, spin);
}

Forms forms_of(const std::vector<ParticleGroup>& groups) {
  Forms forms{sphere_form()};
  const auto add = [&](const Form& shape) {
    if (std::none_of(forms.begin(), forms.end(), [&](const Form& f) { return same(f, shape); })) forms.push_back(shape);
  };
  for (const ParticleGroup& group : groups) {
    add(group.shape);
    for (const GivenParticle& given : group.given)
      if (given.shape) add(*given.shape);
  }
  return forms.size() == 1 ? Forms{} : forms;
}

std::vector<double> group_diameters(const ParticleGroup& group, std::uint32_t index, std::uint64_t seed) {
  if (group.placement == ParticleGroup::Placement::random && group.count == 0)
    return diameters_by_fraction(group, index, seed);
  std::vector<double> diameters(group_count(group));
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    const bool own = group.placement == ParticleGroup::Placement::given && group.given[i].diameter;
    diameters[i] = own ? *group.given[i].diameter : draw_diameter(group.sizes, seed, index, i);
  }
  return diameters;
}

Particles insert_particles(const std::vector<ParticleGroup>& groups, const InsertionSetting& setting) {
  std::vector<std::vector<double>> diameters;
  std::vector<double> radii;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    diameters.push_back(group_diameters(groups[g], g, setting.seed));
    for (std::size_t i = 0; i < diameters[g].size(); ++i)
      radii.push_back(radius_around(shape_of(groups[g], i), diameters[g][i]));
  }
  OccupiedSpace space(setting.domain, radii);
  Particles particles(!setting.forms.empty());
  particles.resize(radii.size());
  std::size_t first = 0;
  bool all_random = true;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    const std::vector<Place> places = places_of(groups[g], g, diameters[g], setting, space);
    for (std::size_t i = 0; i < places.size(); ++i)
      write_particle(particles, first + i, groups[g], g, {i, diameters[g][i], places[i]}, setting);
    first += places.size();
    all_random = all_random && (places.empty() || groups[g].placement == ParticleGroup::Placement::random);
  }
  check_places(particles, groups, setting);
  if (!all_random) check_overlaps(particles, groups, setting);
  return particles;
}

}  // namespace scree
