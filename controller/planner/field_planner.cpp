#include "controller/planner/field_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/flight/swarm_models.hpp"

namespace mayfly {
namespace {

std::vector<std::uint8_t> who_avoids(const Scenario& scenario) {
  std::vector<std::uint8_t> avoids;
  for (const SwarmSpec& swarm : scenario.swarms) {
    avoids.insert(avoids.end(), static_cast<std::size_t>(swarm.count), swarm.avoidance.on ? 1 : 0);
  }
  const bool any = std::find(avoids.begin(), avoids.end(), 1) != avoids.end();
  return any ? avoids : std::vector<std::uint8_t>();
}

std::vector<float> lead_times(const Scenario& scenario) {
  std::vector<float> lead;
  for (const SwarmSpec& swarm : scenario.swarms) {
    lead.insert(lead.end(), static_cast<std::size_t>(swarm.count), response_time(scenario, swarm));
  }
  return lead;
}

}  // namespace

FieldPlanner::FieldPlanner(const Scenario& scenario, Engine& engine, FieldKeeper* keeper,
                           const PlanTiming& timing)
    : engine_(engine),
      keeper_(keeper),
      timing_(timing),
      motion_(scenario),
      roster_(scenario),
      stimuli_(scenario),
      lead_(lead_times(scenario)),
      avoids_(who_avoids(scenario)) {
  agents_ = lead_.size();
  there_ = Columns3(roster_.changes() ? agents_ : 0);
  ahead_ = Columns3(agents_);
  last_ = Columns3(timing_.latency_s > 0.0 ? agents_ : 0);
}

void FieldPlanner::plan(std::uint64_t number, const SwarmView& at, Plan& out) noexcept {
  const double time_s = at.time_s + timing_.latency_s;
  motion_.set_time(time_s);
  roster_.set_time(time_s);
  stimuli_.move(time_s, engine_);
  renew_fields(time_s, at, out);
  look_ahead(at);
  leave_out_absent(ahead_);
  const TickCounts counts =
      engine_.compute(ahead(at), {number, time_s, timing_.period_s}, out.velocity.writable());
  ++totals_.plans;
  totals_.moved += counts.moved;
  count_infeasible(time_s, counts.infeasible, out);
  const std::string_view fault = engine_.fault();
  out.engine = {fault.empty() ? HalFault::kNone : HalFault::kLinkDown, kEveryRobot, engine_.name(), fault};
  if (!last_.x.empty()) {
    last_ = out.velocity;  // of the same size: nothing is allocated
  }
}

void FieldPlanner::renew_fields(double time_s, const SwarmView& at, Plan& out) noexcept {
  if (keeper_ == nullptr) {
    return;
  }
  PositionColumns places{at.x, at.y, at.z};
  if (roster_.changes()) {
    std::copy(places.x.begin(), places.x.end(), there_.x.begin());
    std::copy(places.y.begin(), places.y.end(), there_.y.begin());
    std::copy(places.z.begin(), places.z.end(), there_.z.begin());
    leave_out_absent(there_);
    places = {there_.x, there_.y, there_.z};
  }
  keeper_->tick(time_s, places, motion_, engine_);
  out.solver = keeper_->solver_state();
  for (std::size_t s = 0; s < out.goals.size(); ++s) {
    out.goals[s] = keeper_->state_of(s);
  }
}

// The model steers p + τ·v: of a robot whose velocity lags by τ this point moves exactly as commanded, so
// the model's paths and distances hold for it, and the robot trails it. Until the plan takes effect it moves
// by the one before.
void FieldPlanner::look_ahead(const SwarmView& at) noexcept {
  for (std::size_t a = 0; a < agents_; ++a) {
    ahead_.x[a] = at.x[a] + lead_[a] * at.vx[a];
    ahead_.y[a] = at.y[a] + lead_[a] * at.vy[a];
    ahead_.z[a] = at.z[a] + lead_[a] * at.vz[a];
  }
  const auto latency = static_cast<float>(timing_.latency_s);
  for (std::size_t a = 0; a < last_.x.size(); ++a) {
    ahead_.x[a] += latency * last_.x[a];
    ahead_.y[a] += latency * last_.y[a];
    ahead_.z[a] += latency * last_.z[a];
  }
}

AgentColumns FieldPlanner::ahead(const SwarmView& at) const noexcept {
  if (last_.x.empty()) {
    return {ahead_.x, ahead_.y, ahead_.z, at.told_x, at.told_y, at.told_z};
  }
  return {ahead_.x, ahead_.y, ahead_.z, last_.x, last_.y, last_.z};
}

// Who is not there has no place, and nobody minds it.
void FieldPlanner::leave_out_absent(Columns3& places) const noexcept {
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t a = 0; a < agents_ && roster_.changes(); ++a) {
    if (!roster_.is_there(a)) {
      places.x[a] = places.y[a] = places.z[a] = kNowhere;
    }
  }
}

void FieldPlanner::count_infeasible(double time_s, std::size_t infeasible, Plan& out) noexcept {
  std::size_t avoiding = 0;
  for (std::size_t a = 0; a < avoids_.size(); ++a) {
    avoiding += avoids_[a] != 0 && std::isfinite(ahead_.x[a]) ? 1U : 0U;
  }
  totals_.infeasible += infeasible;
  totals_.avoiding += avoiding;
  if (avoiding > 0 && infeasible >= avoiding && !all_infeasible_s_) {
    all_infeasible_s_ = time_s;
  }
  out.all_infeasible_s = all_infeasible_s_;
}

}  // namespace mayfly
