#include "scree/app/prescribed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"

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

void wrap(const Domain& domain, double& x, std::int32_t& image, int axis) {
  if (!domain.periodic[axis]) return;
  if (x < domain.min[axis]) {
    x += domain.period(axis);
    --image;
  }
  if (x >= domain.max[axis]) {
    x -= domain.period(axis);
    ++image;
  }
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
    const std::array<double, 3> v = velocity_of(group, start, time);
    const double* m = particles.motion.row(i) + lane::vx;
    field[i].acceleration = sc_make_vec((v[0] - m[0]) / lag, (v[1] - m[1]) / lag, (v[2] - m[2]) / lag);
  });
}

void look_ahead(std::vector<PrescribedGroup>& groups, const Particles& particles, double now, double dt) {
  for_each_body(groups, particles, [&](PrescribedGroup& group, std::size_t, const std::array<double, 3>& start) {
    velocity_of(group, start, now + 0.5 * dt);
    velocity_of(group, start, now + dt);
  });
}

double carry(std::vector<PrescribedGroup>& groups, Particles& particles, const Domain& domain, double now, double dt,
             bool leapfrog) {
  double fastest2 = 0;
  for_each_body(groups, particles, [&](PrescribedGroup& group, std::size_t i, const std::array<double, 3>& start) {
    const std::array<double, 3> drift = velocity_of(group, start, now + 0.5 * dt);
    const std::array<double, 3> velocity = leapfrog ? drift : velocity_of(group, start, now + dt);
    double* m = particles.motion.row(i);
    if (particles.shaped()) {
      double off2 = 0;
      for (int k = 0; k < 3; ++k) off2 += (drift[k] - m[lane::vx + k]) * (drift[k] - m[lane::vx + k]);
      particles.angular_momentum.row(i)[lane::path] += 1.000001 * dt * std::sqrt(off2);
    }
    for (int k = 0; k < 3; ++k) {
      m[k] += dt * (drift[k] - m[lane::vx + k]);
      m[lane::vx + k] = velocity[k];
      wrap(domain, m[k], particles.image.row(i)[k], k);
    }
    fastest2 = std::max(fastest2, drift[0] * drift[0] + drift[1] * drift[1] + drift[2] * drift[2]);
  });
  return std::sqrt(fastest2);
}

}  // namespace scree
