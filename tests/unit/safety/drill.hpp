// Ticks of Reactions, with one robot or everybody ill.
#pragma once

#include <vector>

#include "controller/safety/reactions.hpp"

namespace mayfly::test {

inline constexpr Time kTick = std::chrono::milliseconds(10);

inline Symptoms only(Symptom symptom) {
  Symptoms symptoms;
  symptoms.add(symptom);
  return symptoms;
}

// Three robots; the first two share a link.
struct Drill {
  Drill() : Drill(std::vector<Reactions::Robot>{{0, true}, {0, true}, {1, true}}) {}
  explicit Drill(const std::vector<Reactions::Robot>& of) : reactions(of), robots(of.size()) {}

  // One tick, `every` after the one before.
  Severity tick(Symptoms first, Symptoms everybody = {}, Time every = kTick) {
    now += every;
    robots[0] = first;
    reactions.tick(now, robots, everybody);
    return reactions.severities()[0];
  }
  Severity tick(bool shows, Symptom symptom, bool of_everybody, Time every = kTick) {
    const Symptoms shown = shows ? only(symptom) : Symptoms{};
    return of_everybody ? tick({}, shown, every) : tick(shown, {}, every);
  }

  Reactions reactions;
  std::vector<Symptoms> robots;
  Time now{0};
};

}  // namespace mayfly::test
