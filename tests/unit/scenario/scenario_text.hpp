// The scenario of the interface's page, and small ways to read what loading one says.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "controller/scenario/load.hpp"

namespace mayfly::test {

inline constexpr const char* kExample = R"(mayfly: 1                      # schema version
name: two_blocks
seed: 7
duration: 40                   # s
world:
  bounds: {min: [0, 0, 0], max: [60, 112, 40]}       # m
  cell: 1.0
  obstacles:
    - {mesh: meshes/block.obj, position: [18, 56, 20], scale: 1.0, rotation: [0, 0, 0]}   # or box:, sphere:, cylinder:
  goals:
    exit: {box: {min: [20, 100, 10], max: [40, 110, 30]}}                                # may have path: for a moving goal
swarms:
  - name: flies
    count: 300
    start: {box: {min: [20, 4, 10], max: [40, 14, 30]}}
    goal: exit
    model: field               # field | forces | shape | pso | boids | orca | brownian
    preset: wang14/two_blocks  # config/presets/…; keys below override it
    noise: {kind: curl, scale: 0.4, gain: 0.25}
    cruise_speed: 1.5
    limits: {speed: 3, acceleration: 20, separation: 0.2}   # separation: MDE's and the governor's minimum distance
    radius: 0.05               # m, the body
    governor: off              # only where every robot is simulated; default on
    robots: sim                # a HAL below, or a list of named robots
stimuli: []                    # predators, mates, lamps
planners: {curl_noise: {rate: 50}, pso: {rate: 10}}
control: {rate: 100}
hal:
  sim: {kind: sim, plant: velocity_lag, time_constant: 0.1}
expect:                        # what `test` (and CI) holds it to
  - reached: {swarm: flies, goal: exit, fraction: ">= 0.99"}
  - min_separation: ">= 0.2"
  - penetrations: "== 0"
)";

// The least that flies.
inline constexpr const char* kSmallest = R"(mayfly: 1
world:
  bounds: {min: [0, 0, 0], max: [20, 20, 20]}
  goals:
    exit: {sphere: {center: [10, 18, 10], radius: 1}}
swarms:
  - name: flies
    count: 10
    start: {sphere: {center: [10, 4, 10], radius: 2}}
    goal: exit
hal:
  sim: {kind: sim}
)";

// kSmallest with one piece replaced.
inline std::string changed(std::string_view piece, std::string_view replacement) {
  std::string text = kSmallest;
  text.replace(text.find(piece), piece.size(), replacement);
  return text;
}

inline ScenarioResult load_text(std::string_view text, std::span<const Override> overrides = {}) {
  return load_scenario_text(text, std::filesystem::temp_directory_path() / "scenario.yaml", overrides);
}

inline std::string all_text(const std::vector<Error>& errors) {
  std::string text;
  for (const Error& error : errors) {
    text += to_string(error) + "\n";
  }
  return text;
}

// All the errors of a text that should not load.
inline std::string errors_of(std::string_view text, std::span<const Override> overrides = {}) {
  const auto result = load_text(text, overrides);
  return result ? "it loads" : all_text(result.error());
}

}  // namespace mayfly::test
