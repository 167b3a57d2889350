#include "scree/particles/heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/base/error.h"
#include "scree/base/exact_sum.h"
#include "scree/compute/launch.h"
#include "scree/mpi/together.h"
#include "scree/particles/contact_state.h"
#include "scree/physics/heat/conduction.h"

namespace scree {
namespace {

constexpr int bits_of_largest = 48;  // of the largest flow through a contact, as a whole number
constexpr double most_given = 0.5;   // of a difference of temperature, in a step

/// Heat that passes a contact in a step, and the conductance it takes [J], [W/K].
struct Flow {
  double heat = 0, conductance = 0;
};

double circle(const HeatProperties& h, double effective_radius, double overlap) {
  return h.contact_radius * sc_hertz_circle(effective_radius, overlap);
}

/// From the owner of a pair to its partner.
Flow flow_of_pair(const HeatProperties& h, const ParticleSystem& s, std::size_t c, double time) {
  const double overlap = overlap_of_pair(s, c);
  if (overlap <= 0) return {};
  const Particles& p = s.particles;
  const auto i = static_cast<std::size_t>(s.contacts.pairs.owner[c]);
  const auto j = static_cast<std::size_t>(s.contacts.pairs.partner[c]);
  const double a = p.radius_by_volume(i), b = p.radius_by_volume(j);
  const double one = h.conductivity[static_cast<std::size_t>(p.material[i])];
  const double other = h.conductivity[static_cast<std::size_t>(p.material[j])];
  // Other ranks may hold the pair the other way round: the same numbers in the same order.
  const double conductance =
      sc_contact_conductance(circle(h, a * b / (a + b), overlap), std::min(one, other), std::max(one, other));
  return {conductance * (p.heat.row(i)[lane::temperature] - p.heat.row(j)[lane::temperature]) * time, conductance};
}

/// From a particle into the wall of its contact w.
Flow flow_of_wall(const HeatProperties& h, const ParticleSystem& s, std::size_t p, std::int32_t w, double time) {
  const std::int32_t face = s.wall_contacts.wall[w];
  const std::optional<double>& wall = h.wall_temperature[static_cast<std::size_t>(s.walls.faces[face].body)];
  if (!wall || !s.wall_contacts.active[w]) return {};
  const double overlap = overlap_of_wall(s, p, w);
  if (overlap <= 0) return {};
  const double conductance = sc_wall_conductance(circle(h, s.particles.radius_by_volume(p), overlap),
                                                 h.conductivity[static_cast<std::size_t>(s.particles.material[p])]);
  return {conductance * (s.particles.heat.row(p)[lane::temperature] - *wall) * time, conductance};
}

/// What all contacts do in a step.
struct Flows {
  Buffer<double> pairs, walls;      // heat from the owner to the partner, from the particle to the wall [J]
  std::vector<double> conductance;  // that each particle has in all; of rounding that depends on the order [W/K]
};

Flows find_flows(const HeatProperties& h, const ParticleSystem& s, double time) {
  Flows out;
  Buffer<double> conductance(s.contacts.pairs.count);
  out.pairs.resize(s.contacts.pairs.count);
  out.walls.resize(s.wall_contacts.wall.size());
  out.conductance.assign(s.particles.held(), 0.0);
  launch(s.contacts.pairs.count, [&](std::size_t c) {
    const Flow flow = flow_of_pair(h, s, c, time);
    out.pairs[c] = flow.heat;
    conductance[c] = flow.conductance;
  });
  launch(s.particles.size(), [&](std::size_t i) {
    for (std::int32_t w = s.wall_contacts.first[i]; w < s.wall_contacts.first[i + 1]; ++w) {
      const Flow flow = flow_of_wall(h, s, i, w, time);
      out.walls[w] = flow.heat;
      out.conductance[i] += flow.conductance;
    }
  });
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (conductance[c] == 0) continue;
    out.conductance[static_cast<std::size_t>(s.contacts.pairs.owner[c])] += conductance[c];
    out.conductance[static_cast<std::size_t>(s.contacts.pairs.partner[c])] += conductance[c];
  }
  return out;
}

/// A power of two that makes whole numbers of the flows of all ranks; 0 where nothing flows.
double scale_of(const Flows& flows, const Ranks& ranks) {
  double largest = 0;
  for (const Buffer<double>* of : {&flows.pairs, &flows.walls})
    for (std::size_t k = 0; k < of->size(); ++k) largest = std::max(largest, std::abs((*of)[k]));
  largest = ranks.largest(largest);
  return largest > 0 ? std::ldexp(1.0, bits_of_largest - std::ilogb(largest)) : 0;
}

void expect_slow(const ParticleSystem& s, const Flows& flows, double time, const Ranks& ranks) {
  double share = 0;
  for (std::size_t i = 0; i < s.particles.size(); ++i)
    share = std::max(share, flows.conductance[i] * time / s.particles.heat.row(i)[lane::heat_capacity]);
  share = ranks.largest(share);
  if (!(share <= most_given))
    throw PhysicsError(
        fmt::format("a particle would conduct {:.2g} of its difference of temperature in {:.3g} s, at most {} can be "
                    "followed\n  = help: a smaller heat.every or time step, or a smaller heat.contact_radius",
                    share, time, most_given));
}

}  // namespace

void warm_up(const HeatProperties& h, Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    double* heat = p.heat.row(i);
    if (heat[lane::heat_capacity] > 0) continue;
    heat[lane::temperature] = h.given[static_cast<std::size_t>(p.group[i])];
    heat[lane::heat_capacity] = p.mass[i] * h.capacity[static_cast<std::size_t>(p.material[i])];
  }
}

double heat_content(const Particles& p, const Ranks& ranks) {
  ExactSum sum;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum.add(p.heat.row(i)[lane::temperature] * p.heat.row(i)[lane::heat_capacity]);
  return everywhere(sum, ranks);
}

HeatFacts heat_facts(const Particles& p, const Ranks& ranks) {
  HeatFacts out;
  ExactSum capacity;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < p.size(); ++i) {
    lowest = std::min(lowest, p.heat.row(i)[lane::temperature]);
    highest = std::max(highest, p.heat.row(i)[lane::temperature]);
    capacity.add(p.heat.row(i)[lane::heat_capacity]);
  }
  out.content = heat_content(p, ranks);
  const double all = everywhere(capacity, ranks);
  out.lowest = -ranks.largest(-lowest);
  out.highest = ranks.largest(highest);
  if (all > 0) out.mean = out.content / all;
  return out;
}

void conduct(const HeatProperties& h, ParticleSystem& s, const Ranks& ranks, double time, HeatBooks& books) {
  const Flows flows = find_flows(h, s, time);
  expect_slow(s, flows, time, ranks);
  const double scale = scale_of(flows, ranks);
  if (scale == 0) return;
  std::vector<std::int64_t> gain(s.particles.held(), 0);
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (flows.pairs[c] == 0) continue;
    const std::int64_t passed = std::llround(flows.pairs[c] * scale);
    gain[static_cast<std::size_t>(s.contacts.pairs.owner[c])] -= passed;
    gain[static_cast<std::size_t>(s.contacts.pairs.partner[c])] += passed;
  }
  ExactSum to_walls;
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    for (std::int32_t w = s.wall_contacts.first[i]; w < s.wall_contacts.first[i + 1]; ++w) {
      const std::int64_t passed = std::llround(flows.walls[w] * scale);
      gain[i] -= passed;
      to_walls.add(static_cast<double>(passed) / scale);
    }
    double* heat = s.particles.heat.row(i);
    heat[lane::temperature] += static_cast<double>(gain[i]) / scale / heat[lane::heat_capacity];
  }
  books.from_walls -= everywhere(to_walls, ranks);
}

}  // namespace scree
