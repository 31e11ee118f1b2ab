// Faults at set times: each strikes whom it names, from its first instant to its last, and nobody else.
#include <cmath>

#include "tests/unit/sim_hal/flight.hpp"

namespace mayfly::sim_hal {
namespace {

constexpr Time kBegin = std::chrono::milliseconds(100);
constexpr Time kEnd = std::chrono::milliseconds(200);
constexpr RobotIndex kStruck = 3;

SimHalConfig with(Effect effect, float size = 0.0F, Plant plant = Plant::kIdeal) {
  SimHalConfig config = row_of(8, plant);
  config.seed = 11;
  ScriptedFault fault;
  fault.effect = effect;
  fault.robots = {{kStruck, 1}, {kStruck + 2, 1}};
  fault.from = kBegin;
  fault.until = kEnd;
  fault.size = size;
  fault.direction = {0.0F, 1.0F, 0.0F};
  config.script = {fault};
  return config;
}

bool is_struck(std::size_t robot) {
  return robot == kStruck || robot == kStruck + 2;
}

// A flight whose commands may be refused.
class Script : public ::testing::Test {
 protected:
  void start(const SimHalConfig& config) {
    hal_ = std::make_unique<SimHal>(config);
    states_ = std::make_unique<contract::States>(config.positions.size());
    commands_ = std::make_unique<contract::Commands>(config.positions.size());
    ASSERT_TRUE(hal_->configure().has_value());
    ASSERT_TRUE(hal_->activate(origin_).has_value());
    now_ = origin_;
  }
  // Reads and writes; `since_` is the time of it.
  void tick() {
    since_ = now_ - origin_;
    read_ = hal_->read(now_, states_->columns());
    written_ = hal_->write(now_, commands_->columns(now_ + patience_, ++sequence_));
    now_ += std::chrono::milliseconds(10);
  }
  bool is_on() const { return since_ >= kBegin && since_ < kEnd; }
  PoseView truth() { return hal_->truth(); }

  Time origin_ = std::chrono::seconds(5);
  Time now_{0}, since_{0};
  Time patience_ = std::chrono::milliseconds(50);
  std::uint64_t sequence_ = 0;
  HalResult read_, written_;
  std::unique_ptr<SimHal> hal_;
  std::unique_ptr<contract::States> states_;
  std::unique_ptr<contract::Commands> commands_;
};

TEST_F(Script, AStalePoseIsNoSample) {
  start(with(Effect::kPoseStale));
  for (int i = 0; i < 30; ++i) {
    tick();
    for (std::size_t robot = 0; robot < 8; ++robot) {
      ASSERT_EQ(states_->valid[robot] == 0, is_on() && is_struck(robot)) << i << " " << robot;
    }
  }
}

TEST_F(Script, AFrozenPoseStaysWhileStampsGoOn) {
  start(with(Effect::kPoseFrozen));
  float kept = 0.0F;
  for (int i = 0; i < 30; ++i) {
    tick();
    const bool equal = states_->x[kStruck] == truth().columns[0][kStruck];
    ASSERT_EQ(equal, !is_on()) << i;
    ASSERT_EQ(states_->stamp[kStruck], truth().stamp);
    ASSERT_EQ(states_->x[0], truth().columns[0][0]);
    if (is_on()) {
      ASSERT_EQ(states_->x[kStruck], kept);
    }
    kept = is_on() ? kept : states_->x[kStruck];
  }
}

TEST_F(Script, ANanClaimsToBeValid) {
  start(with(Effect::kPoseNan));
  for (int i = 0; i < 30; ++i) {
    tick();
    for (std::size_t robot = 0; robot < 8; ++robot) {
      ASSERT_EQ(std::isnan(states_->z[robot]), is_on() && is_struck(robot));
      ASSERT_EQ(states_->valid[robot], 1);
    }
  }
}

TEST_F(Script, AJumpIsToldAndNotFlown) {
  start(with(Effect::kPoseJump, 0.5F));
  for (int i = 0; i < 30; ++i) {
    tick();
    const float told = states_->y[kStruck] - truth().columns[1][kStruck];
    ASSERT_FLOAT_EQ(told, is_on() ? 0.5F : 0.0F);
    ASSERT_EQ(states_->x[kStruck], truth().columns[0][kStruck]);
  }
}

TEST_F(Script, SwappedRobotsAreToldInEachOthersPlace) {
  start(with(Effect::kIdSwap));
  for (int i = 0; i < 30; ++i) {
    tick();
    const RobotIndex other = is_on() ? kStruck + 2 : kStruck;
    ASSERT_EQ(states_->x[kStruck], truth().columns[0][other]);
    ASSERT_EQ(states_->x[other], truth().columns[0][kStruck]);
  }
}

TEST_F(Script, WindDriftsEvenWhoHolds) {
  start(with(Effect::kWind, 0.4F));
  commands_->kind.assign(8, CommandKind::kHold);
  for (int i = 0; i < 40; ++i) {
    tick();
  }
  EXPECT_NEAR(truth().columns[1][kStruck], 0.4F * 0.1F, 1e-5F) << "for a tenth of a second";
  EXPECT_EQ(truth().columns[1][0], 0.0F);
  EXPECT_EQ(truth().columns[4][kStruck], 0.0F) << "the wind is over";
}

TEST_F(Script, AWeakMotorIsSlower) {
  start(with(Effect::kWeakMotor, 0.1F));
  for (int i = 0; i < 40; ++i) {
    tick();
    const float wanted = is_on() && since_ > kBegin ? 0.5F : 1.0F;  // of 1 m/s; 0.1 of 5 m/s is what is left
    if (since_ > Time(0) && since_ != kEnd) {
      ASSERT_FLOAT_EQ(truth().columns[3][kStruck], wanted) << i;
      ASSERT_FLOAT_EQ(truth().columns[3][0], 1.0F);
    }
  }
}

TEST_F(Script, ASilentRobotObeysItsLastCommandUntilItsDeadline) {
  start(with(Effect::kSilent));
  for (int i = 0; i < 30; ++i) {
    tick();
    const Telemetry& told = states_->telemetry[kStruck];
    ASSERT_EQ(told.heard == origin_ + since_, !is_on()) << i;
    ASSERT_EQ(states_->telemetry[0].heard, origin_ + since_);
    ASSERT_EQ(states_->valid[kStruck], 1) << "it is seen from outside";
    ASSERT_EQ(read_.fault, is_on() ? HalFault::kRobotSilent : HalFault::kNone);
    ASSERT_EQ(read_.robot, is_on() ? kStruck : kEveryRobot);
    // Heard last at 90 ms, with a deadline at 140 ms; heard again at 200 ms.
    const bool stopped = since_ > Time(std::chrono::milliseconds(140)) && since_ <= kEnd;
    if (i > 0) {
      ASSERT_EQ(truth().columns[3][kStruck], stopped ? 0.0F : 1.0F) << i;
      ASSERT_EQ(truth().columns[3][0], 1.0F);
    }
  }
}

TEST_F(Script, ALostLinkSilencesAll) {
  start(with(Effect::kLinkLost));
  for (int i = 0; i < 30; ++i) {
    tick();
    ASSERT_EQ(read_.fault, is_on() ? HalFault::kLinkDown : HalFault::kNone);
    ASSERT_EQ(written_.fault, read_.fault);
    for (std::size_t robot = 0; robot < 8; ++robot) {
      ASSERT_EQ(states_->telemetry[robot].heard == origin_ + since_, !is_on());
    }
  }
}

TEST_F(Script, ALostLinkOfSeveralSilencesThoseOnIt) {
  SimHalConfig config = with(Effect::kLinkLost);
  config.links = 2;
  config.script[0].robots = {{kStruck, 1}};
  start(config);
  EXPECT_EQ(hal_->robots()[3].link, "sim/0");
  EXPECT_EQ(hal_->robots()[4].link, "sim/1");
  for (int i = 0; i < 30; ++i) {
    tick();
    ASSERT_EQ(read_.fault, is_on() ? HalFault::kLinkDown : HalFault::kNone);
    ASSERT_EQ(read_.link, is_on() ? "sim/0" : "");
    for (std::size_t robot = 0; robot < 8; ++robot) {
      ASSERT_EQ(states_->telemetry[robot].heard == origin_ + since_, !is_on() || robot > 3) << i;
    }
  }
}

TEST_F(Script, WhereSeveralLinksAreLostNoneIsNamed) {
  SimHalConfig config = with(Effect::kLinkLost);
  config.links = 2;
  start(config);
  for (int i = 0; i < 15; ++i) {
    tick();
  }
  EXPECT_EQ(read_.fault, HalFault::kLinkDown);
  EXPECT_EQ(read_.link, "sim") << "the HAL, which is no robot's link";
}

TEST_F(Script, ALateLinkCarriesCommandsAndAnswersLate) {
  constexpr Time kTickTime = std::chrono::milliseconds(10);
  start(with(Effect::kLinkLatency, 0.025F));
  const auto speed = [](Time::rep tick) { return 0.1F * static_cast<float>(tick); };
  for (int i = 0; i < 40; ++i) {
    commands_->vx.assign(8, speed(i));
    tick();
    if (i > 0) {
      ASSERT_EQ(truth().columns[3][0], speed(i - 1)) << i;
    }
    // Until the first that is late is there, the last that was not is obeyed.
    if (since_ > kBegin && since_ <= kEnd) {
      ASSERT_EQ(truth().columns[3][kStruck], speed(i < 13 ? 9 : i - 3)) << i;
    }
    if (is_on() && since_ > kBegin) {
      const Time heard = std::max(kBegin - kTickTime, since_ - Time(std::chrono::milliseconds(25)));
      ASSERT_NEAR(to_seconds(states_->telemetry[kStruck].heard - origin_), to_seconds(heard), 1e-6);
      ASSERT_LT(states_->telemetry[kStruck].link_quality, 1.0F);
    }
  }
}

TEST_F(Script, AGhostTakesTurnsWithItsRobot) {
  start(with(Effect::kPoseGhost, 2.0F));
  for (int i = 0; i < 30; ++i) {
    tick();
    const bool is_ghost = is_on() && ((since_ - kBegin) / Time(30'000'000)) % 2 == 0;
    ASSERT_FLOAT_EQ(states_->y[kStruck], truth().columns[1][kStruck] + (is_ghost ? 2.0F : 0.0F)) << i;
    ASSERT_EQ(states_->y[0], truth().columns[1][0]);
  }
}

TEST_F(Script, LossShowsInTheQualityOfTheLink) {
  SimHalConfig config = with(Effect::kLinkLoss, 0.3F);
  config.script[0].until = std::chrono::seconds(24);
  start(config);
  double sum = 0.0;
  for (int i = 0; i < 2600; ++i) {
    tick();
    ASSERT_EQ(states_->telemetry[0].link_quality, 1.0F);
    if (i > 150 && i < 2400) {
      ASSERT_NEAR(states_->telemetry[kStruck].link_quality, 0.7F, 0.2F);
      sum += static_cast<double>(states_->telemetry[kStruck].link_quality);
    }
  }
  EXPECT_NEAR(sum / 2249.0, 0.7, 0.05);  // five standard errors of 2350 polls
  EXPECT_EQ(states_->telemetry[kStruck].link_quality, 1.0F) << "a second after the last loss";
}

TEST_F(Script, BatteriesAreLowJumpAndAreNoNumbers) {
  for (const Effect effect : {Effect::kBatteryLow, Effect::kBatteryJump, Effect::kBatteryNan}) {
    start(with(effect, 0.2F));
    for (int i = 0; i < 30; ++i) {
      tick();
      const float charge = states_->telemetry[kStruck].battery;
      ASSERT_EQ(states_->telemetry[0].battery, 1.0F);
      if (!is_on()) {
        ASSERT_EQ(charge, 1.0F);
      } else if (effect == Effect::kBatteryNan) {
        ASSERT_TRUE(std::isnan(charge));
      } else {
        ASSERT_FLOAT_EQ(charge, effect == Effect::kBatteryLow ? 0.2F : 0.8F);
      }
    }
  }
}

TEST_F(Script, ABatteryRunsDown) {
  SimHalConfig config = row_of(8);
  config.endurance = 2.0F;
  start(config);
  for (int i = 0; i <= 100; ++i) {
    tick();
  }
  EXPECT_FLOAT_EQ(states_->telemetry[0].battery, 0.5F);
}

TEST_F(Script, AFailedSimulationStaysFailed) {
  start(with(Effect::kSimulationFails));
  for (int i = 0; i < 30; ++i) {
    tick();
    // The step that begins at 100 ms is the first that fails; it is asked for a tick later.
    const bool failed = since_ > kBegin;
    ASSERT_EQ(read_.fault, failed ? HalFault::kGivenUp : HalFault::kNone) << i;
    ASSERT_EQ(states_->valid[0] == 0, failed);
  }
}

TEST_F(Script, FaultsAreCountedFromTheFirstActivation) {
  start(with(Effect::kPoseStale));
  tick();
  ASSERT_TRUE(hal_->deactivate(now_).has_value());
  ASSERT_TRUE(hal_->activate(origin_ + kBegin).has_value());
  sequence_ = 0;
  now_ = origin_ + kBegin;
  tick();
  EXPECT_EQ(states_->valid[kStruck], 0);
}

}  // namespace
}  // namespace mayfly::sim_hal
