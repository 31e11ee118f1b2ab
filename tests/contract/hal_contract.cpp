// The contract itself; linked into each test that instantiates it.
#include "tests/contract/hal_contract.hpp"

#include <algorithm>
#include <set>

namespace mayfly::contract {

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(HalContract);

TEST_P(HalContract, NothingMovesBeforeConfigure) {
  make(2);
  EXPECT_EQ(hal_->state(), HalState::kCreated);
  EXPECT_FALSE(hal_->activate(now_).has_value());
  EXPECT_EQ(read().fault, HalFault::kWrongState);
  EXPECT_EQ(write().fault, HalFault::kWrongState);
  EXPECT_EQ(refused_calls(), 3U);
  EXPECT_TRUE(hal_->deactivate(now_).has_value());  // there is nothing to let go of, and that is no error
  EXPECT_EQ(hal_->state(), HalState::kCreated);
}

TEST_P(HalContract, NothingMovesBeforeActivate) {
  make(2);
  ASSERT_TRUE(hal_->configure().has_value());
  EXPECT_EQ(hal_->state(), HalState::kConfigured);
  EXPECT_FALSE(hal_->configure().has_value());
  EXPECT_EQ(read().fault, HalFault::kWrongState);
  EXPECT_EQ(write().fault, HalFault::kWrongState);
  EXPECT_EQ(refused_calls(), 3U);
  EXPECT_TRUE(hal_->deactivate(now_).has_value());
  EXPECT_EQ(hal_->state(), HalState::kConfigured);
}

TEST_P(HalContract, SetUpIsRefusedWhileActive) {
  make_active(2);
  EXPECT_EQ(hal_->state(), HalState::kActive);
  EXPECT_FALSE(hal_->configure().has_value());
  EXPECT_FALSE(hal_->activate(now_).has_value());
  EXPECT_EQ(refused_calls(), 2U);
  EXPECT_EQ(hal_->state(), HalState::kActive);
  EXPECT_TRUE(read().ok());
}

TEST_P(HalContract, NothingMovesAfterDeactivate) {
  make_active(2);
  fly(3);
  ASSERT_TRUE(hal_->deactivate(now_).has_value());
  EXPECT_EQ(hal_->state(), HalState::kInactive);
  EXPECT_TRUE(hal_->deactivate(now_).has_value());
  EXPECT_EQ(refused_calls(), 0U);
  EXPECT_FALSE(hal_->configure().has_value());
  EXPECT_EQ(read().fault, HalFault::kWrongState);
  EXPECT_EQ(write().fault, HalFault::kWrongState);
  EXPECT_EQ(refused_calls(), 3U);
}

TEST_P(HalContract, RefusedReadsLeaveTheColumnsAlone) {
  make(1);
  states_.x[0] = 42.0F;
  states_.valid[0] = 7;
  read();
  EXPECT_EQ(states_.x[0], 42.0F);
  EXPECT_EQ(states_.valid[0], 7);
}

TEST_P(HalContract, CanBeActivatedAgainWithRobotsAtRest) {
  make_active(3);
  fly(50);
  ASSERT_TRUE(hal_->deactivate(now_).has_value());
  now_ += GetParam().settling;
  ASSERT_TRUE(hal_->activate(now_).has_value());
  ASSERT_TRUE(read().ok());
  for (std::size_t robot = 0; robot < 3; ++robot) {
    EXPECT_LT(states_.speed(robot), 1e-3F);
    EXPECT_GE(states_.stamp[robot], now_ - GetParam().settling);
  }
  sequence_ = 0;  // a new activation begins a new sequence
  fly(50);
  EXPECT_GT(states_.vx[0], 0.0F);
}

TEST_P(HalContract, ReadComesBeforeAnyWrite) {
  make_active(2);
  EXPECT_TRUE(read().ok());
  now_ += kStep;
  EXPECT_TRUE(read().ok());
  EXPECT_EQ(hal_->counters().reads, 2U);
  EXPECT_EQ(hal_->counters().writes, 0U);
}

TEST_P(HalContract, RobotsGoWhereTheyAreTold) {
  make_active(2);
  ASSERT_TRUE(read().ok());
  const float x = states_.x[0];
  const float y = states_.y[0];
  commands_.vx[1] = 0.0F;
  commands_.vy[1] = -1.0F;
  const float y1 = states_.y[1];
  fly(100);
  EXPECT_GT(states_.x[0], x + 0.25F);
  EXPECT_NEAR(states_.y[0], y, 1e-3F);
  EXPECT_LT(states_.y[1], y1 - 0.25F);
  EXPECT_EQ(hal_->counters().reads, 101U);
  EXPECT_EQ(hal_->counters().writes, 100U);
  EXPECT_EQ(refused_commands(), 0U);
}

TEST_P(HalContract, StatesAreValidFiniteAndStampedInOrder) {
  make_active(3);
  std::vector<Time> last(3, Time::min());
  for (int tick = 0; tick < 50; ++tick) {
    fly(1);
    for (std::size_t robot = 0; robot < 3; ++robot) {
      ASSERT_EQ(states_.valid[robot], 1);
      ASSERT_LE(states_.stamp[robot], now_);
      ASSERT_GE(states_.stamp[robot], last[robot]);
      ASSERT_TRUE(
          std::isfinite(states_.x[robot] + states_.y[robot] + states_.z[robot] + states_.speed(robot)));
      last[robot] = states_.stamp[robot];
    }
    now_ += std::chrono::nanoseconds(1234567);  // reads need not fall on the robots' own steps
  }
  EXPECT_GT(last[0], kStart);
}

TEST_P(HalContract, ANumberThatIsNoneMakesThatRobotHold) {
  make_active(3);
  const std::vector<float> bad{std::nanf(""), std::numeric_limits<float>::infinity(),
                               -std::numeric_limits<float>::infinity()};
  fly(50);
  std::uint64_t refused = 0;
  for (const float value : bad) {
    for (std::vector<float>* column : {&commands_.vx, &commands_.vy, &commands_.vz}) {
      commands_ = Commands(3);
      (*column)[1] = value;
      ASSERT_TRUE(read().ok());
      const HalResult result = write();
      EXPECT_EQ(result.fault, HalFault::kNotFinite);
      EXPECT_EQ(result.robot, 1U);
      EXPECT_FALSE(result.cause.empty());
      EXPECT_EQ(refused_commands(), ++refused);
      now_ += kStep;
    }
  }
  const Time end = now_ + GetParam().settling;
  while (now_ < end) {
    ASSERT_TRUE(read().ok());
    ASSERT_EQ(write().fault, HalFault::kNotFinite);
    now_ += kStep;
  }
  EXPECT_LT(states_.speed(1), 1e-3F);
  EXPECT_GT(states_.vx[0], 0.1F);
  EXPECT_GT(states_.vx[2], 0.1F);
}

TEST_P(HalContract, ANumberThatDoesNotCountMayBeAnything) {
  make_active(1);
  for (const CommandKind kind : {CommandKind::kNone, CommandKind::kHold, CommandKind::kStop}) {
    commands_ = Commands(1, kind);
    commands_.vx[0] = std::nanf("");
    EXPECT_TRUE(write().ok());
    now_ += kStep;
    ASSERT_TRUE(read().ok());
    EXPECT_TRUE(std::isfinite(states_.x[0]));
  }
  EXPECT_EQ(refused_commands(), 0U);
}

TEST_P(HalContract, HoldAndStopEndAllMotion) {
  for (const CommandKind kind : {CommandKind::kHold, CommandKind::kStop}) {
    now_ = kStart;
    sequence_ = 0;
    make_active(2);
    fly(50);
    ASSERT_GT(states_.vx[0], 0.0F);
    commands_ = Commands(2, kind);
    fly(static_cast<int>(GetParam().settling / kStep));
    EXPECT_LT(states_.speed(0), 1e-3F);
    EXPECT_LT(states_.speed(1), 1e-3F);
  }
}

TEST_P(HalContract, AnExpiredCommandMakesEveryRobotHold) {
  make_active(2);
  fly(50);
  ASSERT_TRUE(read().ok());
  ASSERT_GT(states_.vx[0], 0.0F);
  EXPECT_EQ(write(now_ - Time(1)).fault, HalFault::kExpired);
  EXPECT_EQ(refused_commands(), 2U);
  drift(GetParam().settling);
  EXPECT_LT(states_.speed(0), 1e-3F);
  EXPECT_LT(states_.speed(1), 1e-3F);
}

TEST_P(HalContract, RobotsHoldWhenTheControllerDies) {
  make_active(2);
  fly(50);
  ASSERT_TRUE(write(now_ + 5 * kStep).ok());  // and then never again
  drift(GetParam().settling);
  EXPECT_LT(states_.speed(0), 1e-3F);
  const float x = states_.x[0];
  drift(std::chrono::seconds(1));
  EXPECT_NEAR(states_.x[0], x, 1e-3F);
}

TEST_P(HalContract, OldCommandsAreRefused) {
  make_active(2);
  const Time deadline = now_ + 20 * kStep;
  EXPECT_EQ(hal_->write(now_, commands_.columns(deadline, 0)).fault, HalFault::kOutOfSequence);
  EXPECT_TRUE(hal_->write(now_, commands_.columns(deadline, 7)).ok());
  EXPECT_EQ(hal_->write(now_, commands_.columns(deadline, 7)).fault, HalFault::kOutOfSequence);
  EXPECT_EQ(hal_->write(now_, commands_.columns(deadline, 6)).fault, HalFault::kOutOfSequence);
  EXPECT_TRUE(hal_->write(now_, commands_.columns(deadline, 100)).ok());
  EXPECT_EQ(refused_commands(), 6U);
  EXPECT_EQ(hal_->counters().writes, 2U);
}

TEST_P(HalContract, ShortColumnsAreRefused) {
  make_active(3);
  const CommandColumns commands = commands_.columns(now_ + kStep, 1);
  std::vector<CommandColumns> short_commands(4, commands);
  short_commands[0].kind = commands.kind.first(2);
  short_commands[1].vx = commands.vx.first(2);
  short_commands[2].vy = commands.vy.first(2);
  short_commands[3].vz = {};
  for (const CommandColumns& each : short_commands) {
    EXPECT_EQ(hal_->write(now_, each).fault, HalFault::kWrongSize);
  }
  const StateColumns states = states_.columns();
  std::vector<StateColumns> short_states(8, states);
  short_states[0].x = states.x.first(2);
  short_states[1].y = states.y.first(2);
  short_states[2].z = states.z.first(2);
  short_states[3].vx = states.vx.first(2);
  short_states[4].vy = states.vy.first(2);
  short_states[5].vz = {};
  short_states[6].stamp = states.stamp.first(2);
  short_states[7].valid = states.valid.first(2);
  for (const StateColumns& each : short_states) {
    EXPECT_EQ(hal_->read(now_, each).fault, HalFault::kWrongSize);
  }
  EXPECT_EQ(refused_calls(), 12U);
  EXPECT_EQ(hal_->counters().reads, 0U);
  EXPECT_EQ(hal_->counters().writes, 0U);
}

TEST_P(HalContract, LongColumnsAreNotTouchedPastTheRobots) {
  make_active(2);
  states_ = States(20);
  commands_ = Commands(20);
  std::fill(states_.x.begin(), states_.x.end(), 42.0F);
  std::fill(states_.valid.begin(), states_.valid.end(), std::uint8_t{7});
  fly(3);
  EXPECT_EQ(states_.valid[1], 1);
  for (std::size_t excess = 2; excess < 20; ++excess) {
    EXPECT_EQ(states_.x[excess], 42.0F);
    EXPECT_EQ(states_.valid[excess], 7);
  }
}

TEST_P(HalContract, NoRobotsAreNoTrouble) {
  make_active(0);
  fly(3);
  EXPECT_TRUE(hal_->deactivate(now_).has_value());
}

TEST_P(HalContract, OneRobotIsASwarm) {
  make_active(1);
  fly(50);
  EXPECT_GT(states_.vx[0], 0.0F);
  EXPECT_FALSE(hal_->name().empty());
}

TEST_P(HalContract, RobotsHaveNamesOfTheirOwn) {
  make_active(5);
  std::set<std::string> names;
  for (const RobotInfo& robot : hal_->robots()) {
    EXPECT_FALSE(robot.name.empty());
    EXPECT_TRUE(names.insert(robot.name).second) << robot.name;
  }
}

TEST_P(HalContract, CanBeDestroyedWhileRobotsFly) {
  make_active(2);
  fly(10);
  hal_.reset();
}

}  // namespace mayfly::contract
