#include "scree/particles/hard/course.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// The sum of all changes [J], in whole parts of the largest, so that it is the same in any order and on any number of
/// ranks.
double size_of(const HardContacts& h, const Bearings& bearings) {
  double largest = 0;
  for (const double change : bearings.change) largest = std::max(largest, change);
  largest = h.ranks.largest(largest);
  if (!(largest > 1e-270)) return 0;
  if (!std::isfinite(largest)) return largest;
  // There is room for four million contacts.
  const double parts = std::ldexp(1, 40 - std::ilogb(largest));
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < bearings.change.size(); ++k)
    if (static_cast<std::size_t>(bearings.all[k].a) < h.own) sum += std::llround(bearings.change[k] * parts);
  return static_cast<double>(h.ranks.total(sum)) / parts;
}

}  // namespace

Course::Course(const HardContacts& h) : before_(h.own), course_(h.own) {
  for (std::size_t i = 0; i < before_.size(); ++i) before_[i] = {h.bodies[i].velocity, h.bodies[i].spin};
}

void Course::go_on(HardContacts& h, Bearings& bearings) {
  const double size = size_of(h, bearings);
  const double share = last_ > 0 ? size / last_ : 0;
  last_ = size;
  // A change that grows has lost its way: start again.
  const bool again = !(share <= 1);
  const auto carry_on = [&](sc_vec& value, sc_vec before, sc_vec& course) {
    if (again) {
      course = sc_zero_vec();
      return;
    }
    const sc_vec change = sc_sub(value, before), more = sc_scale(share, course);
    value = sc_add(value, more);
    course = sc_add(more, change);
  };
  for (BearingPoint& p : bearings.points) carry_on(p.held, p.before, p.course);
  for (BearingTurn& t : bearings.turns) carry_on(t.couple, t.before, t.course);
  move_bodies(h, share, again);
}

void Course::move_bodies(HardContacts& h, double share, bool again) {
  for (std::size_t i = 0; i < before_.size(); ++i) {
    HardBody& body = h.bodies[i];
    Motion& course = course_[i];
    if (again) {
      course = {};
    } else {
      const Motion change{sc_sub(body.velocity, before_[i].velocity), sc_sub(body.spin, before_[i].spin)};
      const Motion more{sc_scale(share, course.velocity), sc_scale(share, course.spin)};
      body.velocity = sc_add(body.velocity, more.velocity);
      body.spin = sc_add(body.spin, more.spin);
      course = {sc_add(more.velocity, change.velocity), sc_add(more.spin, change.spin)};
    }
    before_[i] = {body.velocity, body.spin};
  }
}

}  // namespace scree
