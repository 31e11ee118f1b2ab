// Small worlds in which something moves, and one call to fly them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "controller/scenario/load.hpp"
#include "simulate/fly_simulated.hpp"

namespace mayfly::test {

// A hall of 30 m × 20 m × 12 m in cells of 1 m, with `obstacles` and `goals` as in a scenario file, and one
// swarm: `swarm` is the rest of its keys.
inline Scenario hall_with(const std::string& obstacles, const std::string& goals, const std::string& swarm,
                          double duration) {
  const std::string text = "mayfly: 1\nduration: " + std::to_string(duration) +
                           "\nworld:\n  bounds: {min: [0, 0, 0], max: [30, 20, 12]}\n  cell: 1.0\n"
                           "  obstacles: [" +
                           obstacles + "]\n  goals: {" + goals +
                           "}\nswarms:\n  - {name: flies, noise: {scale: 0.8, gain: 0.2}, cruise_speed: 1.5, "
                           "governor: off, " +
                           swarm + "}\nhal: {sim: {kind: sim, plant: ideal}}\n";
  auto scenario = load_scenario_text(text, "hall.yaml");
  if (!scenario) {
    for (const Error& error : scenario.error()) {
      ADD_FAILURE() << to_string(error);
    }
    return {};
  }
  return std::move(*scenario);
}

inline Summary flown(const Scenario& scenario, const simulate::Options& options = {}) {
  auto summary = simulate::fly_simulated(scenario, options);
  if (!summary) {
    for (const Error& error : summary.error()) {
      ADD_FAILURE() << to_string(error);
    }
    return {};
  }
  return std::move(*summary);
}

// A goal of 6 m that flies a square of 12 m by 8 m for ever, at half the cruise speed.
inline Scenario chase(int agents, double duration) {
  return hall_with(
      "{box: {min: [14, 9, 0], max: [16, 11, 12]}}",
      "fox: {sphere: {center: [24, 6, 6], radius: 3}, path: {points: [[24, 6, 6], [24, 14, 6], "
      "[6, 14, 6], [6, 6, 6]], speed: 0.75, loop: true}}",
      "count: " + std::to_string(agents) + ", start: {box: {min: [2, 3, 2], max: [6, 17, 10]}}, goal: fox",
      duration);
}

// A door that closes the only way from x = 12 m to 15 m between 6 s and 18 s after the start, for good where
// `opens` is false.
inline Scenario door(int agents, double duration, bool opens) {
  const std::string path =
      opens ? "[[13, 10, 18], [13, 10, 6], [13, 10, 18]]" : "[[13, 10, 18], [13, 10, 6]]";
  return hall_with(
      "{box: {min: [12, -1, -1], max: [15, 7, 13]}}, {box: {min: [12, 13, -1], max: [15, 21, 13]}}, "
      "{box: {min: [12, 7, 12], max: [15, 13, 24]}, path: {points: " +
          path + ", speed: 1.5}}",
      "exit: {box: {min: [20, 4, 2], max: [28, 16, 10]}}",
      "count: " + std::to_string(agents) + ", start: {box: {min: [1, 4, 2], max: [4, 16, 10]}}, goal: exit",
      duration);
}

}  // namespace mayfly::test
