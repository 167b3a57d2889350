#include "scree/mpi/ranks.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#ifdef SCREE_MPI
#include <mpi.h>
#endif

#include "scree/base/stopwatch.h"

namespace scree {
namespace {

/// 1 for every processor that a process may use; 0 is this one.
std::vector<int> processors_of(pid_t process) {
  std::vector<int> out(CPU_SETSIZE, 0);
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(process, sizeof set, &set) != 0) return out;
  for (int k = 0; k < CPU_SETSIZE; ++k) out[k] = CPU_ISSET(k, &set) ? 1 : 0;
  return out;
}

/// `users`: how many ranks of this machine may use each processor.
Processors share_of(const std::vector<int>& own, const std::vector<int>& users, int ranks) {
  double mine = 0;
  Processors out;
  out.used = 0;
  for (int k = 0; k < CPU_SETSIZE; ++k) {
    if (own[k]) mine += 1.0 / users[k];
    out.used += users[k] > 0;
  }
  out.mine = std::max(1, static_cast<int>(mine + 1e-6));
  out.used = std::max(1, out.used);
  out.there = out.used;
  out.ranks = ranks;
  return out;
}

}  // namespace

Processors processors_alone() {
  const std::vector<int> own = processors_of(0);
  return share_of(own, own, 1);
}

#ifdef SCREE_MPI

namespace {

/// Largest piece that is sent at once: counts of MPI are ints.
constexpr std::size_t piece = std::size_t{1} << 30;

enum Tag : int { delivered = 1, swapped = 2 };

/// Begins to send or to receive `bytes`, in pieces.
template <class Begin>
void in_pieces(std::size_t size, std::vector<MPI_Request>& requests, Begin&& begin) {
  for (std::size_t from = 0; from < size; from += piece) {
    requests.emplace_back();
    begin(from, static_cast<int>(std::min(piece, size - from)), &requests.back());
  }
}

void begin_sending(const Message& m, Tag tag, std::vector<MPI_Request>& requests, Traffic& traffic) {
  ++traffic.messages;
  traffic.bytes += static_cast<std::int64_t>(m.bytes.size());
  in_pieces(m.bytes.size(), requests, [&](std::size_t from, int count, MPI_Request* request) {
    MPI_Isend(m.bytes.data() + from, count, MPI_BYTE, m.rank, tag, MPI_COMM_WORLD, request);
  });
}

void begin_receiving(Message& m, Tag tag, std::vector<MPI_Request>& requests) {
  in_pieces(m.bytes.size(), requests, [&](std::size_t from, int count, MPI_Request* request) {
    MPI_Irecv(m.bytes.data() + from, count, MPI_BYTE, m.rank, tag, MPI_COMM_WORLD, request);
  });
}

void wait_for(std::vector<MPI_Request>& requests) {
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

/// Whether somebody has started several processes. MPI need not be asked, which would take a tenth of a second.
bool launched() {
  return std::ranges::any_of(std::initializer_list<const char*>{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"},
                             [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

double Ranks::largest(double mine) const {
  if (alone()) return mine;
  const Stopwatch watch(traffic_->waiting);
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return mine;
}

std::int64_t Ranks::total(std::int64_t mine) const {
  if (alone()) return mine;
  const Stopwatch watch(traffic_->waiting);
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

double Ranks::sum(double mine) const {
  add_up({&mine, 1});
  return mine;
}

void Ranks::add_up(std::span<double> mine) const {
  if (alone()) return;
  const std::size_t n = mine.size();
  std::vector<double> all(n * static_cast<std::size_t>(count_));
  MPI_Allgather(mine.data(), static_cast<int>(n), MPI_DOUBLE, all.data(), static_cast<int>(n), MPI_DOUBLE,
                MPI_COMM_WORLD);
  std::ranges::fill(mine, 0.0);
  for (std::size_t at = 0; at < all.size(); ++at) mine[at % n] += all[at];
}

void Ranks::add_up(std::vector<std::int64_t>& mine) const {
  if (alone()) return;
  const Stopwatch watch(traffic_->waiting);

  MPI_Allreduce(MPI_IN_PLACE, mine.data(), static_cast<int>(mine.size()), MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
}

void Ranks::find_largest(std::vector<double>& mine) const {
  if (alone()) return;
  const Stopwatch watch(traffic_->waiting);

  MPI_Allreduce(MPI_IN_PLACE, mine.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
}

std::int64_t Ranks::of_root(std::int64_t mine) const {
  if (alone()) return mine;
  const Stopwatch watch(traffic_->waiting);
  MPI_Bcast(&mine, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  return mine;
}

std::vector<Bytes> Ranks::gather(const Bytes& mine) const {
  if (alone()) return {mine};
  const Stopwatch watch(traffic_->waiting);
  std::vector<std::int64_t> sizes(count_, 0);
  const std::int64_t size = static_cast<std::int64_t>(mine.size());
  MPI_Gather(&size, 1, MPI_INT64_T, sizes.data(), 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  std::vector<MPI_Request> requests;
  std::vector<Message> all;
  if (root())
    for (int r = 1; r < count_; ++r) all.push_back({r, Bytes(static_cast<std::size_t>(sizes[r]))});
  for (Message& m : all) begin_receiving(m, delivered, requests);
  const Message own{0, root() ? Bytes() : mine};
  begin_sending(own, delivered, requests, *traffic_);
  wait_for(requests);
  std::vector<Bytes> out;
  if (root()) out.push_back(mine);
  for (Message& m : all) out.push_back(std::move(m.bytes));
  return out;
}

std::vector<Message> Ranks::deliver(const std::vector<Message>& outgoing) const {
  if (alone()) return outgoing;
  const Stopwatch watch(traffic_->waiting);
  std::vector<std::int64_t> to(count_, -1), from(count_, -1);
  for (const Message& m : outgoing) to[m.rank] = static_cast<std::int64_t>(m.bytes.size());
  MPI_Alltoall(to.data(), 1, MPI_INT64_T, from.data(), 1, MPI_INT64_T, MPI_COMM_WORLD);
  std::vector<Message> incoming;
  for (int r = 0; r < count_; ++r)
    if (from[r] >= 0) incoming.push_back({r, Bytes(static_cast<std::size_t>(from[r]))});
  std::vector<MPI_Request> requests;
  for (Message& m : incoming) begin_receiving(m, delivered, requests);
  for (const Message& m : outgoing) begin_sending(m, delivered, requests, *traffic_);
  wait_for(requests);
  return incoming;
}

void Ranks::swap(const std::vector<Message>& outgoing, std::vector<Message>& incoming) const {
  if (alone()) return;
  const Stopwatch watch(traffic_->waiting);
  std::vector<MPI_Request> requests;
  for (Message& m : incoming) begin_receiving(m, swapped, requests);
  for (const Message& m : outgoing) begin_sending(m, swapped, requests, *traffic_);
  wait_for(requests);
}

void start_mpi_alone() {
  int started = 0;
  MPI_Initialized(&started);
  if (started) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  std::atexit([] { MPI_Finalize(); });
}

RanksOfRun::RanksOfRun() {
  if (!launched()) return;
  int provided = 0;
  // Threads compute; only the first of each process speaks to the others.
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  joined_ = true;
  int rank = 0, count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  ranks_ = Ranks(rank, count);
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank, MPI_INFO_NULL, &machine);
  int neighbours = 1;
  MPI_Comm_size(machine, &neighbours);
  const std::vector<int> own = processors_of(0);
  std::vector<int> users = own;
  MPI_Allreduce(MPI_IN_PLACE, users.data(), CPU_SETSIZE, MPI_INT, MPI_SUM, machine);
  processors_ = share_of(own, users, neighbours);
  MPI_Comm_rank(machine, &processors_.place);
  // A launcher that binds its ranks is not bound itself.
  const std::vector<int> of_launcher = processors_of(getppid());
  processors_.there = std::max(processors_.used, std::accumulate(of_launcher.begin(), of_launcher.end(), 0));
  MPI_Comm_free(&machine);
}

RanksOfRun::~RanksOfRun() {
  if (joined_) MPI_Finalize();
}

void RanksOfRun::bring_down(int code) const {
  if (!ranks_.alone()) MPI_Abort(MPI_COMM_WORLD, code);
  std::exit(code);
}

#else

double Ranks::largest(double mine) const { return mine; }
std::int64_t Ranks::total(std::int64_t mine) const { return mine; }
double Ranks::sum(double mine) const { return mine; }
void Ranks::add_up(std::span<double>) const {}
void start_mpi_alone() {}
void Ranks::add_up(std::vector<std::int64_t>&) const {}
void Ranks::find_largest(std::vector<double>&) const {}
std::int64_t Ranks::of_root(std::int64_t mine) const { return mine; }
std::vector<Bytes> Ranks::gather(const Bytes& mine) const { return {mine}; }
std::vector<Message> Ranks::deliver(const std::vector<Message>& outgoing) const { return outgoing; }
void Ranks::swap(const std::vector<Message>&, std::vector<Message>&) const {}
RanksOfRun::RanksOfRun() = default;
RanksOfRun::~RanksOfRun() = default;
void RanksOfRun::bring_down(int code) const { std::exit(code); }

#endif

}  // namespace scree
