// What goes wrong at a set time, as a scenario says it.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "controller/faults/fault_table.hpp"

namespace mayfly {

struct StruckAgents {
  std::size_t first = 0;
  std::size_t count = 0;
};

struct FaultSpec {
  FaultKind kind = FaultKind::kRobotSilent;
  std::vector<StruckAgents> agents;  // whom it strikes, in the scenario's order of agents
  double at = 0.0;                   // s
  double length = std::numeric_limits<double>::infinity();  // s
  double size = 0.0;                                        // what fault_table.hpp says
  glm::vec3 direction{1.0F, 0.0F, 0.0F};                    // of length 1

  bool is_on(double time_s) const { return time_s >= at && time_s < at + length; }
};

}  // namespace mayfly
