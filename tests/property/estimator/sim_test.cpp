// The estimator behind the simulated HAL: perfect poses go through as they are, and every alarm has its
// fault.
#include <gtest/gtest.h>

#include <random>

#include "controller/estimator/estimator.hpp"
#include "sim_hal/sim_hal.hpp"

namespace mayfly::estimator_test {
namespace {

constexpr std::size_t kRobots = 12;
constexpr Time kPeriod = std::chrono::milliseconds(10);

using sim_hal::Plant;

sim_hal::SimHalConfig sim_of(Plant plant) {
  sim_hal::SimHalConfig config;
  config.plant = plant;
  config.backend = sim_hal::Backend::kNative;
  config.max_speed = {3.0F};
  config.max_acceleration = {20.0F};
  for (std::size_t r = 0; r < kRobots; ++r) {
    config.robot_names.push_back("fly" + std::to_string(r));
    config.positions.emplace_back(2.0F * static_cast<float>(r), 0.0F, 10.0F);
  }
  return config;
}

// Robots that are told something new each tenth of a second, to stand at times, faster than they can at
// others.
class Flight {
 public:
  Flight(sim_hal::SimHalConfig sim, unsigned seed) : noise_(sim.faults.pose_noise), hal_(sim), random_(seed) {
    EstimatorConfig config;
    config.period = kPeriod;
    config.most_age = 5 * kPeriod;
    config.sources[0].pose_noise = noise_;
    // An ideal plant turns within a step: nothing limits its acceleration but its speed.
    const float acceleration = sim.plant == Plant::kIdeal ? 600.0F : 20.0F;
    const float lag = sim.plant == Plant::kVelocityLag ? sim.time_constant : 0.0F;
    config.robots.assign(kRobots, {3.0F, acceleration, lag});
    auto made = Estimator::create(config);
    estimator_.emplace(std::move(made.value()));
    EXPECT_TRUE(hal_.configure());
    EXPECT_TRUE(hal_.activate(now_));
  }

  // Returns what is in the inbox before the update.
  StateColumns tick() {
    const StateColumns in = estimator_->inbox();
    EXPECT_TRUE(hal_.read(now_, in).ok());
    estimator_->update(now_);
    if (ticks_++ % 10 == 0) {
      std::uniform_real_distribution<float> speed(-4.0F, 4.0F);
      for (std::size_t r = 0; r < kRobots; ++r) {
        kind_[r] = random_() % 4 == 0 ? CommandKind::kHold : CommandKind::kVelocity;
        vx_[r] = speed(random_), vy_[r] = speed(random_), vz_[r] = random_() % 3 == 0 ? 0.0F : speed(random_);
      }
    }
    const CommandColumns commands{kind_, vx_, vy_, vz_, now_ + 5 * kPeriod, ticks_};
    EXPECT_TRUE(hal_.write(now_, commands).ok());
    estimator_->sent(now_, commands);
    now_ += kPeriod;
    return in;
  }
  EstimateColumns estimate() const { return estimator_->estimate(); }
  sim_hal::PoseView truth() { return hal_.truth(); }
  std::uint64_t count(SampleFate fate) const { return estimator_->counters().of(fate); }

 private:
  float noise_;
  sim_hal::SimHal hal_;
  std::mt19937 random_;
  std::optional<Estimator> estimator_;
  Time now_{0};
  std::uint64_t ticks_ = 0;
  std::vector<CommandKind> kind_ = std::vector<CommandKind>(kRobots);
  std::vector<float> vx_ = std::vector<float>(kRobots), vy_ = vx_, vz_ = vx_;
};

class Simulated : public ::testing::TestWithParam<Plant> {};

TEST_P(Simulated, PerfectPosesGoThroughBitForBitAndRaiseNoAlarm) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Flight flight(sim_of(GetParam()), seed);
    for (int tick = 0; tick < 1000; ++tick) {
      const StateColumns in = flight.tick();
      const EstimateColumns out = flight.estimate();
      for (std::size_t r = 0; r < kRobots; ++r) {
        ASSERT_TRUE(out.symptoms[r].empty()) << "seed " << seed << ", tick " << tick << ", robot " << r;
        ASSERT_TRUE(out.known[r] != 0 && out.x[r] == in.x[r] && out.y[r] == in.y[r] && out.z[r] == in.z[r] &&
                    out.vx[r] == in.vx[r] && out.vy[r] == in.vy[r] && out.vz[r] == in.vz[r]);
      }
      ASSERT_TRUE(out.everybody.empty());
    }
  }
}

TEST_P(Simulated, NoiseAndLossesRaiseNoAlarmEither) {
  sim_hal::SimHalConfig sim = sim_of(GetParam());
  sim.faults.pose_noise = 0.005F;
  sim.faults.dropout = 0.05F;
  double squares = 0.0;
  Flight flight(sim, 1);
  for (int tick = 0; tick < 3000; ++tick) {
    flight.tick();
    const EstimateColumns out = flight.estimate();
    const sim_hal::PoseView truth = flight.truth();
    for (std::size_t r = 0; r < kRobots && tick > 10; ++r) {
      ASSERT_TRUE(out.symptoms[r].empty()) << "tick " << tick << ", robot " << r;
      squares += std::pow(static_cast<double>(out.x[r] - truth.columns[0][r]), 2);
    }
  }
  // Where velocities are measured without noise and turns take time, better than a sample by more than half.
  EXPECT_LT(std::sqrt(squares / (2989.0 * static_cast<double>(kRobots))),
            GetParam() == Plant::kIdeal ? 0.006 : 0.0025);
}

TEST_P(Simulated, FreezesAndNonsenseAreTold) {
  sim_hal::SimHalConfig sim = sim_of(GetParam());
  sim.faults.freeze = 0.3F;
  sim.faults.freeze_time = 0.4F;
  sim.faults.nan = 0.01F;
  Flight flight(sim, 2);
  int frozen = 0;
  int wrong = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    const StateColumns in = flight.tick();
    const EstimateColumns out = flight.estimate();
    const sim_hal::PoseView truth = flight.truth();
    for (std::size_t r = 0; r < kRobots; ++r) {
      const bool is_nan = std::isnan(in.x[r]);
      ASSERT_EQ(out.symptoms[r].has(Symptom::kPoseNotFinite), is_nan);
      frozen += out.symptoms[r].has(Symptom::kFrozenPose) ? 1 : 0;
      // Once it is told, the sample is no longer the truth; else the alarm is false.
      wrong += out.symptoms[r].has(Symptom::kFrozenPose) && in.x[r] == truth.columns[0][r] &&
                       in.y[r] == truth.columns[1][r]
                   ? 1
                   : 0;
      ASSERT_TRUE(out.known[r] == 0 || std::isfinite(out.x[r]));
    }
  }
  EXPECT_GT(frozen, 500);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(flight.count(SampleFate::kNotFinite), 200U);
}

INSTANTIATE_TEST_SUITE_P(Plants, Simulated,
                         ::testing::Values(Plant::kIdeal, Plant::kVelocityLag, Plant::kDoubleIntegrator));

}  // namespace
}  // namespace mayfly::estimator_test
