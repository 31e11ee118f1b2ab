// A goal that moves is followed, and its fields are no older than they say.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "controller/flight/motion.hpp"
#include "tests/sim/fields_in_flight/worlds.hpp"

namespace mayfly::test {
namespace {

// Mean distance to where the goal's centre is at that very tick.
class GoalDistance final : public Observer {
 public:
  GoalDistance(const Scenario& scenario, glm::vec3 centre) : motion_(scenario), centre_(centre) {}
  void on_tick(const TickView& view) noexcept override {
    motion_.set_time(to_seconds(view.time));
    const glm::vec3 goal = centre_ + motion_.goal(0);
    double sum = 0;
    for (std::size_t a = 0; a < view.x.size(); ++a) {
      sum += std::hypot(view.x[a] - goal.x, view.y[a] - goal.y, view.z[a] - goal.z);
    }
    mean = sum / static_cast<double>(view.x.size());
    if (to_seconds(view.time) > 20) {
      worst_mean = std::max(worst_mean, mean);
    }
  }
  double mean = 0, worst_mean = 0;

 private:
  Motion motion_;
  glm::vec3 centre_;
};

TEST(MovingGoal, IsFollowed) {
  const Scenario scenario = chase(40, 45);
  GoalDistance distance(scenario, {24, 6, 6});
  const std::array<Observer*, 1> observers{&distance};
  const Summary summary = flown(scenario, {.threads = 1, .observers = observers});
  EXPECT_EQ(summary.reached_fraction, 1.0);
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_TRUE(summary.faults.empty());
  EXPECT_LT(distance.worst_mean, 4.0) << "m from a goal of 3 m radius, 20 s after the start and later";
  std::printf("chase: %.2f m from the goal's centre at worst\n", distance.worst_mean);
}

// Taken at one planner's tick, swapped in at the next, flown by until the one after it.
TEST(MovingGoal, HasFieldsOfOneToTwoPeriods) {
  Scenario scenario = chase(4, 4);
  const Summary summary = flown(scenario);
  ASSERT_TRUE(summary.fields && summary.fields->age_s);
  EXPECT_EQ(summary.fields->updates, 19U) << "five a second, but for the first, which was solved before";
  EXPECT_NEAR(summary.fields->age_s->max, 0.39, 1e-6);
  EXPECT_NEAR(summary.fields->age_s->p50, 0.29, 0.01);
  scenario.field_rate = 1e4F;  // no more often than control
  const Summary often = flown(scenario);
  ASSERT_TRUE(often.fields && often.fields->age_s);
  EXPECT_EQ(often.fields->updates, 399U);
  EXPECT_NEAR(often.fields->age_s->max, 0.01, 1e-6);
}

TEST(MovingGoal, NothingIsSolvedWhereNothingMoves) {
  Scenario scenario = chase(4, 1);
  scenario.world.goals[0].path.reset();
  EXPECT_FALSE(flown(scenario).fields);
}

TEST(MovingGoal, MayStayAtItsEndAndMayBeFollowedByNobody) {
  Scenario scenario = chase(4, 30);
  scenario.world.goals[0].path->loop = false;
  scenario.world.goals[0].path->points.resize(2);
  EXPECT_EQ(flown(scenario).reached_fraction, 1.0);
  scenario.swarms[0].count = 0;
  scenario.duration = 2;
  EXPECT_TRUE(flown(scenario).faults.empty());
}

}  // namespace
}  // namespace mayfly::test
