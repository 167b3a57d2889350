// The processes that share a run, and what they agree on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scree/base/exact_sum.h"

namespace scree {

using Bytes = std::vector<std::byte>;

/// What one rank sends another, or has received from it.
struct Message {
  int rank = 0;
  Bytes bytes;
};

/// What a rank has had to do with the others since the run began.
struct Traffic {
  std::int64_t messages = 0;  // sent to one partner each
  std::int64_t bytes = 0;     // in these
  double waiting = 0;         // for messages, and for all to agree [s]
};

/// The processes of a run. Every member is to be called by all of them, in the same order; a process alone agrees with
/// itself at no cost, with MPI or without.
class Ranks {
 public:
  /// This process alone.
  Ranks() = default;

  int rank() const { return rank_; }
  int count() const { return count_; }
  bool alone() const { return count_ == 1; }
  bool root() const { return rank_ == 0; }
  Traffic traffic() const { return alone() ? Traffic() : *traffic_; }

  /// The largest value of all ranks.
  double largest(double mine) const;

  /// The sum over all ranks; integers, so that the order does not matter.
  std::int64_t total(std::int64_t mine) const;

  /// The sum of a number over all ranks, added by rising rank: the same everywhere.
  double sum(double mine) const;

  /// The sums of all values of all ranks, place by place.
  void add_up(std::vector<std::int64_t>& mine) const;

  /// The same of numbers, added by rising rank as sum() does.
  void add_up(std::span<double> mine) const;

  /// The largest values of all ranks, place by place.
  void find_largest(std::vector<double>& mine) const;

  /// True if it is true on every rank.
  bool all(bool mine) const { return total(mine ? 0 : 1) == 0; }

  /// The number that the root gives.
  std::int64_t of_root(std::int64_t mine) const;

  /// What every rank has, at the root by rank; empty elsewhere.
  std::vector<Bytes> gather(const Bytes& mine) const;

  /// Delivers messages; whoever gets one need not know of it before. They come by rising rank, at most one from each.
  std::vector<Message> deliver(const std::vector<Message>& outgoing) const;

  /// Sends to known partners and receives from them as many bytes as each message in `incoming` has room for. Exactly
  /// the partner's message must be of that size.
  void swap(const std::vector<Message>& outgoing, std::vector<Message>& incoming) const;

 private:
  friend class RanksOfRun;
  Ranks(int rank, int count) : rank_(rank), count_(count), traffic_(std::make_shared<Traffic>()) {}

  int rank_ = 0, count_ = 1;
  std::shared_ptr<Traffic> traffic_;  // of this process, whoever speaks for it; nobody counts where it is alone
};

/// What a rank may use of its machine.
struct Processors {
  int mine = 1;   // this rank's share: where several may use a processor, each has a part of it
  int used = 1;   // by all ranks of this machine together
  int there = 1;  // that whoever started the ranks may use
  int ranks = 1;  // on this machine
  int place = 0;  // of this one among them
};

/// Those of this process, as if no other one were there.
Processors processors_alone();

/// Starts MPI where this process is alone, for libraries that cannot do without; nothing without MPI.
void start_mpi_alone();

/// Joins the processes that mpirun has started, for as long as it lives; without mpirun this process is alone and MPI
/// is not touched. One at most.
class RanksOfRun {
 public:
  RanksOfRun();
  ~RanksOfRun();
  RanksOfRun(const RanksOfRun&) = delete;
  RanksOfRun& operator=(const RanksOfRun&) = delete;

  const Ranks& ranks() const { return ranks_; }
  const Processors& processors() const { return processors_; }

  /// Ends all processes of the run at once with an exit code: one that goes on alone would wait for ever.
  [[noreturn]] void bring_down(int code) const;

 private:
  Ranks ranks_;
  Processors processors_ = processors_alone();
  [[maybe_unused]] bool joined_ = false;  // without MPI there is nothing to join
};

}  // namespace scree
