// Fields that belong together, and what they were solved from.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/result.hpp"
#include "fields/cost_field.hpp"

namespace mayfly {

struct FieldInputs {
  double time_s = 0.0;                 // s since the flight began: when the agents were looked at
  double from_s = 0.0, until_s = 0.0;  // when the fields will be flown by
  std::vector<float> x{}, y{}, z{};    // m, one an agent; not a number: nobody knows
};

// One set of all that is solved again. Written by one thread at a time, and swapped in whole.
struct FieldSet {
  double time_s = 0.0;                   // of its inputs
  double solve_s = 0.0;                  // wall time
  std::vector<float> walls;              // spline coefficients; empty where no obstacle moves
  std::vector<fields::CostField> costs;  // one a solver
  // One a solver: why no place can reach the goal; agents then have no guide and hold.
  std::vector<std::optional<Error>> lost;
  std::vector<std::uint32_t> cut_off;  // one a swarm: agents with no way to the goal
};

}  // namespace mayfly
