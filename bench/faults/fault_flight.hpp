// One short flight of a small swarm with faults in it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "controller/flight/prepare.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"
#include "simulate/breach_watch.hpp"

namespace mayfly::bench {

// What all flights share; read only, from any thread.
struct FaultWorld {
  Scenario scenario;
  std::unique_ptr<const Prepared> ready;
};
Result<FaultWorld> make_fault_world();

struct FaultFlight {
  simulate::BreachCounts breaches{};  // all of them
  simulate::BreachCounts
      suspended{};         // of these, those of which the guard had told that it could not keep it
  double least_gap = 0.0;  // m
  std::uint64_t hash = 0;
  bool hung = false;  // it ended early, or ticks are missing that no fault took
  // Of each fault: s from when it can be seen to when its symptom was reported, and from its begin to when
  // all whom the reaction stops were told to stand still. Empty: not within the flight.
  std::vector<std::optional<double>> seen_after, stopped_after;
  std::vector<bool> missed;  // of each fault: whether it could be seen in time, and was not reported at all
  // Of each fault whose symptom made the guard hold or more: how many ticks after that was told all whom it
  // is about had been told what is safe. Empty where nothing was told.
  std::vector<std::optional<std::uint64_t>> safe_after;
};

// Faults begin and end at times of chance, and strike robots of chance: all from `seed`.
Result<FaultFlight> fly_with_faults(const FaultWorld& world, const std::vector<FaultKind>& kinds,
                                    std::uint64_t seed);

}  // namespace mayfly::bench
