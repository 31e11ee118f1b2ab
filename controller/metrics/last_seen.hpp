// Where each agent was last, and how fast: who is not seen at a tick counts where it was, who is not there
// any more does not count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace mayfly {

// Columns of one tick, one element an agent: m, m/s. The truth where it is known.
struct MetricsTick {
  std::span<const float> x, y, z;
  std::span<const float> vx, vy, vz;
  std::span<const std::uint8_t> present{};  // 0: has not joined yet or has left; empty: all are there

  bool is_there(std::size_t agent) const noexcept { return agent >= present.size() || present[agent] != 0; }
};

class LastSeen {
 public:
  explicit LastSeen(std::size_t agents)
      : place_(agents, glm::vec3(0.0F)), velocity_(agents, glm::vec3(0.0F)), known_(agents, 0) {}

  // Allocates nothing. Columns may be shorter than the number of agents: the rest is not seen.
  void update(const MetricsTick& tick) noexcept;

  std::size_t agents() const { return place_.size(); }
  bool known(std::size_t agent) const { return known_[agent] != 0; }
  glm::dvec3 place(std::size_t agent) const { return place_[agent]; }        // m
  glm::dvec3 velocity(std::size_t agent) const { return velocity_[agent]; }  // m/s

 private:
  std::vector<glm::vec3> place_, velocity_;
  std::vector<std::uint8_t> known_;
};

// A swarm's agents: from `first` on, `count` of them.
struct AgentRange {
  std::size_t first = 0;
  std::size_t count = 0;
};

// Calls `visit` with every agent of the range that is known. Returns how many those are.
template <class Visit>
std::size_t for_each_known(const LastSeen& seen, AgentRange range, Visit&& visit) {
  std::size_t count = 0;
  for (std::size_t i = range.first; i < range.first + range.count; ++i) {
    if (seen.known(i)) {
      visit(i);
      ++count;
    }
  }
  return count;
}

// m: the mean place; empty where nobody is known.
std::optional<glm::dvec3> centre_of(const LastSeen& seen, AgentRange range) noexcept;

// m: the radius of gyration, √(mean |r − centre|²); empty where nobody is known.
std::optional<double> gyration(const LastSeen& seen, AgentRange range) noexcept;

}  // namespace mayfly
