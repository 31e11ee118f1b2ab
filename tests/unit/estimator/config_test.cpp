#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

using ::testing::HasSubstr;

TEST(Config, FillsInWhatIsLeftOpen) {
  EstimatorConfig config;
  config.period = kPeriod;
  config.pose_period = 2 * kPeriod;
  ASSERT_TRUE(check_and_fill(config));
  EXPECT_EQ(config.most_age, 7 * kPeriod);
  EXPECT_EQ(config.most_ahead, kPeriod);
  config.pose_period = config.most_age = Time{0};
  ASSERT_TRUE(check_and_fill(config));
  EXPECT_EQ(config.pose_period, kPeriod);
  EXPECT_EQ(config.most_age, 4 * kPeriod);
}

TEST(Config, KeepsWhatWasSaid) {
  EstimatorConfig config = config_of(2);
  config.most_ahead = Time(5);
  ASSERT_TRUE(check_and_fill(config));
  EXPECT_EQ(config.most_age, 5 * kPeriod);
  EXPECT_EQ(config.most_ahead, Time(5));
}

TEST(Config, NobodyIsNobody) {
  Rig rig(config_of(0));
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().x.empty());
  EXPECT_EQ(rig.estimator.robots(), 0U);
}

struct Wrong {
  std::string what;
  std::function<void(EstimatorConfig&)> spoil;
  std::string message, found;
};

void PrintTo(const Wrong& wrong, std::ostream* stream) {
  *stream << wrong.what;
}

class WrongConfig : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongConfig, IsRefusedWithItsNumbers) {
  EstimatorConfig config = config_of(2);
  GetParam().spoil(config);
  const auto made = Estimator::create(config);
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().cause, Cause::kCaller);
  EXPECT_THAT(made.error().message, HasSubstr(GetParam().message));
  EXPECT_THAT(made.error().found, HasSubstr(GetParam().found));
  EXPECT_FALSE(made.error().wanted.empty());
}

const float kNaN = std::numeric_limits<float>::quiet_NaN();
const float kInfinity = std::numeric_limits<float>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Estimator, WrongConfig,
    ::testing::Values(
        Wrong{"no period", [](EstimatorConfig& c) { c.period = Time{0}; }, "period", "0 ns"},
        Wrong{"negative age", [](EstimatorConfig& c) { c.most_age = Time(-4); }, "age limit", "-4"},
        Wrong{"negative pose period", [](EstimatorConfig& c) { c.pose_period = Time(-5); }, "pose period",
              "-5"},
        Wrong{"negative ahead", [](EstimatorConfig& c) { c.most_ahead = Time(-6); }, "limit ahead", "-6"},
        Wrong{"one frozen sample", [](EstimatorConfig& c) { c.frozen_samples = 1; }, "equal samples", "1"},
        Wrong{"no source", [](EstimatorConfig& c) { c.sources.clear(); }, "sources", "0"},
        Wrong{"many sources", [](EstimatorConfig& c) { c.sources.resize(5); }, "sources", "5"},
        Wrong{"no poses", [](EstimatorConfig& c) { c.sources[0].takes_pose = false; }, "sources", "none"},
        Wrong{"negative noise", [](EstimatorConfig& c) { c.sources[0].pose_noise = -0.5F; }, "'hal'", "-0.5"},
        Wrong{"noise NaN", [](EstimatorConfig& c) { c.sources[0].velocity_noise = kNaN; }, "'hal'", "nan"},
        Wrong{"resolution", [](EstimatorConfig& c) { c.sources[0].resolution = kInfinity; }, "'hal'", "inf"},
        Wrong{"speed", [](EstimatorConfig& c) { c.robots[1].speed = 0.0F; }, "speed of robot 1", "0"},
        Wrong{"speed NaN", [](EstimatorConfig& c) { c.robots[0].speed = kNaN; }, "speed of robot 0", "nan"},
        Wrong{"acceleration", [](EstimatorConfig& c) { c.robots[1].acceleration = kInfinity; },
              "acceleration of robot 1", "inf"},
        Wrong{"no acceleration", [](EstimatorConfig& c) { c.robots[1].acceleration = 0.0F; },
              "acceleration of robot 1", "0"},
        Wrong{"response", [](EstimatorConfig& c) { c.robots[1].response_time = -1.0F; },
              "response time of robot 1", "-1"}));

}  // namespace
}  // namespace mayfly::estimator_test
