// What a scenario's expectations ask of how swarms move.
#pragma once

#include <vector>

#include "controller/flight/motion.hpp"
#include "controller/flight/world.hpp"
#include "controller/metrics/motion_question.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// One an expectation, in the scenario's order; of kind kNone where it asks nothing of the kind. All must
// outlive the result: places are asked of `motion`.
std::vector<MotionQuestion> motion_questions(const Scenario& scenario, const World& world,
                                             const Motion& motion);

}  // namespace mayfly
