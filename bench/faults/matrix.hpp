// Every fault against every bound: what `mayfly bench faults` sweeps.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/faults/fault_flight.hpp"
#include "core/progress.hpp"

namespace mayfly::bench {

struct FaultsPlan {
  std::uint64_t seeds = 20;  // flights of each fault, or of each pair
  bool pairs = false;        // every two faults at once, instead of each alone
  int threads = 0;           // 0: one a processor
  Progress progress{};
};

// How long something took, over many flights. s
struct Delays {
  std::uint64_t count = 0;
  double longest = 0.0;

  void add(const std::optional<double>& delay);
};

struct FaultCell {
  std::vector<FaultKind> faults;  // one, or two
  std::uint64_t flights = 0;
  Delays seen{}, stopped{};  // of the first fault
  std::uint64_t late = 0;    // flights in which its symptom came later than its bound
  std::uint64_t unseen = 0;  // or could be seen, and never came
  // Ticks from a telling of its symptom that holds somebody to the last of the safe commands; the worst.
  std::optional<std::uint64_t> safe_after{};
  simulate::BreachCounts breaches{};   // of what was promised
  simulate::BreachCounts suspended{};  // of which the guard had told that it could not keep its promise
  double least_gap = std::numeric_limits<double>::infinity();  // m
  std::uint64_t hung = 0;
  std::optional<std::uint64_t> first_bad{};  // the seed of the first flight with a breach
  std::uint64_t hash = 0;                    // of all its flights
};

struct FaultMatrix {
  std::vector<FaultCell> cells;
  std::uint64_t seeds = 0, flights = 0, breaches = 0, hung = 0;
  std::uint64_t late = 0, unseen = 0;  // flights, as of their first fault
  std::uint64_t slow = 0;  // cells in which a safe command came later than a tick after the symptom
  double took_s = 0.0;
};

Result<FaultMatrix> sweep_faults(const FaultsPlan& plan);

std::string to_text(const FaultMatrix& matrix);
std::string to_json(const FaultMatrix& matrix);

}  // namespace mayfly::bench
