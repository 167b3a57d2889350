#include "scree/app/build_particles.h"

#include "scree/app/build_materials.h"
#include "scree/app/take_over.h"
#include "scree/particles/insert_table.h"

namespace scree {
namespace {

SizeDistribution sizes_of(const SizeKeys& keys) {
  using Kind = SizeDistribution::Kind;
  SizeDistribution sizes;
  sizes.kind = keys.distribution == "classes"     ? Kind::classes
               : keys.distribution == "uniform"   ? Kind::uniform
               : keys.distribution == "normal"    ? Kind::normal
               : keys.distribution == "lognormal" ? Kind::lognormal
                                                  : Kind::single;
  sizes.value = keys.value;
  sizes.diameters = keys.diameters;
  sizes.fractions = keys.fractions;
  sizes.mean = keys.mean;
  sizes.deviation = keys.deviation;
  sizes.min = keys.min;
  sizes.max = keys.max;
  return sizes;
}

void place(ParticleGroup& group, const ParticleKeys& keys, const DomainKeys& domain) {
  using Placement = ParticleGroup::Placement;
  group.placement = keys.insert == "lattice"  ? Placement::lattice
                    : keys.insert == "random" ? Placement::random
                    : keys.insert == "rate"   ? Placement::feed
                                              : Placement::given;
  // The region of a feed may be a point.
  const bool whole_domain = keys.region_min == keys.region_max && keys.insert != "rate";
  group.region_min = whole_domain ? domain.min : keys.region_min;
  group.region_max = whole_domain ? domain.max : keys.region_max;
  group.count = keys.count;
  group.solid_fraction = keys.solid_fraction;
  group.spacing = keys.spacing;
  group.jitter = keys.jitter;
  group.attempts = keys.attempts;
  if (keys.insert == "file") group.given = read_particle_table(keys.file);
  if (keys.insert == "positions")
    for (const Vec3& x : keys.positions) group.given.push_back({x, {}, {}, {}, {}, {}});
}

void take_shape(ParticleGroup& group, const ParticleKeys& keys) {
  using Kind = Orientations::Kind;
  if (keys.shape == "sphere" || keys.insert == "checkpoint") return;
  group.shape = make_form(keys.shape, keys.half_axes, keys.exponents[0], keys.exponents[1]);
  const OrientationKeys& o = keys.orientation;
  group.orientations.kind = o.type == "random" ? Kind::random : o.type == "aligned" ? Kind::aligned : Kind::given;
  group.orientations.spread = o.spread;
  if (!o.quaternion.empty()) {
    const std::vector<double>& q = o.quaternion;
    group.orientations.base = sc_quat_of_length_one({q[0], q[1], q[2], q[3]});
  } else if (o.angle != 0) {
    const sc_vec axis = sc_make_vec(o.axis[0], o.axis[1], o.axis[2]);
    group.orientations.base = sc_quat_of_turn(sc_scale(o.angle / sc_norm(axis), axis));
  }
}

/// What is fixed has no velocity, whatever a shared file of positions says.
void rest(ParticleGroup& group) {
  group.start = ParticleGroup::Start::given;
  group.velocity = group.angular_velocity = {};
  for (GivenParticle& given : group.given) given.velocity = given.angular_velocity = std::nullopt;
}

ParticleGroup group_of(const Case& c, const ParticleKeys& keys) {
  using Start = ParticleGroup::Start;
  ParticleGroup group;
  group.name = keys.name;
  group.material = material_index(c, keys.material);
  group.density = c.materials[group.material].density;
  group.sizes = sizes_of(keys.diameter);
  take_shape(group, keys);
  // A round shape that is no 'sphere' has vertices as others have.
  if (by_vertices(c) && keys.shape != "sphere") group.shape.shape.is_sphere = 0;
  group.effect_gap = keys.effect_gap;
  group.free = keys.motion == "free";
  place(group, keys, c.domain);
  group.start = keys.velocity.type == "random"  ? Start::random
                : keys.velocity.type == "fluid" ? Start::fluid
                                                : Start::given;
  group.velocity = keys.velocity.value;
  group.velocity_deviation = keys.velocity.deviation;
  group.angular_velocity = keys.angular_velocity;
  if (keys.motion == "fixed") rest(group);
  return group;
}

}  // namespace

std::vector<ParticleGroup> build_groups(const Case& c, Takeover takeover) {
  std::vector<ParticleGroup> groups;
  for (const ParticleKeys& keys : c.particles) {
    groups.push_back(group_of(c, keys));
    if (keys.insert != "checkpoint" || takeover == Takeover::skip) continue;
    groups.back().given = take_over(c, keys);
    if (keys.motion == "fixed") rest(groups.back());
  }
  return groups;
}

Particles build_particles(const Case& c, const Domain& domain, const Walls& walls, const FluidVelocity& fluid,
                          Forms& forms, const InsertionOptions& options) {
  const std::vector<ParticleGroup> groups = build_groups(c, options.takeover);
  forms = forms_of(groups);
  InsertionSetting setting;
  setting.domain = domain;
  setting.walls = &walls;
  setting.seed = c.simulation.seed;
  setting.max_overlap = c.simulation.max_overlap;
  setting.fluid = fluid;
  setting.forms = forms;
  setting.watch = options.watch;
  return insert_particles(groups, setting);
}

}  // namespace scree
