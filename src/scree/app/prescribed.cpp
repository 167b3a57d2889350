#include "scree/app/prescribed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/app/vec3.h"
#include "scree/base/error.h"
#include "scree/kernels/wrap.h"
#include "scree/particles/box.h"

namespace scree {
namespace {

/// Calls visit(group, row, start) for every body of the groups.
template <class Visit>
void for_each_body(std::vector<PrescribedGroup>& groups, const Particles& particles, Visit&& visit) {
  for (PrescribedGroup& group : groups)
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const std::int64_t place = particles.id[i] - group.first;
      if (place < 0 || place >= static_cast<std::int64_t>(group.start.size())) continue;
      visit(group, i, group.start[static_cast<std::size_t>(place)]);
    }
}

/// Throws PhysicsError when the formulas give no finite number.
std::array<double, 3> velocity_of(PrescribedGroup& group, const std::array<double, 3>& start, double time) {
  const double at[4] = {start[0], start[1], start[2], time};
  const std::array<double, 3> v = {group.velocity[0](at), group.velocity[1](at), group.velocity[2](at)};
  if (!std::isfinite(v[0] + v[1] + v[2]))
    throw PhysicsError(
        fmt::format("t = {:.9g} s: the velocity of the body of '{}' that began at ({:.6g}, {:.6g}, {:.6g}) m is no "
                    "finite number, ({}, {}, {}). Mend the formulas of its particles.motion_velocity",
                    time, group.name, start[0], start[1], start[2], v[0], v[1], v[2]));
  return v;
}

}  // namespace

std::vector<PrescribedGroup> build_prescribed(const Case& c, const Particles& particles) {
  std::vector<PrescribedGroup> out;
  for (std::size_t g = 0; g < c.particles.size(); ++g) {
    if (c.particles[g].motion != "prescribed") continue;
    const auto& formula = c.particles[g].motion_velocity;
    const std::vector<std::string> variables = {"x", "y", "z", "t"};
    PrescribedGroup group{
        0,
        {},
        {Expression(formula[0], variables), Expression(formula[1], variables), Expression(formula[2], variables)},
        c.particles[g].name};
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (particles.group[i] != static_cast<std::int32_t>(g)) continue;
      if (group.start.empty()) group.first = particles.id[i];
      const double* m = particles.motion.row(i);
      group.start.push_back({m[lane::x], m[lane::y], m[lane::z]});
    }
    out.push_back(std::move(group));
  }
  return out;
}

void set_velocities(std::vector<PrescribedGroup>& groups, Particles& particles, double time) {
  for_each_body(groups, particles, [&](PrescribedGroup& group, std::size_t i, const std::array<double, 3>& start) {
    const std::array<double, 3> v = velocity_of(group, start, time);
    std::copy_n(v.data(), 3, particles.motion.row(i) + lane::vx);
  });
}

void set_accelerations(std::vector<PrescribedGroup>& groups, const Particles& particles, double time, double lag,
                       Buffer<sc_field>& field) {
  if (lag == 0) return;
  for_each_body(groups, particles, [&](PrescribedGroup& group, std::size_t i, const std::array<double, 3>& start) {
    const double* m = particles.motion.row(i) + lane::vx;
    const sc_prescribed p{vec_of(velocity_of(group, start, time)), {}, {}};
    field[i].acceleration = sc_prescribed_acceleration(p, sc_make_vec(m[0], m[1], m[2]), lag);
  });
}

void look_ahead(std::vector<PrescribedGroup>& groups, const Particles& particles, double now, double dt) {
  for_each_body(groups, particles, [&](PrescribedGroup& group, std::size_t, const std::array<double, 3>& start) {
    velocity_of(group, start, now + 0.5 * dt);
    velocity_of(group, start, now + dt);
  });
}

std::vector<sc_prescribed> prescribed_step(std::vector<PrescribedGroup>& groups, double now, double dt, double lag,
                                           bool leapfrog) {
  std::vector<sc_prescribed> out;
  for (PrescribedGroup& group : groups)
    for (const std::array<double, 3>& start : group.start) {
      const sc_vec middle = vec_of(velocity_of(group, start, now + 0.5 * dt));
      const sc_vec end = vec_of(velocity_of(group, start, now + dt));
      const sc_vec here = lag != 0 ? vec_of(velocity_of(group, start, now)) : sc_zero_vec();
      out.push_back({here, middle, leapfrog ? middle : end});
    }
  return out;
}

double carry(std::vector<PrescribedGroup>& groups, Particles& particles, const Domain& domain, double now, double dt,
             bool leapfrog) {
  double fastest2 = 0;
  const sc_box box = box_of(domain);
  for_each_body(groups, particles, [&](PrescribedGroup& group, std::size_t i, const std::array<double, 3>& start) {
    const sc_vec drift = vec_of(velocity_of(group, start, now + 0.5 * dt));
    const sc_prescribed p{{}, drift, leapfrog ? drift : vec_of(velocity_of(group, start, now + dt))};
    double* m = particles.motion.row(i);
    const sc_carried to = sc_carry(p, sc_make_vec(m[lane::x], m[lane::y], m[lane::z]),
                                   sc_make_vec(m[lane::vx], m[lane::vy], m[lane::vz]), dt);
    if (particles.shaped()) particles.angular_momentum.row(i)[lane::path] += to.way;
    const double place[3] = {to.position.x, to.position.y, to.position.z}, v[3] = {p.after.x, p.after.y, p.after.z};
    for (int k = 0; k < 3; ++k) {
      std::int32_t& image = particles.image.row(i)[k];
      const sc_wrapped w = sc_wrap(place[k], box.low[k], box.high[k], box.period[k], image);
      m[lane::x + k] = w.x;
      m[lane::vx + k] = v[k];
      image = w.image;
    }
    fastest2 = std::max(fastest2, sc_dot(drift, drift));
  });
  return std::sqrt(fastest2);
}

}  // namespace scree
