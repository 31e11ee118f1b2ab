// The field model at a rate of its own: control flies the last velocities that it handed over.
#pragma once

#include "controller/executor/handover.hpp"
#include "controller/planner/field_planner.hpp"
#include "controller/planner/plan.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// Of the scenario's planner of that name; null where there is none.
const PlannerSpec* curl_noise_of(const Scenario& scenario);
// From a planner's release to when its plan is there: as the scenario says, else one period.
Time latency_of(const PlannerSpec& planner);
// With which the field model plans: those of the planner, where there is one, else of the control tick.
PlanTiming plan_timing(const Scenario& scenario);

// One thread calls work and publish, another one the rest.
class CurlNoisePlanner final : public Planner {
 public:
  // A plan that was made from a state older than `limit` is none: three periods of the planner, or of control
  // where that is longer. Healthy ones are at most two periods of the planner and one of control old.
  CurlNoisePlanner(const Scenario& scenario, FieldPlanner& model);

  void work(std::uint64_t release, Time now) noexcept override;
  void publish() noexcept override;

  // Control's: hands over what it knows at `now`.
  void offer(Time now, const SwarmView& at) noexcept;
  // The newest plan, or null: none yet, or too old.
  const Plan* newest(Time now) noexcept;
  // What is wrong where there is none; kNone before a first plan could be there.
  HalResult fault(Time since_start, const Plan* newest) const noexcept;

  AgeStats estimate_ages() const { return estimate_.stats(); }
  AgeStats plan_ages() const { return plan_.stats(); }

 private:
  FieldPlanner& model_;
  Handover<SwarmCopy> estimate_;
  Handover<Plan> plan_;
  Time stamp_ = Time::min();  // of the state that the draft was made from; min(): there is no draft
};

}  // namespace mayfly
