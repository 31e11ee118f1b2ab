// The filter against the textbook's, and samples that come late or from several sources.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <random>

#include "tests/reference/kalman_reference.hpp"
#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

using reference::KalmanReference;
using reference::Matrix;

struct Shot {
  Time stamp;
  Vec place, velocity;
};

// A robot on a winding path, measured with noise at uneven times.
std::vector<Shot> shots(unsigned seed, int count, double noise) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> gap(2'000'000, 18'000'000);
  std::vector<Shot> all;
  Time stamp = std::chrono::seconds(1);
  for (int i = 0; i < count; ++i) {
    stamp += Time(gap(random));
    const double t = to_seconds(stamp);
    const auto rounded = [](double value) { return static_cast<double>(static_cast<float>(value)); };
    all.push_back(
        {stamp,
         {rounded(std::sin(t) + noise * normal(random)), rounded(std::cos(2 * t) + noise * normal(random)),
          rounded(2.0 + 0.1 * t + noise * normal(random))},
         {rounded(std::cos(t) + noise * normal(random)), rounded(-2 * std::sin(2 * t)), rounded(0.1)}});
  }
  return all;
}

Matrix column(const Vec& a) {
  Matrix m(3, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    m(i, 0) = a[i];
  }
  return m;
}

Matrix scaled(double factor) {
  Matrix m(3, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    m(i, i) = factor;
  }
  return m;
}

// Picks three states from `first` on.
Matrix picks(std::size_t first) {
  Matrix m(3, 6);
  for (std::size_t i = 0; i < 3; ++i) {
    m(i, first + i) = 1.0;
  }
  return m;
}

class Filter : public ::testing::TestWithParam<bool> {};

TEST_P(Filter, IsTheTextbooks) {
  const bool takes_velocity = GetParam();
  const float noise = 0.02F;
  const float velocity_noise = 0.05F;
  EstimatorConfig config = config_of(1, noise);
  config.sources[0].takes_velocity = takes_velocity;
  config.sources[0].velocity_noise = velocity_noise;
  Rig rig(config);
  const double r = std::pow(static_cast<double>(noise), 2);
  const double rv = std::pow(static_cast<double>(velocity_noise), 2);
  const double density = 20.0 * 20.0 * 0.01 / 3.0;
  KalmanReference textbook;
  Time before{0};
  for (const Shot& shot : shots(7, 300, 0.02)) {
    rig.put_at(0, shot.place, shot.velocity, shot.stamp);
    rig.now = shot.stamp + Time(3'000'000);
    rig.estimator.update(rig.now);
    if (before == Time{0}) {
      textbook.begin(shot.place, r, takes_velocity ? shot.velocity : Vec{}, takes_velocity ? rv : 9.0);
    } else {
      textbook.predict(to_seconds(shot.stamp - before), density);
      textbook.correct(picks(0), column(shot.place), scaled(r));
      if (takes_velocity) {
        textbook.correct(picks(3), column(shot.velocity), scaled(rv));
      }
    }
    before = shot.stamp;
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_NEAR(rig.velocity(0)[i], textbook.x(i + 3, 0), 1e-6);
      ASSERT_NEAR(rig.place(0)[i], textbook.x(i, 0) + 0.003 * textbook.x(i + 3, 0), 1e-6);
    }
    const Uncertainty sure = rig.estimator.uncertainty(0);
    ASSERT_NEAR(sure.position, std::sqrt(textbook.p(0, 0)), 1e-9);
    ASSERT_NEAR(sure.velocity, std::sqrt(textbook.p(4, 4)), 1e-9);
    ASSERT_NEAR(sure.covariance, textbook.p(2, 5), 1e-9);
  }
  EXPECT_EQ(rig.count(SampleFate::kTaken), 300U);
}
INSTANTIATE_TEST_SUITE_P(WithVelocity, Filter, ::testing::Bool());

TEST(PerfectPoses, AreTheEstimateBitForBit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> step(-0.02F, 0.02F);
  Rig rig(config_of(1));
  float x = 3.1F, y = -0.0F, z = 700.0F;
  for (int i = 0; i < 500; ++i) {
    const StateColumns in = rig.estimator.inbox();
    in.x[0] = x, in.y[0] = y, in.z[0] = z;
    in.vx[0] = step(random), in.vy[0] = -0.0F, in.vz[0] = 1e-20F;
    in.stamp[0] = rig.now;
    in.valid[0] = 1;
    rig.tick();
    const EstimateColumns out = rig.estimator.estimate();
    ASSERT_EQ(std::bit_cast<std::uint32_t>(out.x[0]), std::bit_cast<std::uint32_t>(x));
    ASSERT_EQ(std::bit_cast<std::uint32_t>(out.y[0]), std::bit_cast<std::uint32_t>(y));
    ASSERT_EQ(std::bit_cast<std::uint32_t>(out.z[0]), std::bit_cast<std::uint32_t>(z));
    ASSERT_EQ(out.vx[0], in.vx[0]);
    ASSERT_EQ(std::bit_cast<std::uint32_t>(out.vy[0]), std::bit_cast<std::uint32_t>(-0.0F));
    ASSERT_EQ(out.vz[0], in.vz[0]);
    ASSERT_EQ(out.fresh[0], 1);
    ASSERT_TRUE(out.symptoms[0].empty());
    x += step(random), z += step(random);
  }
}

TEST(PerfectPoses, WithDerivedVelocitiesKeepThePlaceExact) {
  EstimatorConfig config = config_of(1);
  config.sources[0].takes_velocity = false;
  Rig rig(config);
  for (int i = 0; i < 200; ++i) {
    rig.put(0, {0.01 * i, 0.0, 1.0});
    rig.tick();
    ASSERT_EQ(rig.place(0)[0], static_cast<double>(static_cast<float>(0.01 * i)));
  }
  EXPECT_NEAR(rig.velocity(0)[0], 1.0, 1e-4);
}

// Along x, of a robot that is told to fly at 1 m/s and does so at `speed`.
float drift_at(double speed, int ticks) {
  Rig rig(config_of(1));
  rig.tell(0, {1.0, 0.0, 0.0});
  for (int i = 0; i < ticks; ++i) {
    rig.put(0, {0.01 * speed * i, 0.0, 0.0}, {speed, 0.0, 0.0});
    rig.tick();
  }
  EXPECT_EQ(rig.estimator.estimate().drift_y[0], 0.0F);
  return rig.estimator.estimate().drift_x[0];
}

TEST(Drift, IsWhatItFliesBesideWhatItIsTold) {
  EXPECT_NEAR(drift_at(1.0, 200), 0.0F, 1e-3F);
  EXPECT_NEAR(drift_at(1.5, 200), 0.5F, 1e-3F);
  EXPECT_NEAR(drift_at(0.3, 200), -0.7F, 1e-3F);
}

TEST(Drift, OfOneThatNobodySeesIsNotKnown) {
  Rig rig(config_of(1));
  for (int i = 0; i < 100; ++i) {
    rig.put(0, {0.005 * i, 0.0, 0.0}, {0.5, 0.0, 0.0});
    rig.tick();
  }
  EXPECT_NEAR(rig.estimator.estimate().drift_x[0], 0.5F, 1e-3F);
  rig.lose(0);
  for (int i = 0; i < 10; ++i) {
    rig.tick();
  }
  EXPECT_EQ(rig.estimator.estimate().drift_x[0], 0.0F);
}

TEST(Prediction, GoesOnWithTheLastVelocityTillTheTick) {
  Rig rig(config_of(1));
  rig.put_at(0, {1.0, 2.0, 3.0}, {1.0, -2.0, 0.5}, rig.now - Time(4'000'000));
  rig.tick();
  EXPECT_NEAR(rig.place(0)[0], 1.004, 1e-6);
  EXPECT_NEAR(rig.place(0)[1], 1.992, 1e-6);
  rig.lose(0);
  rig.tick();
  EXPECT_NEAR(rig.place(0)[0], 1.014, 1e-6);
  EXPECT_EQ(rig.estimator.estimate().fresh[0], 0);
  EXPECT_TRUE(rig.known(0));
}

// What was sent in order and what came in disorder end in the same bits.
TEST(LateSamples, GoInWhereTheyBelong) {
  const std::vector<Shot> all = shots(5, 200, 0.01);
  EstimatorConfig config = config_of(1, 0.01F);
  config.most_age = std::chrono::seconds(1);
  Rig ordered(config);
  Rig disordered(config);
  std::mt19937 random(1);
  for (std::size_t first = 0; first < all.size(); first += 5) {
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    if (first > 0) {
      std::shuffle(order.begin(), order.end(), random);
    }
    for (std::size_t i = 0; i < 5; ++i) {
      const Shot& a = all[first + i];
      const Shot& b = all[first + order[i]];
      ordered.put_at(0, a.place, a.velocity, a.stamp);
      disordered.put_at(0, b.place, b.velocity, b.stamp);
      const Time now = all[first + 4].stamp;
      ordered.estimator.update(now);
      disordered.estimator.update(now);
    }
    ASSERT_EQ(ordered.place(0), disordered.place(0));
    ASSERT_EQ(ordered.velocity(0), disordered.velocity(0));
  }
  EXPECT_GT(disordered.count(SampleFate::kTakenLate), 50U);
  EXPECT_EQ(disordered.count(SampleFate::kTaken) + disordered.count(SampleFate::kTakenLate), 200U);
  EXPECT_EQ(ordered.count(SampleFate::kTakenLate), 0U);
}

TEST(LateSamples, OlderThanAllThatIsRememberedAreCounted) {
  EstimatorConfig config = config_of(1, 0.01F);
  config.most_age = std::chrono::seconds(10);
  Rig rig(config);
  const Time start = rig.now;
  for (int i = 0; i < 40; ++i) {
    rig.put(0, {0.0, 0.0, 1.0});
    rig.tick();
  }
  rig.put_at(0, {0.0, 0.0, 1.0}, {}, start + kPeriod / 2);
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTooOld), 1U);
  rig.put_at(0, {0.0, 0.0, 1.0}, {}, rig.now - 10 * kPeriod - kPeriod / 2);
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTakenLate), 1U);
}

TEST(LateSamples, BeforeTheFirstThereIsNothing) {
  Rig rig(config_of(1, 0.01F));
  rig.put(0, {0.0, 0.0, 1.0});
  rig.tick();
  rig.put_at(0, {0.0, 0.0, 1.0}, {}, rig.now - 2 * kPeriod);
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTooOld), 1U);
}

// Odometry without delay, and poses that come two ticks late: none is lost, and the two make the estimate
// better than either.
class TwoSources : public ::testing::Test {
 protected:
  static EstimatorConfig config() {
    EstimatorConfig config = config_of(1, 0.01F);
    config.sources[0].name = "motion capture";
    EstimatorSource wheels;
    wheels.name = "wheels";
    wheels.takes_pose = false;
    wheels.velocity_noise = 0.02F;
    config.sources.push_back(wheels);
    return config;
  }
};

TEST_F(TwoSources, AreFusedInTheOrderOfTheirStamps) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  Rig rig(config());
  Rig poses_only(config());
  double error = 0.0, error_without = 0.0;
  const auto place = [](Time t) -> Vec {
    return {std::sin(3.0 * to_seconds(t)), std::cos(3.0 * to_seconds(t)), 1.0};
  };
  for (int i = 0; i < 1000; ++i) {
    const double t = to_seconds(rig.now);
    Vec seen = place(rig.now - 2 * kPeriod);
    Vec speed{3.0 * std::cos(3.0 * t), -3.0 * std::sin(3.0 * t), 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      seen[k] += 0.01 * normal(random);
      speed[k] += 0.02 * normal(random);
    }
    const Vec truth = place(rig.now);
    rig.put_at(0, seen, {}, rig.now - 2 * kPeriod);
    rig.put_at(0, {}, speed, rig.now, 1);
    poses_only.put_at(0, seen, {}, rig.now - 2 * kPeriod);
    rig.tick();
    poses_only.tick();
    error += std::pow(rig.place(0)[0] - truth[0], 2);
    error_without += std::pow(poses_only.place(0)[0] - truth[0], 2);
  }
  EXPECT_EQ(rig.count(SampleFate::kUnplaced), 0U);  // the first pose is the older of the first two samples
  EXPECT_EQ(rig.count(SampleFate::kTakenLate), 999U);
  EXPECT_EQ(rig.count(SampleFate::kTaken), 1001U);
  EXPECT_LT(error, 0.5 * error_without);
}

TEST_F(TwoSources, AnAgeIsThatOfThePose) {
  Rig rig(config());
  rig.put(0, {0.0, 0.0, 1.0});
  for (int i = 0; i < 6; ++i) {
    rig.put_at(0, {}, {0.1, 0.0, 0.0}, rig.now, 1);
    rig.tick();
    EXPECT_TRUE(rig.known(0));
    EXPECT_FALSE(rig.has(0, Symptom::kStalePose));
  }
  rig.put_at(0, {}, {0.1, 0.0, 0.0}, rig.now, 1);
  rig.tick();
  EXPECT_FALSE(rig.known(0));
  EXPECT_TRUE(rig.has(0, Symptom::kStalePose));
}

TEST_F(TwoSources, AVelocityAloneIsNoPlace) {
  Rig rig(config());
  rig.put_at(0, {}, {0.1, 0.0, 0.0}, rig.now, 1);
  rig.tick();
  EXPECT_FALSE(rig.known(0));
  EXPECT_TRUE(std::isnan(rig.estimator.estimate().x[0]));
  EXPECT_EQ(rig.count(SampleFate::kUnplaced), 1U);
}

TEST_F(TwoSources, AVelocityThatIsNoneIsRefused) {
  Rig rig(config());
  rig.put(0, {0.0, 0.0, 1.0});
  rig.put_at(0, {}, {4.4, 0.0, 0.0}, rig.now, 1);
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTooFast), 0U);
  rig.put(0, {0.03, 0.0, 1.0});
  rig.put_at(0, {}, {4.7, 0.0, 0.0}, rig.now, 1);  // 1.5 × 3 m/s and three deviations
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTooFast), 1U);
}

TEST(Velocities, OfAPoseCanBeRefusedWithoutThePose) {
  EstimatorConfig config = config_of(1, 0.01F);
  config.sources[0].takes_velocity = true;
  config.sources[0].velocity_noise = 0.1F;
  Rig rig(config);
  rig.put(0, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.0});
  rig.tick();
  rig.put(0, {0.0, 0.0, 1.0}, {90.0, 0.0, 0.0});
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTooFast), 1U);
  EXPECT_EQ(rig.count(SampleFate::kTaken), 2U);
  EXPECT_NEAR(rig.velocity(0)[0], 0.0, 1e-3);
}

}  // namespace
}  // namespace mayfly::estimator_test
