#include "controller/planner/curl_noise_planner.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

constexpr int kPeriods = 3;
// An estimate that old means that control has stopped.
constexpr int kEstimatePeriods = 5;

Time period_at(float rate) {
  return Time(std::llround(1e9 / static_cast<double>(rate)));
}

std::size_t agents_of(const Scenario& scenario) {
  std::size_t agents = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    agents += static_cast<std::size_t>(swarm.count);
  }
  return agents;
}

Time plan_limit(const Scenario& scenario) {
  return kPeriods * std::max(period_at(curl_noise_of(scenario)->rate), period_at(scenario.control.rate));
}

}  // namespace

const PlannerSpec* curl_noise_of(const Scenario& scenario) {
  const auto found = std::find_if(scenario.planners.begin(), scenario.planners.end(),
                                  [](const PlannerSpec& spec) { return spec.name == "curl_noise"; });
  return found == scenario.planners.end() ? nullptr : &*found;
}

Time latency_of(const PlannerSpec& planner) {
  const Time period = period_at(planner.rate);
  return planner.latency ? std::min(from_seconds(static_cast<double>(*planner.latency)), period) : period;
}

PlanTiming plan_timing(const Scenario& scenario) {
  const PlannerSpec* planner = curl_noise_of(scenario);
  const double rate = static_cast<double>(scenario.decision_rate());
  return {planner != nullptr ? to_seconds(latency_of(*planner)) : 0.0,
          static_cast<float>(to_seconds(from_seconds(1.0 / rate)))};
}

CurlNoisePlanner::CurlNoisePlanner(const Scenario& scenario, FieldPlanner& model)
    : model_(model),
      estimate_("estimate to curl_noise", kEstimatePeriods * period_at(scenario.control.rate),
                SwarmCopy(agents_of(scenario))),
      plan_("curl_noise to control", plan_limit(scenario),
            Plan(agents_of(scenario), scenario.swarms.size())) {}

void CurlNoisePlanner::work(std::uint64_t release, Time now) noexcept {
  const Aged<SwarmCopy>* state = estimate_.read(now);
  stamp_ = state != nullptr ? state->stamp : Time::min();
  if (state != nullptr) {
    model_.plan(release, state->value.view(), plan_.draft());
  }
}

void CurlNoisePlanner::publish() noexcept {
  if (stamp_ != Time::min()) {
    plan_.publish(stamp_);
  }
}

void CurlNoisePlanner::offer(Time now, const SwarmView& at) noexcept {
  estimate_.draft().copy(at);
  estimate_.publish(now);
}

const Plan* CurlNoisePlanner::newest(Time now) noexcept {
  const Aged<Plan>* plan = plan_.read(now);
  return plan != nullptr ? &plan->value : nullptr;
}

HalResult CurlNoisePlanner::fault(Time since_start, const Plan* newest) const noexcept {
  if (newest != nullptr || since_start <= plan_.limit()) {
    return {};
  }
  return {HalFault::kLinkDown, kEveryRobot, "curl_noise",
          "the planner's newest velocities are too old: everybody brakes"};
}

}  // namespace mayfly
