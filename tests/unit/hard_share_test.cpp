// What a flat contact remembers of the loads on its feet is all that matters to its two bodies.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scree/particles/hard/share.h"

namespace scree {
namespace {

/// A contact with feet around its middle, in a plane that is not that of the axes.
struct Flat {
  HardContact contact;
  std::array<HardPoint, 1 + hard_feet> points;

  std::span<HardPoint> all() { return {points.data(), static_cast<std::size_t>(contact.points)}; }
};

double draw(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) * 0x1p-53;
}

/// Feet at the corners of an uneven quadrangle with loads that push and friction within its limit.
Flat random_contact(std::uint64_t& state, int feet, double friction) {
  Flat f;
  f.contact.points = static_cast<std::int8_t>(1 + feet);
  f.contact.push = sc_make_vec(0.6, 0, 0.8);
  f.contact.along = sc_make_vec(0.8, 0, -0.6);
  const sc_vec aside = sc_cross(f.contact.along, f.contact.push);
  constexpr double side[hard_feet][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const sc_vec from = sc_make_vec(0.1, 0.2, 0.3);
  for (int k = 0; k < feet; ++k) {
    HardPoint& p = f.points[1 + k];
    const double x = side[k][0] * (1 + draw(state)), y = side[k][1] * (0.5 + draw(state));
    p.arm_a = sc_add_scaled(sc_add_scaled(from, x, f.contact.along), y, aside);
    const double load = k == 1 && draw(state) < 0.3 ? 0 : draw(state), size = friction * load * draw(state),
                 angle = 6.3 * draw(state);
    p.held = sc_add_scaled(sc_add_scaled(sc_scale(load, f.contact.push), size * std::cos(angle), f.contact.along),
                           size * std::sin(angle), aside);
  }
  // The first point is in the middle of the feet.
  sc_vec middle{};
  for (int k = 1; k <= feet; ++k) middle = sc_add_scaled(middle, 1.0 / feet, f.points[k].arm_a);
  f.points[0].arm_a = middle;
  return f;
}

/// Sum and moment about the middle of what holds the points.
std::array<double, 6> effect(const Flat& f) {
  sc_vec sum{}, moment{};
  for (int k = 1; k < f.contact.points; ++k) {
    const HardPoint& p = f.points[k];
    sum = sc_add(sum, p.held);
    moment = sc_add(moment, sc_cross(sc_sub(p.arm_a, f.points[0].arm_a), p.held));
  }
  return {sum.x, sum.y, sum.z, moment.x, moment.y, moment.z};
}

TEST(HardShare, FeetTakeUpTheirLoadsWithTheSameEffect) {
  std::uint64_t state = 7;
  for (int k = 0; k < 400; ++k) {
    Flat f = random_contact(state, 3 + k % 2, 0.5);
    const std::array<double, 6> before = effect(f);
    f.contact.held = sc_make_vec(before[0], before[1], before[2]);
    note_moments(f.contact, f.all());
    for (HardPoint& p : f.all()) p.held = sc_zero_vec();
    share_out(f.contact, f.all());
    const std::array<double, 6> after = effect(f);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(after[i], before[i], 1e-8) << k << ' ' << i;
    for (const HardPoint& p : f.all()) EXPECT_GE(sc_dot(f.contact.push, p.held), -1e-12) << k;
  }
}

// A foot that bears nearly all, and feet nearly in a row, are given no more than there is.
TEST(HardShare, FeetAreNeverGivenMoreThanThereIs) {
  std::uint64_t state = 9;
  for (int k = 0; k < 400; ++k) {
    Flat f = random_contact(state, 2 + k % 3, 0.5);
    const double width = std::pow(10, -12 * draw(state));
    const sc_vec aside = sc_cross(f.contact.along, f.contact.push);
    for (HardPoint& p : f.all()) {
      const sc_vec way = sc_sub(p.arm_a, f.points[0].arm_a);
      p.arm_a = sc_add_scaled(p.arm_a, (width - 1) * sc_dot(way, aside), aside);
    }
    const std::array<double, 6> before = effect(f);
    f.contact.held = sc_make_vec(before[0], before[1], before[2]);
    f.contact.lean[0] = draw(state) - 0.5;
    f.contact.lean[1] = draw(state) - 0.5;
    f.contact.twist = draw(state) - 0.5;
    share_out(f.contact, f.all());
    const double load = sc_dot(f.contact.push, f.contact.held);
    for (const HardPoint& p : f.all()) EXPECT_LE(sc_dot(f.contact.push, p.held), load * (1 + 1e-9)) << k;
  }
}

}  // namespace
}  // namespace scree
