// What the models make of a state: the velocity that each agent would like.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/flight/field_keeper.hpp"
#include "controller/flight/motion.hpp"
#include "controller/flight/roster.hpp"
#include "controller/flight/stimuli.hpp"
#include "controller/planner/plan.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// When a plan takes effect, and for how long it is flown.
struct PlanTiming {
  double latency_s = 0.0;  // after the state that it was made from
  float period_s = 0.01F;
};

// Runs the engine, and keeps its fields and stimuli up to date. Either in the control tick or beside it; one
// thread. A plan allocates nothing.
class FieldPlanner {
 public:
  // All must outlive it. `engine` is prepared for the scenario's swarms; `keeper` may be null: then fields
  // stay as they are.
  FieldPlanner(const Scenario& scenario, Engine& engine, FieldKeeper* keeper, const PlanTiming& timing);

  // `number` is the plan's: random choices follow from it.
  void plan(std::uint64_t number, const SwarmView& at, Plan& out) noexcept;

  // Of all plans so far. Not during one.
  struct Totals {
    std::uint64_t plans = 0;
    std::uint64_t moved = 0;       // agents that minimum distances moved
    std::uint64_t infeasible = 0;  // agents without a velocity clear of everybody
    std::uint64_t avoiding = 0;    // agents that avoid collisions
  };
  const Totals& totals() const { return totals_; }
  bool avoids() const { return !avoids_.empty(); }
  FieldKeeper* keeper() { return keeper_; }
  const FieldKeeper* keeper() const { return keeper_; }

 private:
  void renew_fields(double time_s, const SwarmView& at, Plan& out) noexcept;
  void look_ahead(const SwarmView& at) noexcept;
  AgentColumns ahead(const SwarmView& at) const noexcept;
  void leave_out_absent(Columns3& places) const noexcept;
  void count_infeasible(double time_s, std::size_t infeasible, Plan& out) noexcept;

  Engine& engine_;
  FieldKeeper* keeper_;
  PlanTiming timing_;
  std::size_t agents_;
  Motion motion_;
  Roster roster_;
  MovingStimuli stimuli_;
  std::vector<float> lead_;           // s, one an agent
  std::vector<std::uint8_t> avoids_;  // one an agent: whether it avoids collisions; empty: nobody does
  Columns3 there_;                    // m; of the swarm as it is known, without those who are not there
  Columns3 ahead_;
  Columns3 last_;  // m/s: what was planned last, which is flown until this plan takes effect
  std::optional<double> all_infeasible_s_;
  Totals totals_;
};

}  // namespace mayfly
