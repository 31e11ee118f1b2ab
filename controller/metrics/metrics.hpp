// What a flight came to, measured while it flies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "controller/governor/obstacle_view.hpp"
#include "controller/metrics/last_seen.hpp"
#include "controller/metrics/near_pairs.hpp"
#include "controller/metrics/swarm_encounters.hpp"
#include "controller/metrics/swarm_motion.hpp"
#include "controller/metrics/swarm_order.hpp"
#include "core/clock.hpp"

namespace mayfly {

struct MetricsSwarm {
  std::size_t first = 0;
  std::size_t count = 0;
  bool has_goal = true;
};

struct MetricsConfig {
  Time period{0};            // between two ticks
  std::vector<float> radii;  // m, one an agent
  std::vector<MetricsSwarm> swarms;
  // Whether a place lies in the goal of a swarm that has one (its index above). Asked until the agent has
  // been there once.
  std::function<bool(std::size_t swarm, glm::vec3)> in_goal{};  // empty: not measured
  // With the exact distance, φ < 0 is decided by it wherever the sampled field cannot.
  ObstacleView obstacles{};     // empty: there are none, and nobody is inside one
  bool wall_clearance = false;  // whether to measure it: many exact distances
  std::vector<MotionQuestion> motions{};
  std::uint64_t ticks = 0;  // how many there will be, for what is measured over a part of the flight
};

// What was not measured is empty, never 0.
struct MetricsResult {
  std::uint64_t ticks = 0;
  std::optional<double> min_separation_m;  // of two centres at any tick; empty with fewer than two agents
  std::uint64_t collisions = 0;            // encounters below the sum of the two radii, each counted once
  std::uint64_t penetrations = 0;          // agent-ticks with the centre inside an obstacle
  std::optional<double> reached_fraction;  // of all agents with a goal: who entered it at any time
  std::vector<std::optional<double>> reached_fraction_of;  // by swarm
  std::optional<double> wall_clearance_m;  // least distance of a centre to an obstacle, 0 or less inside one
  std::vector<std::optional<double>> motions;  // in the order of the questions
  std::optional<double> max_speed_mps;
  std::optional<double> max_acceleration_mps2;  // change of velocity from tick to tick
  std::uint64_t not_finite = 0;                 // agent-ticks left out because a number was none
  std::uint64_t contact_overflows = 0;  // ticks with too many contacts to count: `collisions` is too low
};

class Metrics {
 public:
  // Allocates all that is ever needed.
  explicit Metrics(MetricsConfig config);

  // One tick; allocates nothing. The callbacks must not throw. Columns shorter than the number of agents
  // leave the rest out.
  void observe(const MetricsTick& tick) noexcept;

  MetricsResult result() const;

 private:
  std::vector<std::optional<double>> answers() const;
  void observe_places(const MetricsTick& tick, std::size_t agents) noexcept;
  void observe_speeds(const MetricsTick& tick, std::size_t agents) noexcept;
  void observe_obstacles(glm::vec3 place) noexcept;

  MetricsConfig config_;
  NearPairs pairs_;
  LastSeen seen_;
  SwarmMotion motion_;
  SwarmOrder order_;
  SwarmEncounters encounters_;
  std::vector<std::uint8_t> reached_;
  std::vector<std::size_t> swarm_of_;
  std::vector<glm::vec3> last_velocity_;
  std::vector<std::uint8_t> last_known_;
  std::uint64_t ticks_ = 0;
  std::uint64_t penetrations_ = 0;
  double least_clearance_ = std::numeric_limits<double>::infinity();
  std::uint64_t not_finite_ = 0;
  double fastest_squared_ = -1.0;   // −1: nothing was seen
  double sharpest_squared_ = -1.0;  // of the change of velocity in a tick
};

}  // namespace mayfly
