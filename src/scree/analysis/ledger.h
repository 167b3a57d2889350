// The books of energy, momentum and angular momentum: what came in, what went out, and whether it adds up.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// What the particles hold at one moment, and what has been exchanged with the outside since the start of the run.
/// How it was measured is no matter of the books.
struct Measured {
  // Stores [J]; the energy of cohesive bonds is negative.
  double kinetic = 0, rotational = 0, elastic = 0, cohesive = 0;
  // Work done on the particles since the start by body forces, by drag, and by bodies and walls that move as
  // prescribed [J].
  double body_work = 0, drag_work = 0, prescribed_work = 0, wall_work = 0;
  // Potential energy that bodies gained in uniform gravity as they were moved apart without a velocity (hard
  // collisions) [J].
  double relocation_work = 0;
  // Energy lost since the start, positive [J].
  double dissipated_normal = 0, dissipated_sliding = 0, dissipated_rolling = 0;
  // Energy that particles brought along and took away since the start, that of their contacts included [J].
  double inserted = 0, removed = 0;
  // Momentum [kg m/s] and angular momentum about the origin [kg m2/s], and what all external forces (body forces, drag,
  // walls, prescribed bodies) have added to them since the start.
  std::array<double, 3> momentum{}, impulse{};
  std::array<double, 3> angular_momentum{}, angular_impulse{};
  // What particles that came and went brought along and took away of both.
  std::array<double, 3> inserted_momentum{}, removed_momentum{};
  std::array<double, 3> inserted_angular_momentum{}, removed_angular_momentum{};
  double momentum_scale = 0;  // sum of the magnitudes m |v| of all particles, to compare errors with [kg m/s]
};

/// The books of a run. All of it is doubles, and belongs into a checkpoint as it is.
struct Books {
  Measured start;             // the first entry
  Measured last;              // the latest entry
  double turnover = 0;        // up to the latest entry [J]
  double momentum_scale = 0;  // the largest one of all entries [kg m/s]
};

/// How well the books close at one moment.
struct LedgerRow {
  /// Energy now - energy at the start - work + losses - inserted + removed [J].
  double energy_error = 0;

  /// All energy that has moved: the magnitude of what was there at the start, and half the sum of the magnitudes of
  /// all changes of all stores and exchanges from entry to entry, since each amount leaves one and reaches another [J].
  double turnover = 0;

  /// Norms of change minus impulse [kg m/s], [kg m2/s]. Where a direction is periodic a particle that reappears on the
  /// other side brings another angular momentum with it: the error is then NaN.
  double momentum_error = 0, angular_momentum_error = 0;

  /// momentum_error over the largest sum of m |v| so far; 0 if both are 0.
  double relative_momentum_error = 0;

  /// energy_error over the turnover; 0 if both are 0.
  double relative_energy_error() const;
};

/// Names that leave_out() knows.
std::span<const std::string> ledger_channels();

/// Sets channels to zero, as if nobody had measured them: the books must then fail to close wherever the channel
/// matters. Names: normal, sliding, rolling (losses), drag, body, prescribed, walls, relocation (work), inserted,
/// removed (energy and momenta), momentum_impulse, angular_impulse. Throws InputError for another name.
void leave_out(Measured& measured, std::span<const std::string> channels);

/// Opens the books with the state at the start of the run.
Books open_books(const Measured& start);

/// Closes the books provisionally at a state, without an entry. `any_periodic`: see angular_momentum_error.
LedgerRow balance(const Books& books, const Measured& now, bool any_periodic);

/// Enters a state. Entries at the same steps give the same bits after a restart; balance() may be called in between.
void enter(Books& books, const Measured& now);

/// Throws PhysicsError with all sums when the energy error is not within `tolerance` times the turnover, or is NaN.
/// `time` is for the message [s].
void check_books(const Books& books, const Measured& now, double tolerance, double time);

/// A few words for the progress line.
std::string ledger_line(const LedgerRow& row);

/// The books as plain numbers and back, for a checkpoint. Throws InputError if there are not as many as there must be.
std::vector<double> books_as_numbers(const Books& books);
Books books_from_numbers(std::span<const double> numbers);

}  // namespace scree
