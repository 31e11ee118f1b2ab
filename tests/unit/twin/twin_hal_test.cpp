// Robots that are taken out and put back while they fly.
#include "controller/twin/twin_hal.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "controller/estimator/estimator.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/scripted_hal.hpp"
#include "tests/contract/sim_factory.hpp"
#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

using ::testing::HasSubstr;

constexpr float kSpeed = 2.0F;
constexpr float kAcceleration = 10.0F;
constexpr double kSeconds = 0.01;

TwinConfig config_of(std::size_t robots) {
  TwinConfig config;
  config.robots.assign(robots, {kSpeed, kAcceleration});
  return config;
}

sim_hal::SimHalConfig sim_of(std::size_t robots) {
  sim_hal::SimHalConfig config = sim_hal::row_of(robots, sim_hal::Plant::kIdeal);
  config.max_speed = {kSpeed};
  config.max_acceleration = {kAcceleration};
  return config;
}

// Robots in flight, and what is seen of them.
class Flight {
 public:
  explicit Flight(std::size_t robots, TwinConfig config)
      : hal(std::make_unique<sim_hal::SimHal>(sim_of(robots)), std::move(config)),
        states(robots),
        commands(robots) {
    EXPECT_TRUE(hal.configure());
    EXPECT_TRUE(hal.activate(now));
    std::fill(commands.vx.begin(), commands.vx.end(), 0.0F);
  }
  explicit Flight(std::size_t robots) : Flight(robots, config_of(robots)) {}

  void tick() {
    const contract::States before = states;
    ASSERT_TRUE(hal.read(now, states.columns()).ok());
    for (std::size_t r = 0; r < states.x.size() && seen; ++r) {
      largest_step = std::max(
          largest_step, static_cast<double>(std::hypot(states.x[r] - before.x[r], states.y[r] - before.y[r],
                                                       states.z[r] - before.z[r])));
    }
    seen = true;
    ASSERT_TRUE(hal.write(now, commands.columns(now + 5 * kTick, ++sequence)).ok());
    now += kTick;
  }
  void fly(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick();
    }
  }

  static constexpr Time kTick = std::chrono::milliseconds(10);
  TwinHal hal;
  contract::States states;
  contract::Commands commands;
  Time now = std::chrono::seconds(1);
  std::uint64_t sequence = 0;
  bool seen = false;
  double largest_step = 0.0;  // m, of anybody in a tick
};

TEST(Twin, TakesOverInFullFlightWithoutAJump) {
  Flight flight(3);
  flight.commands.vx = {1.5F, 1.0F, 0.0F};
  flight.commands.vy = {0.5F, -1.0F, 0.0F};
  flight.fly(100);
  ASSERT_TRUE(flight.hal.take_out(1));
  EXPECT_FALSE(flight.hal.is_twin(1));
  EXPECT_EQ(flight.hal.report(1).outcome, TwinOutcome::kPending);
  flight.fly(1);
  EXPECT_TRUE(flight.hal.is_twin(1));
  EXPECT_EQ(flight.hal.report(1).outcome, TwinOutcome::kTakenOut);
  EXPECT_NEAR(flight.states.vx[1], 1.0F, 1e-5F);
  EXPECT_NEAR(flight.states.vy[1], -1.0F, 1e-5F);
  flight.fly(200);
  EXPECT_LT(flight.largest_step, 1.001 * static_cast<double>(kSpeed) * kSeconds);
  EXPECT_NEAR(flight.states.y[1], -2.98F, 0.1F) << "the twin flies on";
  EXPECT_EQ(flight.states.stamp[1], flight.now - Flight::kTick);
  EXPECT_LT(std::fabs(flight.hal.real_pose(1).y + 1.0F), 0.1F) << "the robot holds";
}

TEST(Twin, OthersAreNotAffected) {
  Flight with(3), without(3);
  for (Flight* flight : {&with, &without}) {
    flight->commands.vx = {1.5F, 1.0F, -0.7F};
    flight->fly(50);
    if (flight == &with) {
      ASSERT_TRUE(with.hal.take_out(1));
    }
    flight->fly(100);
  }
  EXPECT_TRUE(with.hal.is_twin(1));
  for (const std::size_t r : {0U, 2U}) {
    EXPECT_EQ(with.states.x[r], without.states.x[r]);
    EXPECT_EQ(with.states.vx[r], without.states.vx[r]);
    EXPECT_EQ(with.states.stamp[r], without.states.stamp[r]);
  }
}

// dv/dt = (w − v)/τ, in steps a thousand times as small.
TEST(Twin, LagsWhereItsRobotDoes) {
  constexpr double kLag = 0.1;
  TwinConfig config = config_of(1);
  config.robots[0].response_time = static_cast<float>(kLag);
  Flight flight(1, config);
  flight.fly(2);
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  double p = static_cast<double>(flight.states.x[0]), v = 0.0;
  for (const float wish : {1.0F, -1.0F, 0.3F}) {
    flight.commands.vx[0] = wish;
    for (int i = 0; i < 15; ++i) {
      flight.tick();
      EXPECT_NEAR(flight.states.x[0], p, 1e-4);
      EXPECT_NEAR(flight.states.vx[0], v, 1e-4);
      for (int step = 0; step < 1000; ++step) {
        p += 1e-3 * kSeconds * v;
        v += 1e-3 * kSeconds / kLag * (static_cast<double>(wish) - v);
      }
    }
  }
}

TEST(Twin, FollowsItsCommandsAsTheGovernorsReferenceDoes) {
  Flight flight(1);
  flight.fly(2);
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  double p = static_cast<double>(flight.states.x[0]), v = 0.0;
  const float wishes[] = {1.0F, 1.0F, -5.0F, 0.3F, 5.0F};
  for (const float wish : wishes) {
    flight.commands.vx[0] = wish;
    for (int i = 0; i < 40; ++i) {
      flight.tick();
      EXPECT_NEAR(flight.states.x[0], p, 1e-5);
      EXPECT_NEAR(flight.states.vx[0], v, 1e-5);
      // The command of this tick holds until the next.
      const double most = static_cast<double>(kAcceleration) * kSeconds;
      const double wanted = std::clamp(static_cast<double>(wish), -2.0, 2.0);
      const double next = v + std::clamp(wanted - v, -most, most);
      p += 0.5 * kSeconds * (v + next);
      v = next;
    }
  }
}

TEST(Twin, BrakesAndHoldsWithoutACommand) {
  Flight flight(1);
  flight.commands.vx[0] = 1.0F;
  flight.fly(50);
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(flight.hal.read(flight.now, flight.states.columns()).ok());
    flight.now += Flight::kTick;
  }
  EXPECT_EQ(flight.states.vx[0], 0.0F);
  flight.commands.kind[0] = CommandKind::kLand;
  flight.fly(5);
  EXPECT_EQ(flight.states.vx[0], 0.0F);
}

TEST(PutBack, WhereTheRobotIsNearGoesWithoutAJump) {
  Flight flight(2);
  flight.fly(10);
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  // There and back again.
  flight.commands.vy[0] = 1.0F;
  flight.fly(100);
  flight.commands.vy[0] = -1.0F;
  flight.fly(110);  // the ramps cost a tenth of a metre
  flight.commands.vy[0] = 0.0F;
  flight.fly(30);
  ASSERT_TRUE(flight.hal.put_back(0));
  flight.fly(1);
  const TwinReport report = flight.hal.report(0);
  EXPECT_EQ(report.outcome, TwinOutcome::kPutBack) << describe(report, flight.hal.config());
  EXPECT_LE(report.distance, 0.05F);
  EXPECT_FALSE(flight.hal.is_twin(0));
  EXPECT_LT(flight.largest_step, static_cast<double>(kSpeed) * kSeconds + 0.05);
  flight.commands.vy[0] = 1.0F;
  flight.fly(100);
  EXPECT_GT(flight.hal.real_pose(0).y, 0.8F) << "the robot flies itself";
}

// The twin is moved away by a way of `distance`, and asked back.
TwinReport back_from(double distance) {
  Flight flight(1);
  flight.fly(5);
  static_cast<void>(flight.hal.take_out(0));
  flight.fly(1);
  flight.commands.vz[0] = 0.1F;  // ramps up within one tick: half a tick of it is lost
  flight.fly(static_cast<int>(std::lround(distance / 0.001)));
  flight.commands.vz[0] = 0.0F;
  flight.fly(5);
  static_cast<void>(flight.hal.put_back(0));
  flight.fly(1);
  EXPECT_EQ(flight.hal.is_twin(0), flight.hal.report(0).outcome != TwinOutcome::kPutBack);
  return flight.hal.report(0);
}

TEST(PutBack, IsRefusedBeyondTheDistanceWithTheNumbers) {
  EXPECT_EQ(back_from(0.049).outcome, TwinOutcome::kPutBack);
  const TwinReport report = back_from(0.051);
  EXPECT_EQ(report.outcome, TwinOutcome::kTooFar);
  EXPECT_NEAR(report.distance, 0.051, 1e-4);
  EXPECT_THAT(describe(report, config_of(1)), HasSubstr("0.051 m from its twin; wanted at most 0.05 m"));
}

TEST(PutBack, IsRefusedWhereTheTwoPassEachOther) {
  Flight flight(1);
  flight.fly(5);
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  flight.commands.vz[0] = 0.2F;
  flight.fly(5);
  ASSERT_TRUE(flight.hal.put_back(0));
  flight.fly(1);
  const TwinReport report = flight.hal.report(0);
  EXPECT_EQ(report.outcome, TwinOutcome::kTooFast);
  EXPECT_NEAR(report.speed, 0.2, 1e-4);
  EXPECT_THAT(describe(report, config_of(1)), HasSubstr("0.2 m/s past its twin; wanted at most 0.1 m/s"));
}

TEST(Requests, ForWhatIsSoAlreadyChangeNothing) {
  Flight flight(2);
  flight.fly(5);
  ASSERT_TRUE(flight.hal.put_back(0));
  flight.fly(1);
  EXPECT_EQ(flight.hal.report(0).outcome, TwinOutcome::kAlready);
  ASSERT_TRUE(flight.hal.take_out(0));
  EXPECT_FALSE(flight.hal.take_out(0)) << "one waits already";
  EXPECT_FALSE(flight.hal.put_back(0));
  flight.commands.vy[0] = 1.0F;
  flight.fly(50);
  const float y = flight.states.y[0];
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  EXPECT_EQ(flight.hal.report(0).outcome, TwinOutcome::kAlready);
  EXPECT_NEAR(flight.states.y[0], y + 0.01F, 1e-5F) << "the twin is not set back to its robot";
}

TEST(Requests, ForARobotThatIsNotThereAreRefused) {
  Flight flight(2);
  EXPECT_FALSE(flight.hal.take_out(2));
  EXPECT_FALSE(flight.hal.put_back(kEveryRobot));
  EXPECT_FALSE(flight.hal.is_twin(2));
  EXPECT_EQ(flight.hal.report(2).outcome, TwinOutcome::kNone);
  TwinHal early(std::make_unique<sim_hal::SimHal>(sim_of(1)), config_of(1));
  EXPECT_FALSE(early.take_out(0));
  EXPECT_FALSE(early.is_twin(0));
  EXPECT_EQ(early.report(0).outcome, TwinOutcome::kNone);
}

TEST(Requests, EndWithTheActivation) {
  Flight flight(2);
  flight.fly(5);
  ASSERT_TRUE(flight.hal.take_out(0));
  flight.fly(1);
  ASSERT_TRUE(flight.hal.take_out(1));
  ASSERT_TRUE(flight.hal.deactivate(flight.now));
  ASSERT_TRUE(flight.hal.activate(flight.now));
  flight.sequence = 0;
  flight.fly(2);
  EXPECT_FALSE(flight.hal.is_twin(0));
  EXPECT_FALSE(flight.hal.is_twin(1));
  EXPECT_EQ(flight.hal.report(1).outcome, TwinOutcome::kNone);
}

// A HAL whose answers a test writes.
class Scripted : public ::testing::Test {
 protected:
  Scripted() : states_(2), commands_(2) {
    auto scripted = std::make_unique<contract::ScriptedHal>(2);
    script_ = scripted.get();
    TwinConfig config = config_of(2);
    config.parked = CommandKind::kLand;
    hal_ = std::make_unique<TwinHal>(std::move(scripted), config);
    EXPECT_TRUE(hal_->configure());
    EXPECT_TRUE(hal_->activate(now_));
  }
  HalResult tick() {
    const HalResult read = hal_->read(now_, states_.columns());
    static_cast<void>(hal_->write(now_, commands_.columns(now_ + 5 * kTick, ++sequence_)));
    now_ += kTick;
    return read;
  }

  static constexpr Time kTick = std::chrono::milliseconds(10);
  contract::ScriptedHal* script_ = nullptr;
  std::unique_ptr<TwinHal> hal_;
  contract::States states_;
  contract::Commands commands_;
  Time now_ = std::chrono::seconds(1);
  std::uint64_t sequence_ = 0;
};

TEST_F(Scripted, ARobotThatWasNeverSeenHasNoTwin) {
  script_->read_result = {HalFault::kRobotSilent};
  ASSERT_TRUE(hal_->take_out(0));
  EXPECT_FALSE(tick().ok());
  EXPECT_EQ(hal_->report(0).outcome, TwinOutcome::kNoPose);
  EXPECT_THAT(describe(hal_->report(0), hal_->config()), HasSubstr("older than 0.1 s"));
  EXPECT_FALSE(hal_->is_twin(0));
}

TEST_F(Scripted, ATwinOutlivesItsRobotAndIsNotTakenForIt) {
  tick();
  ASSERT_TRUE(hal_->take_out(0));
  tick();
  script_->read_result = {HalFault::kLinkDown};
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(tick().fault, HalFault::kLinkDown);
    EXPECT_EQ(states_.valid[0], 1);
    EXPECT_EQ(states_.valid[1], 0);
  }
  EXPECT_GT(states_.x[0], 0.1F);
  ASSERT_TRUE(hal_->put_back(0));
  tick();
  EXPECT_EQ(hal_->report(0).outcome, TwinOutcome::kNoPose);
  EXPECT_TRUE(hal_->is_twin(0));
}

TEST_F(Scripted, TheRobotIsToldToLandAndOthersWhatTheyAreTold) {
  tick();
  ASSERT_TRUE(hal_->take_out(0));
  tick();
  EXPECT_EQ(script_->last_kinds[0], CommandKind::kLand);
  EXPECT_EQ(script_->last_kinds[1], CommandKind::kVelocity);
}

TEST_F(Scripted, ATwinHasNoBatteryAndIsAlwaysHeard) {
  std::vector<Telemetry> telemetry(2, Telemetry{Time{3}, 0.1F, 0.2F, false});
  tick();
  ASSERT_TRUE(hal_->take_out(0));
  StateColumns columns = states_.columns();
  columns.telemetry = telemetry;
  static_cast<void>(hal_->read(now_, columns));
  EXPECT_EQ(telemetry[0].heard, now_);
  EXPECT_TRUE(std::isnan(telemetry[0].battery));
  EXPECT_TRUE(telemetry[0].airborne);
  EXPECT_EQ(telemetry[1].battery, 0.1F);
}

TEST_F(Scripted, WhoWasNeverCommandedKeepsItsOwnVelocity) {
  states_.vx[0] = 0.7F;
  ASSERT_TRUE(hal_->take_out(0));
  ASSERT_TRUE(hal_->read(now_, states_.columns()).ok());
  EXPECT_FLOAT_EQ(states_.vx[0], 0.7F);
  ASSERT_TRUE(hal_->read(now_ + kTick, states_.columns()).ok());
  EXPECT_NEAR(states_.vx[0], 0.6F, 1e-6F) << "and brakes";
}

// Fails without a word once it is told to, and leaves the columns as they are.
class Mute final : public Hal {
 public:
  std::span<const RobotInfo> robots() const noexcept override { return {&info_, 1}; }
  std::string_view name() const noexcept override { return "mute"; }
  bool fails = false;

 private:
  Result<void> do_configure() override { return {}; }
  Result<void> do_activate(Time) override { return {}; }
  HalResult do_read(Time now, const StateColumns& states) noexcept override {
    if (fails) {
      return {HalFault::kLinkDown};
    }
    states.stamp[0] = now;
    states.valid[0] = 1;
    return {};
  }
  HalResult do_write(Time, const CommandColumns&) noexcept override { return {}; }
  Result<void> do_deactivate(Time) override { return {}; }
  RobotInfo info_{"mute", "wire"};
};

TEST(MuteHal, DoesNotHandATwinBackAsItsRobot) {
  auto mute = std::make_unique<Mute>();
  Mute* real = mute.get();
  TwinHal hal(std::move(mute), config_of(1));
  ASSERT_TRUE(hal.configure());
  ASSERT_TRUE(hal.activate(Time{0}));
  contract::States states(1);
  ASSERT_TRUE(hal.take_out(0));
  ASSERT_TRUE(hal.read(Time{0}, states.columns()).ok());
  real->fails = true;
  for (Time now{0}; now <= std::chrono::milliseconds(200); now += std::chrono::milliseconds(10)) {
    EXPECT_FALSE(hal.read(now, states.columns()).ok());
  }
  ASSERT_TRUE(hal.put_back(0));
  EXPECT_FALSE(hal.read(std::chrono::milliseconds(210), states.columns()).ok());
  EXPECT_EQ(hal.report(0).outcome, TwinOutcome::kNoPose);
}

TEST_F(Scripted, NothingIsAllocatedInFlight) {
  tick();
  const std::uint64_t before = allocation_count();
  for (int i = 0; i < 100; ++i) {
    static_cast<void>(i % 2 == 0 ? hal_->take_out(0) : hal_->put_back(0));
    tick();
  }
  EXPECT_EQ(allocation_count(), before);
}

// The estimator behind it sees neither jump nor swap.
TEST(Estimated, NoGateCloses) {
  Flight flight(2);
  EstimatorConfig config;
  config.period = Flight::kTick;
  config.robots.assign(2, {kSpeed, kAcceleration});
  auto made = Estimator::create(config);
  Estimator& estimator = made.value();
  for (int i = 0; i < 300; ++i) {
    flight.commands.vy[0] = i < 100 ? 1.0F : 0.0F;
    if (i == 50) {
      ASSERT_TRUE(flight.hal.take_out(0));
    }
    ASSERT_TRUE(flight.hal.read(flight.now, estimator.inbox()).ok());
    estimator.update(flight.now);
    for (const Symptoms& symptoms : estimator.estimate().symptoms) {
      ASSERT_TRUE(symptoms.empty()) << i;
    }
    const CommandColumns sent = flight.commands.columns(flight.now + 5 * Flight::kTick, ++flight.sequence);
    ASSERT_TRUE(flight.hal.write(flight.now, sent).ok());
    estimator.sent(flight.now, sent);
    flight.now += Flight::kTick;
  }
  EXPECT_TRUE(flight.hal.is_twin(0));
}

struct Wrong {
  std::string what, found;
  void (*spoil)(TwinConfig&);
};
void PrintTo(const Wrong& wrong, std::ostream* stream) {
  *stream << wrong.what;
}
class WrongTwins : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongTwins, AreRefusedWithTheirNumbers) {
  TwinConfig config = config_of(2);
  GetParam().spoil(config);
  TwinHal hal(std::make_unique<sim_hal::SimHal>(sim_of(2)), config);
  const auto done = hal.configure();
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr(GetParam().what));
  EXPECT_THAT(done.error().found, HasSubstr(GetParam().found));
}
INSTANTIATE_TEST_SUITE_P(
    Twins, WrongTwins,
    ::testing::Values(
        Wrong{"limits of robot 1", "0 m/s", [](TwinConfig& c) { c.robots[1].speed = 0.0F; }},
        Wrong{"limits of robot 0", "inf m/s²",
              [](TwinConfig& c) { c.robots[0].acceleration = std::numeric_limits<float>::infinity(); }},
        Wrong{"limits of robot 1", "-1 s", [](TwinConfig& c) { c.robots[1].response_time = -1.0F; }},
        Wrong{"put back", "-1 m,", [](TwinConfig& c) { c.most_distance = -1.0F; }},
        Wrong{"put back", "nan m/s", [](TwinConfig& c) { c.most_speed = std::nanf(""); }},
        Wrong{"put back", "0 ns", [](TwinConfig& c) { c.most_age = Time{0}; }},
        Wrong{"while its twin flies", "command 5", [](TwinConfig& c) { c.parked = CommandKind::kStop; }},
        Wrong{"limits", "1 robots", [](TwinConfig& c) { c.robots.resize(1); }}));

TEST(WrongTwins, ARealHalThatFailsIsPassedOnAndTriedAgain) {
  auto scripted = std::make_unique<contract::ScriptedHal>(1);
  contract::ScriptedHal* script = scripted.get();
  script->configure_fails = script->activate_fails = true;
  TwinHal hal(std::move(scripted), config_of(1));
  EXPECT_FALSE(hal.configure());
  script->configure_fails = false;
  EXPECT_TRUE(hal.configure());
  EXPECT_FALSE(hal.activate(Time{0}));
  script->activate_fails = false;
  EXPECT_TRUE(hal.activate(Time{0}));
}

TEST(Describe, EveryOutcome) {
  const TwinConfig config = config_of(1);
  EXPECT_EQ(describe({}, config), "nothing was asked of it");
  EXPECT_EQ(describe({TwinOutcome::kPending}, config), "waits for the next tick");
  EXPECT_EQ(describe({TwinOutcome::kTakenOut}, config), "taken out: its twin flies");
  EXPECT_EQ(describe({TwinOutcome::kPutBack, 0.01F}, config), "put back, 0.01 m from where its twin was");
  EXPECT_EQ(describe({TwinOutcome::kAlready}, config), "is so already");
}

}  // namespace
}  // namespace mayfly
