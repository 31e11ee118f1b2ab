#include "bench/faults/matrix.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace mayfly::bench {
namespace {

std::vector<FaultCell> cells_of(bool pairs) {
  std::vector<FaultCell> cells;
  for (std::size_t a = 0; a < kFaultKinds; ++a) {
    if (!pairs) {
      cells.push_back({.faults = {static_cast<FaultKind>(a)}});
    }
    for (std::size_t b = a + 1; b < kFaultKinds && pairs; ++b) {
      cells.push_back({.faults = {static_cast<FaultKind>(a), static_cast<FaultKind>(b)}});
    }
  }
  return cells;
}

void add(FaultCell& cell, const FaultFlight& flight, std::uint64_t seed, double period_s) {
  constexpr double kRounding = 1e-9;
  ++cell.flights;
  cell.seen.add(flight.seen_after.front());
  cell.stopped.add(flight.stopped_after.front());
  const FaultRow& row = fault_row(cell.faults.front());
  const double bound = row.bound_s + row.bound_ticks * period_s + kRounding;
  cell.late += flight.seen_after.front() && *flight.seen_after.front() > bound ? 1U : 0U;
  cell.unseen += flight.missed.front() ? 1U : 0U;
  if (const auto& safe = flight.safe_after.front()) {
    cell.safe_after = std::max(cell.safe_after.value_or(0), *safe);
  }
  bool bad = false;
  for (std::size_t b = 0; b < simulate::kBreaches; ++b) {
    const std::uint64_t promised = flight.breaches[b] - flight.suspended[b];
    cell.breaches[b] += promised;
    cell.suspended[b] += flight.suspended[b];
    bad = bad || promised > 0;
  }
  cell.least_gap = std::min(cell.least_gap, flight.least_gap);
  cell.hung += flight.hung ? 1U : 0U;
  if (bad && !cell.first_bad) {
    cell.first_bad = seed;
  }
  cell.hash = (cell.hash ^ flight.hash) * 1099511628211U;
}

// Cells are worked through by several threads, each cell by one of them: so its sums have one order.
class Sweep {
 public:
  Sweep(const FaultsPlan& plan, const FaultWorld& world, FaultMatrix& matrix)
      : plan_(plan), world_(world), matrix_(matrix) {}

  std::optional<Error> run() {
    const auto cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t wanted = plan_.threads > 0 ? static_cast<std::size_t>(plan_.threads) : cores;
    std::vector<std::thread> threads;
    for (std::size_t t = 1; t < wanted; ++t) {
      threads.emplace_back([this] { work(); });
    }
    work();
    for (std::thread& thread : threads) {
      thread.join();
    }
    return failure_;
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < matrix_.cells.size() && !failed_; i = next_++) {
      fly(matrix_.cells[i], i);
    }
  }

  void fly(FaultCell& cell, std::size_t index) {
    const double period = 1.0 / static_cast<double>(world_.scenario.control.rate);
    for (std::uint64_t s = 0; s < plan_.seeds && !failed_; ++s) {
      const std::uint64_t seed = 1 + s * matrix_.cells.size() + index;
      const auto flight = fly_with_faults(world_, cell.faults, seed);
      if (!flight) {
        const std::lock_guard lock(mutex_);
        failure_ = flight.error();
        failed_ = true;
        return;
      }
      add(cell, *flight, seed, period);
      report(++flown_);
    }
  }

  void report(std::uint64_t flown) {
    const auto all = static_cast<double>(plan_.seeds * matrix_.cells.size());
    if (plan_.progress && flown % 16 == 0) {
      const std::lock_guard lock(mutex_);
      plan_.progress("flights", static_cast<double>(flown) / all);
    }
  }

  const FaultsPlan& plan_;
  const FaultWorld& world_;
  FaultMatrix& matrix_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::uint64_t> flown_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::optional<Error> failure_;
};

}  // namespace

void Delays::add(const std::optional<double>& delay) {
  count += delay ? 1U : 0U;
  longest = delay ? std::max(longest, *delay) : longest;
}

Result<FaultMatrix> sweep_faults(const FaultsPlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  const auto world = make_fault_world();
  if (!world) {
    return fail(world.error());
  }
  FaultMatrix matrix;
  matrix.seeds = plan.seeds;
  matrix.cells = cells_of(plan.pairs);
  if (auto failure = Sweep(plan, *world, matrix).run()) {
    return fail(std::move(*failure));
  }
  for (const FaultCell& cell : matrix.cells) {
    matrix.flights += cell.flights;
    matrix.hung += cell.hung;
    matrix.late += cell.late;
    matrix.unseen += cell.unseen;
    matrix.slow += cell.safe_after.value_or(0) > 1 ? 1U : 0U;
    for (const std::uint64_t breaches : cell.breaches) {
      matrix.breaches += breaches;
    }
  }
  matrix.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return matrix;
}

}  // namespace mayfly::bench
