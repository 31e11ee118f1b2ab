#include "controller/flight/roster.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

// Below what a clock's rounding can shift a tick by, s.
constexpr double kHair = 1e-9;

// How many of a swarm have joined by then.
std::size_t joined(const SwarmSpec& swarm, double time_s) {
  const auto all = static_cast<double>(swarm.count);
  if (!swarm.join) {
    return static_cast<std::size_t>(swarm.count);
  }
  const double since = std::floor((time_s + kHair) * static_cast<double>(swarm.join->rate));
  return static_cast<std::size_t>(std::min(all, static_cast<double>(swarm.join->first) + since));
}

// And how many have left.
std::size_t gone(const SwarmSpec& swarm, double time_s) {
  const double since = swarm.leave ? time_s + kHair - static_cast<double>(swarm.leave->after) : -1.0;
  if (since < 0.0) {
    return 0;
  }
  const double left = 1.0 + std::floor(since * static_cast<double>(swarm.leave->rate));
  return static_cast<std::size_t>(std::min(static_cast<double>(swarm.leave->count), left));
}

}  // namespace

Roster::Roster(const Scenario& scenario) : swarms_(scenario.swarms) {
  const bool changes = std::any_of(swarms_.begin(), swarms_.end(),
                                   [](const SwarmSpec& swarm) { return swarm.join || swarm.leave; });
  std::size_t agents = 0;
  for (const SwarmSpec& swarm : swarms_) {
    agents += static_cast<std::size_t>(swarm.count);
  }
  present_.assign(changes ? agents : 0, 1);
  set_time(0.0);
}

void Roster::set_time(double time_s) noexcept {
  if (present_.empty()) {
    return;
  }
  auto first = present_.begin();
  for (const SwarmSpec& swarm : swarms_) {
    const auto from = static_cast<std::ptrdiff_t>(gone(swarm, time_s));
    const auto to = static_cast<std::ptrdiff_t>(joined(swarm, time_s));
    std::fill(first, first + swarm.count, std::uint8_t{0});
    if (from < to) {
      std::fill(first + from, first + to, std::uint8_t{1});
    }
    first += swarm.count;
  }
}

}  // namespace mayfly
