// The cost fields of a world, as the flight begins. For world.cpp only.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "controller/flight/world.hpp"
#include "fields/cache.hpp"
#include "fields/cost_field.hpp"

namespace mayfly {

class WorldCosts {
 public:
  WorldCosts(const Scenario& scenario, int threads, const Progress& progress, const fields::FieldCache& cache)
      : scenario_(scenario), threads_(threads), progress_(progress), cache_(cache) {}

  // Adds costs, warnings, timing; where fields change in flight also the solver and the walls of the first
  // set. Errors name the goal.
  std::vector<Error> add_to(World& world);

 private:
  using CostField = std::shared_ptr<const fields::CostField>;

  void solve_changing(World& world);
  CostField make_cost(const World& world, const SwarmSpec& swarm);
  Result<fields::CostField> load_or_solve(const World& world, const SwarmSpec& swarm);
  void refuse(Error error, const SwarmSpec& swarm);

  const Scenario& scenario_;
  int threads_;
  const Progress& progress_;
  const fields::FieldCache& cache_;
  bool cached_ = true;
  std::vector<CostField> first_;  // of the fields that change, in the solver's order
  std::vector<Error> errors_;
};

}  // namespace mayfly
