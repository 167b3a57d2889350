#include "scree/particles/hard/share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {
namespace {

/// Coordinates of a point in the plane of the contact, from its middle.
struct InPlane {
  double x = 0, y = 0;
};

InPlane in_plane(const HardContact& c, const HardPoint& middle, const HardPoint& p) {
  const sc_vec way = sc_sub(p.arm_a, middle.arm_a);
  return {sc_dot(way, c.along), sc_dot(way, sc_cross(c.along, c.push))};
}

/// Loads of the feet of a contact and where they are.
struct Loads {
  int count = 0;
  InPlane at[hard_feet];
  double load[hard_feet] = {};
};

/// The smallest loads with sum and moments of those remembered.
void take_smallest(const HardContact& c, Loads& l) {
  double xx = 0, xy = 0, yy = 0;
  for (int k = 0; k < l.count; ++k) {
    xx += l.at[k].x * l.at[k].x;
    xy += l.at[k].x * l.at[k].y;
    yy += l.at[k].y * l.at[k].y;
  }
  const double floor = 1e-9 * (xx + yy), determinant = (xx + floor) * (yy + floor) - xy * xy;
  const double even = sc_dot(c.push, c.held) / l.count;
  const double along = ((yy + floor) * c.lean[0] - xy * c.lean[1]) / determinant;
  const double across = ((xx + floor) * c.lean[1] - xy * c.lean[0]) / determinant;
  for (int k = 0; k < l.count; ++k) l.load[k] = even + along * l.at[k].x + across * l.at[k].y;
}

double area(InPlane a, InPlane b, InPlane c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Four feet: adds as little as need be of the loads that move nobody, so that nobody is pulled.
void leave_nobody_pulled(Loads& l) {
  if (l.count != 4) return;
  double idle[hard_feet];
  for (int k = 0; k < 4; ++k)
    idle[k] = (k % 2 ? -1 : 1) * area(l.at[(k + 1) % 4], l.at[(k + 2) % 4], l.at[(k + 3) % 4]);
  double least = -std::numeric_limits<double>::infinity(), most = -least;
  for (int k = 0; k < 4; ++k) {
    if (idle[k] > 0) least = std::max(least, -l.load[k] / idle[k]);
    if (idle[k] < 0) most = std::min(most, -l.load[k] / idle[k]);
  }
  if (!(least <= most)) return;
  const double share = std::clamp(0.0, least, most);
  for (int k = 0; k < 4; ++k) l.load[k] += share * idle[k];
}

/// Turns about the middle of the loads, with as much moment about the normal as is missing [N s / m].
struct Twist {
  InPlane middle;
  double strength = 0;
};

Twist missing_twist(const HardContact& c, const Loads& l, double sum, InPlane across) {
  Twist out;
  for (int k = 0; k < l.count; ++k) {
    out.middle.x += l.load[k] / sum * l.at[k].x;
    out.middle.y += l.load[k] / sum * l.at[k].y;
  }
  double weighted = 0, plain = 0;
  for (int k = 0; k < l.count; ++k) {
    const double x = l.at[k].x - out.middle.x, y = l.at[k].y - out.middle.y;
    weighted += l.load[k] / sum * (x * x + y * y);
    plain += (x * x + y * y) / l.count;
  }
  // One foot that bears nearly all cannot twist.
  const double moment = out.middle.x * across.y - out.middle.y * across.x;
  if (weighted > 1e-3 * plain) out.strength = (c.twist - moment) / weighted;
  return out;
}

}  // namespace

void share_out(HardContact& c, std::span<HardPoint> all) {
  const auto points = all.subspan(static_cast<std::size_t>(c.first_bearing()));
  if (points.size() == 1) {
    points[0].held = c.held;
    return;
  }
  Loads l;
  for (const HardPoint& p : points) l.at[l.count++] = in_plane(c, all[0], p);
  take_smallest(c, l);
  leave_nobody_pulled(l);
  // Feet nearly in a row answer a moment across the row with any load.
  const double all_load = std::max(sc_dot(c.push, c.held), 0.0);
  double sum = 0;
  for (int k = 0; k < l.count; ++k) sum += l.load[k] = std::clamp(l.load[k], 0.0, all_load);
  const sc_vec aside = sc_cross(c.along, c.push);
  const InPlane across{sc_dot(c.held, c.along), sc_dot(c.held, aside)};
  const Twist twist = sum > 0 ? missing_twist(c, l, sum, across) : Twist{};
  for (int k = 0; k < l.count; ++k) {
    HardPoint& p = points[static_cast<std::size_t>(k)];
    p.held = sc_zero_vec();
    if (!(l.load[k] > 0)) continue;
    const double share = l.load[k] / sum;
    const double x = share * (across.x - twist.strength * (l.at[k].y - twist.middle.y)),
                 y = share * (across.y + twist.strength * (l.at[k].x - twist.middle.x));
    p.held = sc_add_scaled(sc_add_scaled(sc_scale(l.load[k], c.push), x, c.along), y, aside);
  }
}

void note_moments(HardContact& c, std::span<const HardPoint> all) {
  c.lean[0] = c.lean[1] = c.twist = 0;
  if (c.points == 1) return;
  const sc_vec aside = sc_cross(c.along, c.push);
  for (const HardPoint& p : all.subspan(static_cast<std::size_t>(c.first_bearing()))) {
    const InPlane at = in_plane(c, all[0], p);
    const double load = sc_dot(c.push, p.held);
    c.lean[0] += load * at.x;
    c.lean[1] += load * at.y;
    c.twist += at.x * sc_dot(p.held, aside) - at.y * sc_dot(p.held, c.along);
  }
}

}  // namespace scree
