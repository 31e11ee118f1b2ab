#include "sim_hal/step_clock.hpp"

#include <gtest/gtest.h>

namespace mayfly::sim_hal {
namespace {

constexpr Time kOrigin = std::chrono::milliseconds(1234);

TEST(StepClock, CountsWholeSteps) {
  const StepClock clock(kOrigin, 200.0);
  EXPECT_EQ(clock.steps_at(Time(0)), 0);
  EXPECT_EQ(clock.steps_at(kOrigin), 0);
  EXPECT_EQ(clock.steps_at(kOrigin + std::chrono::milliseconds(5) - Time(1)), 0);
  EXPECT_EQ(clock.steps_at(kOrigin + std::chrono::milliseconds(5)), 1);
  EXPECT_EQ(clock.time_of(1), kOrigin + std::chrono::milliseconds(5));
}

TEST(StepClock, DoesNotDrift) {
  for (const double rate : {1.0, 29.97, 300.0, 1000.0, 4999.999}) {
    const StepClock clock(kOrigin, rate);
    const auto thousand_days = std::chrono::hours(24000);
    // rate · 1000 is a whole number of steps in a thousand seconds, without a remainder
    const auto steps = static_cast<std::int64_t>(std::llround(rate * 1e3)) * (24000 * 3600 / 1000);
    EXPECT_EQ(clock.steps_at(kOrigin + thousand_days), steps) << rate;
    EXPECT_EQ(clock.time_of(steps), kOrigin + thousand_days) << rate;
  }
}

TEST(StepClock, EveryStepBeginsWhereItIsFirstCounted) {
  for (const double rate : {1.0, 7.0, 29.97, 300.0, 333.333, 4999.999}) {
    const StepClock clock(kOrigin, rate);
    for (std::int64_t step = 1; step < 20'000'000; step = step * 2 + 1) {
      ASSERT_EQ(clock.steps_at(clock.time_of(step)), step) << rate;
      ASSERT_EQ(clock.steps_at(clock.time_of(step) - Time(1)), step - 1) << rate;
      ASSERT_EQ(clock.first_step_from(clock.time_of(step)), step) << rate;
      ASSERT_EQ(clock.first_step_from(clock.time_of(step) + Time(1)), step + 1) << rate;
    }
  }
}

TEST(StepClock, TheFirstStepBeginsAtTheOrigin) {
  const StepClock clock(kOrigin, 100.0);
  EXPECT_EQ(clock.first_step_from(Time(0)), 0);
  EXPECT_EQ(clock.first_step_from(kOrigin), 0);
  EXPECT_EQ(clock.first_step_from(kOrigin + Time(1)), 1);
}

}  // namespace
}  // namespace mayfly::sim_hal
