// How plans and states cross, without a flight.
#include "controller/planner/curl_noise_planner.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using namespace std::chrono_literals;

// Wants of everybody the number of the plan along x, and remembers what it was asked.
class CountingEngine final : public Engine {
 public:
  std::string_view name() const noexcept override { return "counting"; }
  Result<void> prepare(std::span<const SwarmModel>, std::size_t) override { return {}; }
  TickCounts compute(const AgentColumns& at, const TickTime& tick,
                     const VelocityColumns& out) noexcept override {
    std::fill(out.x.begin(), out.x.end(), static_cast<float>(tick.number + 1));
    std::fill(out.y.begin(), out.y.end(), 0.0F);
    std::fill(out.z.begin(), out.z.end(), 0.0F);
    first_x = at.x[0];
    told_x = at.vx[0];
    time_s = tick.time_s;
    period_s = tick.period_s;
    return {};
  }
  void move_stimuli(std::size_t, std::span<const glm::vec3>) noexcept override {}
  void replace_fields(std::size_t, const SwarmFields&) noexcept override {}

  float first_x = 0.0F, told_x = 0.0F, period_s = 0.0F;
  double time_s = 0.0;
};

Scenario planned(float rate, std::optional<float> latency) {
  Scenario scenario = hall(2);
  scenario.planners = {{"curl_noise", rate, latency, {}}};
  return scenario;
}

struct Crossing {
  explicit Crossing(const Scenario& flown)
      : scenario(flown),
        model(scenario, engine, nullptr, plan_timing(scenario)),
        planner(scenario, model),
        state(2) {}
  void offer(Time now) {
    state.time_s = to_seconds(now);
    planner.offer(now, state.view());
  }

  Scenario scenario;
  CountingEngine engine;
  FieldPlanner model;
  CurlNoisePlanner planner;
  SwarmCopy state;
};

TEST(CurlNoisePlanner, PlansFromTheNewestStateAndHandsOverTheNewestPlan) {
  Crossing c(planned(50.0F, 0.0F));
  EXPECT_EQ(c.planner.newest(0ms), nullptr);
  c.offer(0ms);
  c.state.position.x[0] = 7.0F;
  c.offer(10ms);
  c.planner.work(0, 12ms);
  EXPECT_EQ(c.engine.first_x, 7.0F);
  EXPECT_EQ(c.engine.time_s, 0.01);
  EXPECT_EQ(c.engine.period_s, 0.02F);
  EXPECT_EQ(c.planner.newest(12ms), nullptr);  // worked out, and not published
  c.planner.publish();
  ASSERT_NE(c.planner.newest(20ms), nullptr);
  EXPECT_EQ(c.planner.newest(20ms)->velocity.x[1], 1.0F);
  EXPECT_EQ(c.planner.plan_ages().max, 10ms);  // since it was sensed
}

TEST(CurlNoisePlanner, AnOldPlanIsNoneFromThreePeriodsOn) {
  Crossing c(planned(50.0F, 0.0F));
  c.offer(0ms);
  c.planner.work(0, 0ms);
  c.planner.publish();
  const Plan* at_limit = c.planner.newest(60ms);
  ASSERT_NE(at_limit, nullptr);
  EXPECT_TRUE(c.planner.fault(60ms, at_limit).ok());
  const Plan* beyond = c.planner.newest(60ms + 1ns);
  EXPECT_EQ(beyond, nullptr);
  EXPECT_EQ(c.planner.fault(60ms + 1ns, beyond).link, "curl_noise");
  EXPECT_EQ(c.planner.plan_ages().expired, 1U);
  c.offer(70ms);
  c.planner.work(1, 70ms);
  c.planner.publish();
  EXPECT_NE(c.planner.newest(70ms), nullptr);  // and it clears with the next plan
}

TEST(CurlNoisePlanner, TheLimitFollowsTheSlowerOfPlannerAndControl) {
  EXPECT_EQ(Crossing(planned(50.0F, {})).planner.plan_ages().limit, 60ms);
  EXPECT_EQ(Crossing(planned(400.0F, {})).planner.plan_ages().limit, 30ms);
}

TEST(CurlNoisePlanner, NoPlanYetIsNoFaultUntilThereShouldBeOne) {
  Crossing c(planned(50.0F, {}));
  EXPECT_TRUE(c.planner.fault(60ms, nullptr).ok());
  EXPECT_FALSE(c.planner.fault(61ms, nullptr).ok());
}

TEST(CurlNoisePlanner, OfAStateThatIsTooOldNothingIsPlanned) {
  Crossing c(planned(50.0F, 0.0F));
  c.planner.work(0, 0ms);  // control has not begun
  c.planner.publish();
  EXPECT_EQ(c.planner.newest(0ms), nullptr);
  c.offer(0ms);
  c.planner.work(1, 50ms);  // five control periods
  c.planner.publish();
  EXPECT_NE(c.planner.newest(50ms), nullptr);
  c.planner.work(2, 50ms + 1ns);  // control has stopped
  c.planner.publish();
  EXPECT_EQ(c.planner.newest(50ms)->velocity.x[0], 2.0F);
}

TEST(CurlNoisePlanner, PlansForWhenThePlanIsFlown) {
  Crossing c(planned(50.0F, 0.02F));
  c.state.told.x[0] = 9.0F;
  c.offer(0ms);
  c.planner.work(0, 0ms);
  c.planner.publish();
  EXPECT_NEAR(c.engine.time_s, 0.02, 1e-9);
  EXPECT_EQ(c.engine.first_x, 0.0F);  // no plan was flown before
  c.offer(20ms);
  c.planner.work(1, 20ms);
  EXPECT_FLOAT_EQ(c.engine.first_x, 0.02F);  // 1 m/s of the plan before, for 20 ms
  EXPECT_EQ(c.engine.told_x, 1.0F);
}

TEST(CurlNoisePlanner, WithoutLatencyItSeesWhatTheTickSees) {
  Crossing c(planned(100.0F, 0.0F));
  c.state.told.x[0] = 9.0F;
  c.offer(20ms);
  c.planner.work(0, 20ms);
  EXPECT_EQ(c.engine.time_s, 0.02);
  EXPECT_EQ(c.engine.told_x, 9.0F);
}

TEST(CurlNoisePlanner, TheLatencyIsOnePeriodUnlessItIsGiven) {
  EXPECT_EQ(latency_of({"curl_noise", 50.0F, {}, {}}), 20ms);
  EXPECT_EQ(latency_of({"curl_noise", 50.0F, 0.0F, {}}), 0ms);
  EXPECT_EQ(latency_of({"curl_noise", 30.0F, 1.0F / 30.0F, {}}), 33333333ns);  // never above the period
}

TEST(CurlNoisePlanner, AllocatesNothing) {
  Crossing c(planned(50.0F, {}));
  const std::uint64_t before = allocation_count();
  for (int k = 0; k < 50; ++k) {
    c.offer(k * 20ms);
    c.planner.work(static_cast<std::uint64_t>(k), k * 20ms);
    c.planner.publish();
    c.planner.newest(k * 20ms);
  }
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace mayfly::test
