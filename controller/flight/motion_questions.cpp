#include "controller/flight/motion_questions.hpp"

#include <cmath>

#include "controller/flight/stimuli.hpp"
#include "controller/flight/swarm_cost.hpp"

namespace mayfly {
namespace {

using Quantity = Expectation::Quantity;
using Kind = MotionQuestion::Kind;

Kind kind_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kCentreDrift:
      return Kind::kCentreDrift;
    case Quantity::kGoalDistance:
    case Quantity::kStimulusDistance:
      return Kind::kDistance;
    case Quantity::kTurns:
      return Kind::kTurns;
    case Quantity::kSpread:
      return Kind::kSpread;
    case Quantity::kPolarisation:
      return Kind::kPolarisation;
    case Quantity::kMilling:
      return Kind::kMilling;
    case Quantity::kNearest:
      return Kind::kNearest;
    case Quantity::kArrived:
      return Kind::kArrived;
    case Quantity::kClearing:
      return Kind::kClearing;
    case Quantity::kParting:
      return Kind::kParting;
    case Quantity::kClosing:
      return Kind::kClosing;
    default:
      return Kind::kNone;
  }
}

// Fills in the agents; returns which goal is theirs.
std::size_t find_swarm(const Scenario& scenario, const std::string& name, MotionQuestion& question) {
  std::size_t first = 0;
  std::size_t goal = scenario.world.goals.size();
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (swarm.name == name) {
      question.first = first;
      question.count = static_cast<std::size_t>(swarm.count);
      goal = goal_index(scenario, swarm);
    }
    first += static_cast<std::size_t>(swarm.count);
  }
  return goal;
}

void ask_of_goal(MotionQuestion& question, std::size_t goal, const World& world, const Motion& motion) {
  if (goal >= world.goals.size()) {
    question.kind = Kind::kNone;
    return;
  }
  const Box box = world.goals[goal].bounds().value_or(Box{});
  const glm::dvec3 middle = 0.5 * (glm::dvec3(box.min) + glm::dvec3(box.max));
  question.place = [middle, &moved = motion.goal(goal)] { return middle + glm::dvec3(moved); };
}

void ask_of_stimulus(MotionQuestion& question, const Expectation& expectation, const Scenario& scenario,
                     const Motion& motion) {
  const auto stimulus = stimulus_named(scenario, expectation.stimulus);
  if (!stimulus) {
    question.kind = Kind::kNone;
    return;
  }
  question.place = [stimulus = *stimulus, &motion] { return glm::dvec3(stimulus.at(motion.time_s())); };
  question.within =
      static_cast<double>(question.kind == Kind::kArrived ? expectation.within : stimulus->reach);
  if (expectation.at) {
    question.at_tick = static_cast<std::uint64_t>(
        std::llround(*expectation.at * static_cast<double>(scenario.control.rate)));
  }
}

MotionQuestion motion_question(const Expectation& expectation, const Scenario& scenario, const World& world,
                               const Motion& motion) {
  MotionQuestion question;
  question.kind = kind_of(expectation.quantity);
  std::size_t goal = find_swarm(scenario, expectation.swarm, question);
  for (std::size_t g = 0; g < scenario.world.goals.size(); ++g) {
    goal = scenario.world.goals[g].name == expectation.goal ? g : goal;
  }
  if (expectation.quantity == Quantity::kTurns) {
    question.place = [axis = glm::dvec3(expectation.around.value_or(glm::vec3(0.0F)))] { return axis; };
  } else if (expectation.quantity == Quantity::kGoalDistance) {
    ask_of_goal(question, goal, world, motion);
  } else if (!expectation.stimulus.empty()) {
    ask_of_stimulus(question, expectation, scenario, motion);
  }
  return question;
}

}  // namespace

std::vector<MotionQuestion> motion_questions(const Scenario& scenario, const World& world,
                                             const Motion& motion) {
  std::vector<MotionQuestion> questions;
  for (const Expectation& expectation : scenario.expect) {
    questions.push_back(motion_question(expectation, scenario, world, motion));
  }
  return questions;
}

}  // namespace mayfly
