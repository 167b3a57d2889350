// The books of motions whose energies and momenta are known in closed form, with and without a channel left out.
#include "scree/analysis/ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"

namespace scree {
namespace {

/// A mass of 2 kg on a damped spring, thrown at 3 m/s, with gravity along the spring, by closed form:
/// x'' + 2 b x' + w^2 x = g with b = 0.4 / s, w = 5 / s, g = 1 m/s2.
Measured damped_oscillator(double t) {
  const double m = 2, b = 0.4, w = 5, g = 1, v0 = 3;
  const double d = std::sqrt(w * w - b * b), rest = g / (w * w);
  // x = rest + e^(-b t) (p cos d t + q sin d t)
  const double p = -rest, q = (v0 + b * p) / d;
  const auto position = [&](double s) { return rest + std::exp(-b * s) * (p * std::cos(d * s) + q * std::sin(d * s)); };
  const auto speed = [&](double s) {
    return std::exp(-b * s) * ((q * d - b * p) * std::cos(d * s) - (p * d + b * q) * std::sin(d * s));
  };
  // The loss is the integral of 2 b m v^2, by Simpson's rule.
  const int panels = 4000;
  double loss = 0;
  for (int i = 0; i <= panels; ++i) {
    const double weight = i == 0 || i == panels ? 1 : i % 2 ? 4 : 2;
    loss += weight * std::pow(speed(t * i / panels), 2);
  }
  loss *= 2 * b * m * t / panels / 3;
  Measured now;
  now.kinetic = 0.5 * m * speed(t) * speed(t);
  now.elastic = 0.5 * m * w * w * position(t) * position(t);
  now.body_work = m * g * position(t);
  now.dissipated_normal = loss;
  return now;
}

TEST(Ledger, EnergyOfADampedOscillatorCloses) {
  const Books books = open_books(damped_oscillator(0));
  EXPECT_DOUBLE_EQ(books.turnover, 9.0);  // 2 kg at 3 m/s
  for (const double t : {0.1, 0.7, 2.0, 5.0}) {
    const Measured now = damped_oscillator(t);
    const LedgerRow row = balance(books, now, false);
    EXPECT_NEAR(row.energy_error, 0, 1e-8);
    EXPECT_NO_THROW(check_books(books, now, 1e-8, t));
  }
}

TEST(Ledger, LeavingAChannelOutBreaksTheBooksByItsAmount) {
  const Books books = open_books(damped_oscillator(0));
  for (const char* name : {"normal", "body"}) {
    Measured now = damped_oscillator(2.0);
    const double missing = std::string(name) == "normal" ? -now.dissipated_normal : now.body_work;
    leave_out(now, std::vector<std::string>{name});
    EXPECT_NEAR(balance(books, now, false).energy_error, missing, 1e-8);
    EXPECT_GT(std::abs(missing), 1e-3);
    EXPECT_THROW(check_books(books, now, 1e-5, 2.0), PhysicsError);
  }
}

// Every account of its own: one joule in it, and the joule where it came from.
TEST(Ledger, EveryAccountHasItsSign) {
  const auto error = [](auto change) {
    Measured now;
    change(now);
    return balance(open_books({}), now, false).energy_error;
  };
  EXPECT_EQ(error([](Measured& m) { m.kinetic = m.body_work = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.rotational = m.drag_work = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.elastic = m.prescribed_work = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.cohesive = -1, m.dissipated_normal = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.dissipated_sliding = m.body_work = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.dissipated_rolling = m.body_work = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.body_work = -1, m.relocation_work = 1; }), 0);
  EXPECT_EQ(error([](Measured& m) { m.kinetic = 1; }), 1);
  EXPECT_EQ(error([](Measured& m) { m.dissipated_rolling = 1; }), 1);
  EXPECT_EQ(error([](Measured& m) { m.drag_work = 1; }), -1);
}

TEST(Ledger, KnowsItsChannels) {
  // Each channel holds another power of two, so that the sum tells which one is missing.
  const std::vector<std::string> names{"normal",           "sliding",        "rolling",    "drag",     "body",
                                       "prescribed",       "walls",          "relocation", "inserted", "removed",
                                       "momentum_impulse", "angular_impulse"};
  ASSERT_TRUE(std::equal(names.begin(), names.end(), ledger_channels().begin(), ledger_channels().end()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    Measured all;
    all.dissipated_normal = 1;
    all.dissipated_sliding = 2;
    all.dissipated_rolling = 4;
    all.drag_work = 8;
    all.body_work = 16;
    all.prescribed_work = 32;
    all.wall_work = 64;
    all.relocation_work = 128;
    all.inserted = 128 + 64;
    all.inserted_momentum[0] = 32;
    all.inserted_angular_momentum[1] = 32;
    all.removed = 256 + 128;
    all.removed_momentum[2] = 64;
    all.removed_angular_momentum[0] = 64;
    all.impulse[1] = 1024;
    all.angular_impulse[2] = 2048;
    leave_out(all, std::vector<std::string>{names[i]});
    const double left = all.body_work + all.drag_work + all.prescribed_work + all.wall_work + all.relocation_work +
                        all.dissipated_normal + all.dissipated_sliding + all.dissipated_rolling + all.impulse[1] +
                        all.angular_impulse[2] + all.inserted + all.inserted_momentum[0] +
                        all.inserted_angular_momentum[1] + all.removed + all.removed_momentum[2] +
                        all.removed_angular_momentum[0];
    EXPECT_EQ(left, 4095 - std::exp2(static_cast<double>(i))) << names[i];
  }
  Measured any;
  try {
    leave_out(any, std::vector<std::string>{"friction"});
    FAIL() << "an unknown channel was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'friction'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("sliding"), std::string::npos);
  }
}

// A ball of 1 N weight falls by 1 m, is caught by a spring and thrown back: one joule moves four times.
TEST(Ledger, TurnoverCountsWhatMoved) {
  const Measured top{};
  Measured bottom, squeezed;
  bottom.kinetic = bottom.body_work = 1;
  squeezed.elastic = squeezed.body_work = 1;
  Books books = open_books(top);
  EXPECT_EQ(balance(books, top, false).relative_energy_error(), 0);
  for (const Measured& state : {bottom, squeezed, bottom}) enter(books, state);
  const LedgerRow row = balance(books, top, false);
  EXPECT_DOUBLE_EQ(row.turnover, 4.0);
  EXPECT_DOUBLE_EQ(row.energy_error, 0.0);
  Measured lossy = top;
  lossy.kinetic = -0.004;
  EXPECT_NEAR(balance(books, lossy, false).relative_energy_error(), -0.001, 1e-6);
}

TEST(Ledger, BalanceIsNoEntry) {
  Books books = open_books(damped_oscillator(0));
  const auto before = books_as_numbers(books);
  balance(books, damped_oscillator(1), false);
  EXPECT_EQ(books_as_numbers(books), before);
  enter(books, damped_oscillator(1));
  EXPECT_NE(books_as_numbers(books), before);
}

TEST(Ledger, MomentumClosesWithTheImpulse) {
  Measured start, now;
  start.momentum = {1, 2, 3};
  start.angular_momentum = {0, 0, 5};
  start.momentum_scale = 10;
  now.momentum = {1, 2 - 4, 3};
  now.impulse = {0, -4, 0};
  now.angular_momentum = {0, 7, 5};
  now.angular_impulse = {0, 7, 0};
  const Books books = open_books(start);
  EXPECT_EQ(balance(books, now, false).momentum_error, 0);
  EXPECT_EQ(balance(books, now, false).angular_momentum_error, 0);
  EXPECT_TRUE(std::isnan(balance(books, now, true).angular_momentum_error));
  now.momentum[0] += 0.3;
  now.momentum[2] -= 0.4;
  now.angular_momentum[0] = -2;
  const LedgerRow row = balance(books, now, false);
  EXPECT_NEAR(row.momentum_error, 0.5, 1e-15);
  EXPECT_NEAR(row.relative_momentum_error, 0.05, 1e-15);
  EXPECT_NEAR(row.angular_momentum_error, 2, 1e-15);
  leave_out(now, std::vector<std::string>{"momentum_impulse", "angular_impulse"});
  EXPECT_NEAR(balance(books, now, false).momentum_error, std::sqrt(0.25 + 16), 1e-14);
  EXPECT_NEAR(balance(books, now, false).angular_momentum_error, std::sqrt(53), 1e-14);
}

TEST(Ledger, SaysWhatDoesNotAddUp) {
  Measured start, now;
  start.kinetic = 4;
  now.kinetic = 3;
  now.dissipated_sliding = 0.25;
  const Books books = open_books(start);
  try {
    check_books(books, now, 0.01, 0.125);
    FAIL() << "the books were accepted";
  } catch (const PhysicsError& error) {
    const std::string text = error.what();
    for (const char* part : {"t = 0.125 s", "7.500e-01 J are too few", "loss by sliding", "2.50000e-01",
                             "ledger.energy_tolerance", "simulation.steps_per_contact"}) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    }
  }
  now.kinetic = std::nan("");
  EXPECT_THROW(check_books(books, now, 1e9, 0), PhysicsError);
}

TEST(Ledger, ShowsAShortLine) {
  LedgerRow row;
  row.turnover = 2;
  row.energy_error = -0.0042;
  row.relative_momentum_error = 3.14e-16;
  EXPECT_EQ(ledger_line(row), "energy error 0.21 %, momentum error 3.1e-16");
}

TEST(Ledger, TravelsThroughACheckpoint) {
  Books books = open_books(damped_oscillator(0));
  enter(books, damped_oscillator(0.3));
  books.last.angular_impulse = {1, -0.0, 1e-320};
  const std::vector<double> numbers = books_as_numbers(books);
  EXPECT_EQ(books_as_numbers(books_from_numbers(numbers)), numbers);
  EXPECT_EQ(books_from_numbers(numbers).turnover, books.turnover);
  EXPECT_THROW(books_from_numbers(std::span(numbers).subspan(1)), InputError);
}

}  // namespace
}  // namespace scree
