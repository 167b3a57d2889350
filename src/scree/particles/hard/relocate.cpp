#include "scree/particles/hard/relocate.h"

#include <algorithm>

#include "scree/particles/hard/colours.h"
#include "scree/particles/hard/look.h"

namespace scree {
namespace {

constexpr int sweeps = 5;

double weight(const HardContacts& h, std::int32_t body) { return body < 0 ? 0 : h.bodies[body].inverse_mass; }

/// How far the bodies of a contact are to be moved apart, after the ways that they have gone [m].
double excess(const HardContact& c, const std::vector<sc_vec>& way, double slop) {
  const sc_vec apart = c.at_wall() ? way[c.a] : sc_sub(way[c.a], way[c.b]);
  return c.overlap - sc_dot(apart, c.push) - slop * c.smaller;
}

void part(const HardContacts& h, const HardContact& c, std::vector<sc_vec>& way, double slop) {
  const double distance = excess(c, way, slop);
  if (!(distance > 0)) return;
  const double a = weight(h, c.a), b = weight(h, c.b);
  if (a > 0) way[c.a] = sc_add_scaled(way[c.a], distance * (a / (a + b)), c.push);
  if (b > 0) way[c.b] = sc_add_scaled(way[c.b], -distance * (b / (a + b)), c.push);
}

/// Brings the ways of copies to those of their originals.
void tell_ways(HardContacts& h, Telling& telling, std::vector<sc_vec>& way) {
  tell<3>(
      telling, h.ranks,
      [&](std::int32_t i, double* to) {
        to[0] = way[i].x;
        to[1] = way[i].y;
        to[2] = way[i].z;
      },
      [&](std::int32_t i, const double* from) { way[i] = sc_make_vec(from[0], from[1], from[2]); });
}

void book(Particles& p, std::size_t i, sc_vec way, sc_vec gravity) {
  const double* m = p.motion.row(i);
  const sc_vec velocity = sc_make_vec(m[lane::vx], m[lane::vy], m[lane::vz]);
  const sc_vec turned = sc_scale(p.mass[i], sc_cross(way, velocity));
  double* angular = p.angular_impulse.row(i);
  angular[0] += turned.x;
  angular[1] += turned.y;
  angular[2] += turned.z;
  p.loss.row(i)[3] += p.mass[i] * sc_dot(gravity, way);
}

}  // namespace

double relocate(ParticleSystem& s, HardContacts& h, const HardSettings& settings, sc_vec gravity) {
  const bool idle = std::none_of(h.all.begin(), h.all.end(),
                                 [&](const HardContact& c) { return c.overlap > settings.slop * c.smaller; });
  if (h.ranks.all(idle)) return 0;
  std::vector<sc_vec> way(s.particles.held(), sc_zero_vec());
  const auto before = [&](std::size_t colour) {
    if (!h.before_colour.empty()) tell_ways(h, h.before_colour[colour], way);
  };
  for (int sweep = 0; sweep < sweeps; ++sweep)
    visit_places(h, before, [&](std::size_t k) {
      part(h, h.all[h.order[k]], way, settings.slop);
      return 0.0;
    });
  // Wall after wall, so that a corner is left on both sides.
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const HardContact& c : h.all)
      if (c.at_wall()) part(h, c, way, settings.slop);
  tell_ways(h, h.all_copies, way);
  double farthest2 = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double square = sc_dot(way[i], way[i]);
    if (square == 0) continue;
    farthest2 = std::max(farthest2, square);
    double* m = s.particles.motion.row(i);
    m[0] += way[i].x;
    m[1] += way[i].y;
    m[2] += way[i].z;
    if (s.particles.shaped()) s.particles.angular_momentum.row(i)[lane::path] += 1.000001 * SC_SQRT(square);
    book(s.particles, i, way[i], gravity);
  }
  look_again_where_moved(s, h, way);
  return SC_SQRT(farthest2);
}

}  // namespace scree
