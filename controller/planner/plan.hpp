// What crosses between control and a planner.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "core/hal.hpp"

namespace mayfly {

struct Columns3 {
  explicit Columns3(std::size_t n = 0) : x(n), y(n), z(n) {}
  VelocityColumns writable() { return {x, y, z}; }
  std::vector<float> x, y, z;
};

// The swarm as control knows it at a tick; one element an agent.
struct SwarmView {
  double time_s = 0.0;                            // of the flight
  std::span<const float> x, y, z;                 // m
  std::span<const float> vx, vy, vz;              // m/s
  std::span<const float> told_x, told_y, told_z;  // m/s: what was last sent to the robots
};

// The same with memory of its own.
struct SwarmCopy {
  explicit SwarmCopy(std::size_t agents = 0) : position(agents), velocity(agents), told(agents) {}
  // `from` has as many agents. Allocates nothing.
  void copy(const SwarmView& from) noexcept;
  SwarmView view() const noexcept;

  double time_s = 0.0;
  Columns3 position, velocity, told;
};

// The velocity that each agent would like, and what was found on the way.
struct Plan {
  explicit Plan(std::size_t agents = 0, std::size_t swarms = 0) : velocity(agents), goals(swarms) {}

  Columns3 velocity;             // m/s
  HalResult engine, solver;      // what is wrong with whom, if anything
  std::vector<HalResult> goals;  // one a swarm: that its goal is out of reach
  // s: when nobody had a velocity clear of everybody, first.
  std::optional<double> all_infeasible_s;
};

// Who works beside control, at a rate of its own (controller/executor: Executor::add_planner). The
// particle-swarm planner will be another one.
class Planner {
 public:
  Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;
  virtual ~Planner() = default;

  // In the planner's thread; `now` is the time of the release, on the run's clock.
  virtual void work(std::uint64_t release, Time now) noexcept = 0;
  virtual void publish() noexcept = 0;
};

}  // namespace mayfly
