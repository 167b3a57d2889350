// Double-entry bookkeeping of energy and momentum.
#include "scree/analysis/ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "scree/base/error.h"

namespace scree {
namespace {

using Vector = std::array<double, 3>;

static_assert(std::is_trivially_copyable_v<Books> && sizeof(Books) % sizeof(double) == 0);
constexpr std::size_t numbers_in_books = sizeof(Books) / sizeof(double);

/// One account of the energy: how it enters the balance, and its names in messages and for leave_out().
struct Account {
  double Measured::*amount;
  double sign;       // +1: energy that is there or lost; -1: work that has come in
  bool store;        // energy that the particles hold, rather than a total of exchanges
  const char* what;  // in messages
};

constexpr std::array<Account, 14> accounts{{
    {&Measured::kinetic, 1, true, "kinetic energy"},
    {&Measured::rotational, 1, true, "rotational energy"},
    {&Measured::elastic, 1, true, "elastic energy"},
    {&Measured::cohesive, 1, true, "cohesive energy"},
    {&Measured::body_work, -1, false, "work of body forces"},
    {&Measured::drag_work, -1, false, "work of drag"},
    {&Measured::prescribed_work, -1, false, "work of prescribed bodies"},
    {&Measured::wall_work, -1, false, "work of walls"},
    {&Measured::relocation_work, -1, false, "work of relocation"},
    {&Measured::inserted, -1, false, "inserted energy"},
    {&Measured::removed, 1, false, "removed energy"},
    {&Measured::dissipated_normal, 1, false, "loss by normal damping"},
    {&Measured::dissipated_sliding, 1, false, "loss by sliding"},
    {&Measured::dissipated_rolling, 1, false, "loss by rolling"},
}};

/// What impulses and particles have added.
Vector added(const Vector& impulse, const Vector& inserted, const Vector& removed) {
  return {impulse[0] + (inserted[0] - removed[0]), impulse[1] + (inserted[1] - removed[1]),
          impulse[2] + (inserted[2] - removed[2])};
}

Vector added_momentum(const Measured& m) { return added(m.impulse, m.inserted_momentum, m.removed_momentum); }

Vector added_angular_momentum(const Measured& m) {
  return added(m.angular_impulse, m.inserted_angular_momentum, m.removed_angular_momentum);
}

/// |now - start - added|.
double closure(const Vector& now, const Vector& start, const Vector& added, const Vector& added_at_start) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double error = (now[axis] - start[axis]) - (added[axis] - added_at_start[axis]);
    squared += error * error;
  }
  return std::sqrt(squared);
}

/// A fraction of something, where nothing of nothing is nothing.
double relative(double error, double scale) { return error == 0 ? 0.0 : error / scale; }

/// Energy that changed place between two states [J].
double moved(const Measured& before, const Measured& after) {
  double sum = 0;
  for (const Account& account : accounts) sum += std::abs(after.*account.amount - before.*account.amount);
  return 0.5 * sum;
}

}  // namespace

double LedgerRow::relative_energy_error() const { return relative(energy_error, turnover); }

std::span<const std::string> ledger_channels() {
  static const std::array<std::string, 12> names{
      "normal",   "sliding", "rolling",          "drag",           "body", "prescribed", "walls", "relocation",
      "inserted", "removed", "momentum_impulse", "angular_impulse"};
  return names;
}

void leave_out(Measured& measured, std::span<const std::string> channels) {
  for (const std::string& name : channels) {
    if (name == "normal") {
      measured.dissipated_normal = 0;
    } else if (name == "sliding") {
      measured.dissipated_sliding = 0;
    } else if (name == "rolling") {
      measured.dissipated_rolling = 0;
    } else if (name == "drag") {
      measured.drag_work = 0;
    } else if (name == "body") {
      measured.body_work = 0;
    } else if (name == "prescribed") {
      measured.prescribed_work = 0;
    } else if (name == "walls") {
      measured.wall_work = 0;
    } else if (name == "relocation") {
      measured.relocation_work = 0;
    } else if (name == "inserted") {
      measured.inserted = 0;
      measured.inserted_momentum = measured.inserted_angular_momentum = {};
    } else if (name == "removed") {
      measured.removed = 0;
      measured.removed_momentum = measured.removed_angular_momentum = {};
    } else if (name == "momentum_impulse") {
      measured.impulse = {};
    } else if (name == "angular_impulse") {
      measured.angular_impulse = {};
    } else {
      throw InputError(
          fmt::format("the ledger has no channel '{}'; it has: {}", name, fmt::join(ledger_channels(), ", ")));
    }
  }
}

Books open_books(const Measured& start) {
  Books books{start, start, 0, start.momentum_scale};
  for (const Account& account : accounts) {
    if (account.store) books.turnover += std::abs(start.*account.amount);
  }
  return books;
}

LedgerRow balance(const Books& books, const Measured& now, bool any_periodic) {
  const Measured& start = books.start;
  LedgerRow row;
  for (const Account& account : accounts) {
    row.energy_error += account.sign * (now.*account.amount - start.*account.amount);
  }
  row.turnover = books.turnover + moved(books.last, now);
  row.momentum_error = closure(now.momentum, start.momentum, added_momentum(now), added_momentum(start));
  row.relative_momentum_error = relative(row.momentum_error, std::fmax(books.momentum_scale, now.momentum_scale));
  row.angular_momentum_error = any_periodic ? std::numeric_limits<double>::quiet_NaN()
                                            : closure(now.angular_momentum, start.angular_momentum,
                                                      added_angular_momentum(now), added_angular_momentum(start));
  return row;
}

void enter(Books& books, const Measured& now) {
  books.turnover += moved(books.last, now);
  books.momentum_scale = std::fmax(books.momentum_scale, now.momentum_scale);
  books.last = now;
}

void check_books(const Books& books, const Measured& now, double tolerance, double time) {
  const LedgerRow row = balance(books, now, true);
  if (std::abs(row.energy_error) <= tolerance * row.turnover) return;
  std::string text = fmt::format(
      "at t = {:.6g} s the energy books do not close: {:.3e} J are too {}, {:.3g} of the turnover of {:.3e} J, and "
      "ledger.energy_tolerance allows {:.3g}.\n  since the start{:>25}{:>15}{:>15}\n",
      time, std::abs(row.energy_error), row.energy_error < 0 ? "few" : "many", std::abs(row.relative_energy_error()),
      row.turnover, tolerance, "then [J]", "now [J]", "change [J]");
  for (const Account& account : accounts) {
    const double before = books.start.*account.amount, after = now.*account.amount;
    text += fmt::format("  {:<26}{:>14.5e}{:>15.5e}{:>15.5e}\n", account.what, before, after, after - before);
  }
  text +=
      "More steps per contact (simulation.steps_per_contact, or a smaller simulation.time_step) make the error "
      "smaller; it falls with the square of the time step.";
  throw PhysicsError(text);
}

std::string ledger_line(const LedgerRow& row) {
  return fmt::format("energy error {:.2g} %, momentum error {:.1e}", 100 * std::abs(row.relative_energy_error()),
                     row.relative_momentum_error);
}

std::vector<double> books_as_numbers(const Books& books) {
  const auto numbers = std::bit_cast<std::array<double, numbers_in_books>>(books);
  return {numbers.begin(), numbers.end()};
}

Books books_from_numbers(std::span<const double> numbers) {
  if (numbers.size() != numbers_in_books) {
    throw InputError(
        fmt::format("the ledger of the checkpoint has {} numbers instead of {}: it comes from another "
                    "version of the program and cannot be continued",
                    numbers.size(), numbers_in_books));
  }
  std::array<double, numbers_in_books> copy{};
  std::copy(numbers.begin(), numbers.end(), copy.begin());
  return std::bit_cast<Books>(copy);
}

}  // namespace scree
