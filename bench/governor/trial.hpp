// Robots that are told to run into each other: the governor, or avoidance alone, against the true motion.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/result.hpp"

namespace mayfly::bench {

// Who wishes.
enum class Wishes : std::uint8_t {
  kHostile,  // by turns: jerks, chase the nearest, all to one point, no numbers, what was wished long ago
  kGoals,    // collision avoidance on the way to goals at random
  kCentre,   // collision avoidance, and everybody's goal is the middle
  kChase,    // collision avoidance, and everybody's goal is the nearest
};

struct TrialPlan {
  std::size_t agents = 50;
  std::uint64_t ticks = 1000;
  std::uint64_t seed = 1;
  Wishes wishes = Wishes::kHostile;
  bool governed = true;
  int latency = 0;          // ticks, the most; each robot has its own, up to this
  double pose_noise = 0.0;  // m, standard deviation a coordinate
  double dropout = 0.0;     // probability that a pose is missing
  bool uneven = false;      // robots of three sizes, with three limits
};

struct TrialResult {
  std::uint64_t agent_ticks = 0;
  double least_gap = 0.0;          // m, of any two: the distance of their centres less what both bodies need
  std::uint64_t near_samples = 0;  // of the samples, four a tick, those in which two bodies overlapped
  std::uint64_t samples = 0;
  std::uint64_t too_fast = 0;     // agent-ticks
  std::uint64_t too_sudden = 0;   // agent-ticks
  std::uint64_t outside = 0;      // agent-samples: the body was not all inside the fence
  std::uint64_t goals = 0;        // reached
  double travelled = 0.0;         // m, by all
  double governor_seconds = 0.0;  // a tick, the median

  std::uint64_t breaches() const { return near_samples + too_fast + too_sudden + outside; }
};

// The arena has room for `agents` at the density of 50 in 8 × 8 × 3 m. Fails where an engine or a governor
// does not start.
Result<TrialResult> run_trial(const TrialPlan& plan);

}  // namespace mayfly::bench
