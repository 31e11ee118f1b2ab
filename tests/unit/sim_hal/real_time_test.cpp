// The plants' own thread, on a clock that only goes on when the test says so: no test here waits for real
// time.
#include <condition_variable>
#include <mutex>

#include "tests/unit/sim_hal/flight.hpp"

namespace mayfly::sim_hal {
namespace {

constexpr Time kStart = std::chrono::seconds(5);
constexpr Time kPeriod = std::chrono::milliseconds(5);  // of plants at 200 Hz, and of their thread

class HandClock final : public Clock {
 public:
  Time now() const noexcept override {
    const std::lock_guard lock(mutex_);
    return now_;
  }
  void sleep_until(Time deadline) noexcept override {
    std::unique_lock lock(mutex_);
    asleep_ = true;
    deadline_ = deadline;
    changed_.notify_all();
    changed_.wait(lock, [this] { return now_ >= deadline_ || released_; });
    asleep_ = false;
  }
  bool is_virtual() const noexcept override { return true; }

  // Goes on to `time` and returns when the thread has done what there was to do and sleeps again.
  void go_to(Time time) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return asleep_; });
    now_ = time;
    changed_.notify_all();
    changed_.wait(lock, [this] { return asleep_ && deadline_ > now_; });
  }
  // While released, nobody sleeps: so that the thread can end.
  void release(bool released) {
    const std::lock_guard lock(mutex_);
    released_ = released;
    changed_.notify_all();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Time now_ = kStart;
  Time deadline_{0};
  bool asleep_ = false;
  bool released_ = false;
};

class RealTime : public ::testing::Test {
 protected:
  void start(Plant plant, double rate_hz = 200.0) {
    SimHalConfig config = row_of(2, plant);
    config.rate_hz = rate_hz;
    config.lock_step = false;
    config.clock = &clock_;
    hal_ = std::make_unique<SimHal>(config);
    ASSERT_TRUE(hal_->configure().has_value());
    ASSERT_TRUE(hal_->activate(kStart).has_value());
  }
  void TearDown() override {
    clock_.release(true);
    hal_.reset();
  }
  void stop() {
    clock_.release(true);
    ASSERT_TRUE(hal_->deactivate(clock_.now()).has_value());
    clock_.release(false);
  }
  void read() { ASSERT_TRUE(hal_->read(clock_.now(), states_.columns()).ok()); }
  void write(Time deadline, std::uint64_t sequence) {
    ASSERT_TRUE(hal_->write(clock_.now(), commands_.columns(deadline, sequence)).ok());
  }

  HandClock clock_;
  std::unique_ptr<SimHal> hal_;
  contract::States states_{2};
  contract::Commands commands_{2};
};

TEST_F(RealTime, ThereIsAStateFromTheStart) {
  start(Plant::kIdeal);
  read();
  EXPECT_EQ(states_.valid[1], 1);
  EXPECT_EQ(states_.x[1], 1.0F);
  EXPECT_EQ(states_.stamp[1], kStart);
}

TEST_F(RealTime, RobotsObeyUntilTheDeadlineThoughNobodyCalls) {
  start(Plant::kIdeal);
  write(kStart + std::chrono::milliseconds(105), 1);
  clock_.go_to(kStart + kPeriod);  // the thread has the command from here on
  clock_.go_to(kStart + std::chrono::milliseconds(55));
  read();
  EXPECT_EQ(states_.stamp[0], kStart + std::chrono::milliseconds(55));
  EXPECT_NEAR(states_.x[0], 0.05F, 1e-6F);
  EXPECT_EQ(states_.vx[0], 1.0F);
  clock_.go_to(kStart + std::chrono::seconds(2));
  read();
  EXPECT_NEAR(states_.x[0], 0.1F, 1e-6F);
  EXPECT_EQ(states_.vx[0], 0.0F);
}

TEST_F(RealTime, TheNewestCommandWins) {
  start(Plant::kIdeal);
  for (std::uint64_t sequence = 1; sequence <= 5; ++sequence) {
    commands_.vx[0] = static_cast<float>(sequence) / 2.0F;
    write(kStart + std::chrono::seconds(1), sequence);
  }
  clock_.go_to(kStart + kPeriod);
  clock_.go_to(kStart + 2 * kPeriod);
  read();
  EXPECT_EQ(states_.vx[0], 2.5F);
}

TEST_F(RealTime, AThreadThatIsLateSkipsTurnsAndLosesNoStep) {
  start(Plant::kIdeal);
  write(kStart + std::chrono::hours(1), 1);
  clock_.go_to(kStart + kPeriod);
  clock_.go_to(kStart + kPeriod + std::chrono::seconds(1));
  read();
  EXPECT_NEAR(states_.x[0], 1.0F, 1e-4F);
}

TEST_F(RealTime, FastPlantsAreSteppedSeveralAtATime) {
  start(Plant::kIdeal, 1000.0);
  write(kStart + std::chrono::hours(1), 1);
  clock_.go_to(kStart + std::chrono::milliseconds(1));  // too early for a turn
  read();
  EXPECT_EQ(states_.stamp[0], kStart);
  clock_.go_to(kStart + std::chrono::milliseconds(2));
  clock_.go_to(kStart + std::chrono::milliseconds(5));
  read();
  EXPECT_EQ(states_.stamp[0], kStart + std::chrono::milliseconds(5));
  EXPECT_NEAR(states_.x[0], 0.003F, 1e-6F);
}

TEST_F(RealTime, ANewActivationDoesNotObeyAnOldCommand) {
  start(Plant::kIdeal);
  clock_.go_to(kStart + kPeriod);
  write(kStart + std::chrono::hours(1), 1);  // the thread ends before or after it has looked at this
  stop();
  ASSERT_TRUE(hal_->activate(clock_.now()).has_value());
  clock_.go_to(clock_.now() + kPeriod);
  read();
  const float x = states_.x[0];
  clock_.go_to(clock_.now() + std::chrono::seconds(1));
  read();
  EXPECT_EQ(states_.x[0], x);
  EXPECT_EQ(states_.vx[0], 0.0F);
}

TEST_F(RealTime, EndsWhileRobotsFly) {
  start(Plant::kVelocityLag);
  write(kStart + std::chrono::hours(1), 1);
  clock_.go_to(kStart + kPeriod);
  stop();
  EXPECT_TRUE(hal_->deactivate(clock_.now()).has_value());
  EXPECT_EQ(hal_->read(clock_.now(), states_.columns()).fault, HalFault::kWrongState);
}

TEST_F(RealTime, TellsNoTruth) {
  start(Plant::kIdeal);
  EXPECT_TRUE(hal_->truth().columns[0].empty());
}

}  // namespace
}  // namespace mayfly::sim_hal
