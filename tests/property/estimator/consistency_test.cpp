// The filter's errors are as large as it says, wherever the origin is.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

constexpr double kSeconds = 0.01;
constexpr int kTicks = 150;

struct Robot {
  Vec place{0.0, 0.0, 1.0}, velocity{};
};

// Exactly the process that the filter assumes: white acceleration of this density.
void disturb(Robot& robot, double density, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double t = kSeconds;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = normal(random), b = normal(random);
    const double dv = std::sqrt(density * t) * a;
    const double dp = std::sqrt(density * t * t * t) * (a / 2.0 + b / std::sqrt(12.0));
    robot.place[k] += t * robot.velocity[k] + dp;
    robot.velocity[k] += dv;
  }
}

// Of one axis, from the inverse of its covariance: two degrees of freedom.
double normalised_error(const Uncertainty& sure, double dp, double dv) {
  const double a = sure.position * sure.position, c = sure.velocity * sure.velocity, b = sure.covariance;
  return (c * dp * dp - 2.0 * b * dp * dv + a * dv * dv) / (a * c - b * b);
}

struct Noises {
  float pose, velocity;
  bool takes_velocity;
};

class Consistency : public ::testing::TestWithParam<Noises> {};

// The mean over independent runs of a normalised error squared has expectation 6 and variance 12/runs
// (Bar-Shalom, Li and Kirubarajan 2001, §5.4.2). Five deviations: one false alarm in two million.
TEST_P(Consistency, ErrorsAreAsLargeAsTheCovarianceSays) {
  const int runs = 400;
  EstimatorConfig config = config_of(1, GetParam().pose);
  config.sources[0].takes_velocity = GetParam().takes_velocity;
  config.sources[0].velocity_noise = GetParam().velocity;
  config.robots[0].speed = std::numeric_limits<float>::infinity();  // a random walk has none
  const double density = 20.0 * 20.0 * kSeconds / 3.0;
  double total = 0.0;
  for (int run = 0; run < runs; ++run) {
    std::mt19937 random(static_cast<unsigned>(run));
    std::normal_distribution<double> normal;
    Rig rig(config);
    Robot robot;
    for (int tick = 0; tick < kTicks; ++tick) {
      disturb(robot, density, random);
      Vec seen = robot.place, speed = robot.velocity;
      for (std::size_t k = 0; k < 3; ++k) {
        seen[k] += static_cast<double>(GetParam().pose) * normal(random);
        speed[k] += static_cast<double>(GetParam().velocity) * normal(random);
      }
      rig.put(0, seen, speed);
      rig.tick();
    }
    for (std::size_t k = 0; k < 3; ++k) {
      total += normalised_error(rig.estimator.uncertainty(0), rig.place(0)[k] - robot.place[k],
                                rig.velocity(0)[k] - robot.velocity[k]);
    }
  }
  EXPECT_NEAR(total / runs, 6.0, 5.0 * std::sqrt(12.0 / runs));
}
INSTANTIATE_TEST_SUITE_P(Estimator, Consistency,
                         ::testing::Values(Noises{0.002F, 0.0F, false}, Noises{0.05F, 0.0F, false},
                                           Noises{0.02F, 0.1F, true}, Noises{0.01F, 0.01F, true}));

// A robot that keeps its limit disturbs the filter no more than it expects, and no gate ever closes.
TEST(Consistency, OfARobotThatJerksWithinItsLimits) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> sign(-1.0, 1.0);
    const double noise = 0.01;
    Rig rig(config_of(1, 0.01F));
    Robot robot;
    double squares = 0.0;
    for (int tick = 0; tick < 2000; ++tick) {
      Vec seen = robot.place;
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = sign(random) * 20.0 / std::sqrt(3.0);
        const double v = std::clamp(robot.velocity[k] + kSeconds * a, -1.7, 1.7);
        robot.place[k] += 0.5 * kSeconds * (v + robot.velocity[k]);
        robot.velocity[k] = v;
        seen[k] = robot.place[k] + noise * normal(random);
      }
      rig.put(0, seen);
      rig.tick();
      ASSERT_TRUE(rig.estimator.estimate().symptoms[0].empty()) << "seed " << seed << ", tick " << tick;
      squares += std::pow(rig.place(0)[0] - robot.place[0], 2);
    }
    EXPECT_LT(std::sqrt(squares / 2000), noise) << "worse than the sample itself";
  }
}

TEST(Translation, ChangesNothing) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  const auto on_grid = [](double value) { return std::round(value * 4096.0) / 4096.0; };
  const Vec shift{64.0, -128.0, 32.0};
  Rig here(config_of(1, 0.01F)), there(config_of(1, 0.01F));
  for (int tick = 1; tick < 2000; ++tick) {
    // Jumps, gaps and late samples included.
    const double leap = tick % 97 == 0 ? 2.0 : 0.0;
    const Time late = tick % 5 == 0 ? kPeriod + kPeriod / 2 : Time{0};
    const double t = 0.01 * tick;
    Vec a{on_grid(std::sin(t) + 0.01 * normal(random) + leap), on_grid(0.01 * normal(random)), 1.0};
    Vec b = a;
    for (std::size_t k = 0; k < 3; ++k) {
      b[k] += shift[k];
    }
    if (tick % 11 == 0) {
      here.lose(0), there.lose(0);
    } else {
      here.put_at(0, a, {}, here.now - late), there.put_at(0, b, {}, there.now - late);
    }
    here.tick(), there.tick();
    ASSERT_EQ(here.estimator.estimate().symptoms[0], there.estimator.estimate().symptoms[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(here.place(0)[k] + shift[k], there.place(0)[k], 2e-5);
      ASSERT_NEAR(here.velocity(0)[k], there.velocity(0)[k], 1e-6);
    }
  }
  EXPECT_GT(here.count(SampleFate::kJumped), 10U);
  EXPECT_GT(here.count(SampleFate::kTakenLate), 100U);
}

}  // namespace
}  // namespace mayfly::estimator_test
