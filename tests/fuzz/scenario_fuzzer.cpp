// Any bytes at all: loading them ends in a scenario that keeps its promises, or in errors that a person can
// use. Leading lines "#set path=value" become overrides, so that they are searched too.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "controller/scenario/load.hpp"

namespace mayfly {
namespace {

void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
  }
}

std::vector<Override> leading_overrides(std::string_view text) {
  constexpr std::string_view kHead = "#set ";
  std::vector<Override> overrides;
  while (text.starts_with(kHead) && overrides.size() < 8) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (auto change = parse_override(text.substr(kHead.size(), end - kHead.size()))) {
      overrides.push_back(std::move(*change));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return overrides;
}

void check_errors(const std::vector<Error>& errors, const std::string& file, int lines) {
  require(!errors.empty(), "a failure has an error");
  for (const Error& error : errors) {
    require(!error.message.empty(), "an error has a message");
    require(error.place.has_value(), "an error has a place");
    const bool in_file = error.place->file == file;
    require(!in_file || (error.place->line >= 1 && error.place->line <= lines),
            "an error is on a line of the file");
    require(!in_file || error.place->column >= 1, "an error has a column");
    require(!to_string(error).empty(), "an error can be printed");
  }
}

bool is_box(const Box& box) {
  return std::isfinite(box.min.x + box.min.y + box.min.z + box.max.x + box.max.y + box.max.z) &&
         box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
}

void check_swarm(const SwarmSpec& swarm, const Scenario& scenario) {
  require(!swarm.name.empty() && swarm.count >= 1 && swarm.count <= 2'000'000,
          "a swarm has a name and a count");
  require(std::isfinite(swarm.cruise_speed) && swarm.cruise_speed <= swarm.limits.speed,
          "cruise is within limits");
  require(swarm.radius > 0.0F && swarm.limits.acceleration > 0.0F && swarm.limits.separation >= 0.0F,
          "limits");
  require(!swarm.noise.octaves.empty() && swarm.noise.octaves.size() <= 16, "noise has octaves");
  require(swarm.cost.length_weight > 0.0F && swarm.cost.repulsion_weight >= 0.0F, "cost weights");
  bool has_goal = false;
  for (const GoalSpec& goal : scenario.world.goals) {
    has_goal = has_goal || goal.name == swarm.goal;
  }
  require(has_goal, "the goal exists");
  bool has_hal = false;
  for (const HalSpec& hal : scenario.hals) {
    has_hal = has_hal || hal.name == swarm.robots;
  }
  require(has_hal, "the HAL exists");
}

void check_scenario(const Scenario& scenario) {
  require(scenario.duration > 0.0 && scenario.duration <= 1e6, "duration");
  require(is_box(scenario.world.bounds) && scenario.world.cell > 0.0F, "bounds");
  require(scenario.control.rate >= 1.0F, "control rate");
  require(!scenario.swarms.empty() && !scenario.hals.empty() && !scenario.world.goals.empty(),
          "something flies");
  for (const SwarmSpec& swarm : scenario.swarms) {
    check_swarm(swarm, scenario);
  }
  for (const HalSpec& hal : scenario.hals) {
    require(hal.sim.rate >= scenario.control.rate && hal.sim.time_constant > 0.0F, "plants");
  }
  for (const Expectation& expectation : scenario.expect) {
    require(std::isfinite(expectation.wanted), "expectations");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::filesystem::path file = "/nowhere/scenario.yaml";
  const std::vector<Override> overrides = leading_overrides(text);
  const auto result = load_scenario_text(text, file, overrides);
  if (result) {
    check_scenario(*result);
  } else {
    const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
    check_errors(result.error(), file.string(), lines);
  }
  return 0;
}

}  // namespace mayfly
