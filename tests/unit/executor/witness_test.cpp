#include "controller/executor/witness.hpp"

#include <gtest/gtest.h>

#include "controller/clock/realtime_clock.hpp"
#include "tests/unit/executor/scripted_clock.hpp"

namespace mayfly {
namespace {

using namespace std::chrono_literals;

TEST(Witness, SleepsHalfwayBetweenReleasesAndTellsHowLateItWoke) {
  ScriptedClock clock;
  const Time start = clock.now();
  const WorkMark idle;
  Witness witness(idle);
  EXPECT_FALSE(witness.oversleep().has_value());
  witness.look(clock, start, 10ms);
  EXPECT_EQ(clock.now(), start + 15ms);
  clock.oversleep = 3ms;
  witness.look(clock, start, 10ms);
  EXPECT_EQ(clock.now(), start + 28ms);
  clock.oversleep = 0ms;
  witness.look(clock, start, 10ms);
  EXPECT_EQ(clock.now(), start + 35ms);
  EXPECT_DOUBLE_EQ(witness.oversleep()->max, 3000.0);
  EXPECT_EQ(witness.oversleep()->p50, 0.0);
  EXPECT_EQ(witness.set_aside(), 0U);
}

TEST(Witness, AMomentAtWhichControlWorkedTellsNothingOfTheMachine) {
  ScriptedClock clock;
  const Time start = clock.now();
  WorkMark control;
  Witness witness(control);
  control.begin(start + 10ms);  // and still at it
  clock.oversleep = 3ms;
  witness.look(clock, start, 10ms);
  control.end(start + 18ms);
  EXPECT_EQ(witness.set_aside(), 1U);
  EXPECT_FALSE(witness.oversleep().has_value());
  control.begin(start + 20ms);
  control.end(start + 24ms);  // over before 25 ms
  clock.oversleep = 2ms;
  witness.look(clock, start, 10ms);
  EXPECT_EQ(witness.set_aside(), 1U);
  EXPECT_DOUBLE_EQ(witness.oversleep()->max, 2000.0);
}

TEST(Witness, StartsAndEndsBesideARealClock) {
  RealtimeClock clock;
  const WorkMark idle;
  Witness witness(idle);
  ASSERT_TRUE(witness.start(clock, clock.now(), 1ms, {}));
  witness.stop();
  witness.stop();
  SUCCEED();
}

}  // namespace
}  // namespace mayfly
