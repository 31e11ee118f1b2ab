// Who is there: agents may join and leave in flight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/scenario/scenario.hpp"

namespace mayfly {

// Of each swarm the agents with the lowest numbers are there first, and leave first. An agent that has left
// does not come back; one that would leave before it has joined is never there.
class Roster {
 public:
  explicit Roster(const Scenario& scenario);

  // Whether anybody joins or leaves: otherwise all are always there.
  bool changes() const { return !present_.empty(); }

  // s since the flight began. Allocates nothing.
  void set_time(double time_s) noexcept;

  bool is_there(std::size_t agent) const noexcept { return present_.empty() || present_[agent] != 0; }
  // One element an agent, 0 for those who are not there; empty where all always are.
  std::span<const std::uint8_t> present() const noexcept { return present_; }

 private:
  const std::vector<SwarmSpec>& swarms_;
  std::vector<std::uint8_t> present_;
};

}  // namespace mayfly
