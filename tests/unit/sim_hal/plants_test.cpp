// What the plants do, against double-precision solutions, and that both engines do the same to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "kernels/plants.h"
#include "sim_hal/plant_stepper.hpp"
#include "tests/reference/plants.hpp"

namespace mayfly::sim_hal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Case {
  float p, v, u, max_speed, max_acceleration;
};

// One robot, along an axis that lies obliquely in space, so that norms matter.
class OneRobot {
 public:
  OneRobot(const PlantParameters& parameters, const Case& c) : stepper_(make_native_stepper(1, parameters)) {
    for (int axis = 0; axis < 3; ++axis) {
      column(MF_PLANT_X + axis) = c.p * kAxis[axis];
      column(MF_PLANT_VX + axis) = c.v * kAxis[axis];
      column(MF_PLANT_UX + axis) = c.u * kAxis[axis];
    }
    column(MF_PLANT_MAX_SPEED) = c.max_speed;
    column(MF_PLANT_MAX_ACCELERATION) = c.max_acceleration;
  }
  void step(std::uint32_t count) { ASSERT_EQ(stepper_->step(count), ""); }
  double along(int first) {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      sum += static_cast<double>(kAxis[axis]) * static_cast<double>(column(first + axis));
    }
    return sum;
  }
  double p() { return along(MF_PLANT_X); }
  double v() { return along(MF_PLANT_VX); }

 private:
  static constexpr float kAxis[3] = {2.0F / 7.0F, -3.0F / 7.0F, 6.0F / 7.0F};
  float& column(int index) { return stepper_->block().column(index, 1)[0]; }
  std::unique_ptr<PlantStepper> stepper_;
};

TEST(Plant, IdealIsTheCommandAtOnce) {
  OneRobot robot({Plant::kIdeal, 0.1F, 100.0}, {1.0F, -5.0F, 2.0F, kInfinity, 0.001F});
  robot.step(1);
  EXPECT_NEAR(robot.v(), 2.0, 1e-6);
  EXPECT_NEAR(robot.p(), 1.02, 1e-6);
}

TEST(Plant, VelocityLagIsTheExponential) {
  for (const double rate : {20.0, 200.0, 1000.0}) {  // exact at any step
    for (const float tau : {0.02F, 0.1F, 1.0F}) {
      OneRobot robot({Plant::kVelocityLag, tau, rate}, {0.5F, -1.0F, 2.0F, kInfinity, kInfinity});
      for (int tenth = 1; tenth <= 20; ++tenth) {
        robot.step(static_cast<std::uint32_t>(rate / 10.0));
        const auto expected =
            reference::velocity_lag({0.5, -1.0}, 2.0, static_cast<double>(tau), 0.1 * tenth);
        // Each step rounds; a lag of τ remembers τ · rate of them.
        ASSERT_NEAR(robot.v(), expected.v, 3e-7 * std::max(1.0, static_cast<double>(tau) * rate))
            << rate << ' ' << tau << ' ' << tenth;
        ASSERT_NEAR(robot.p(), expected.p, 2e-4) << rate << ' ' << tau << ' ' << tenth;
      }
    }
  }
}

TEST(Plant, VelocityLagWithoutLagIsIdeal) {
  OneRobot robot({Plant::kVelocityLag, 0.0F, 100.0}, {0.0F, 0.0F, 2.0F, kInfinity, kInfinity});
  robot.step(10);
  EXPECT_NEAR(robot.v(), 2.0, 1e-6);
  EXPECT_NEAR(robot.p(), 0.2, 1e-6);
}

TEST(Plant, VelocityLagAcceleratesNoHarderThanItCan) {
  OneRobot robot({Plant::kVelocityLag, 0.01F, 100.0}, {0.0F, 0.0F, 3.0F, kInfinity, 2.0F});
  double last = 0.0;
  for (int step = 0; step < 300; ++step) {
    robot.step(1);
    ASSERT_LE(robot.v() - last, 0.02 + 1e-6);
    last = robot.v();
  }
  EXPECT_NEAR(last, 3.0, 1e-3);
  OneRobot half_way({Plant::kVelocityLag, 0.01F, 100.0}, {0.0F, 0.0F, 3.0F, kInfinity, 2.0F});
  half_way.step(100);  // all of it at full thrust
  EXPECT_NEAR(half_way.v(), 2.0, 1e-5);
  EXPECT_NEAR(half_way.p(), 1.0, 1e-5);
}

TEST(Plant, DoubleIntegratorGoesStraightToTheCommand) {
  for (const Case& c : {Case{0.0F, 0.0F, 3.0F, kInfinity, 2.0F}, Case{1.0F, 2.0F, -2.0F, kInfinity, 5.0F}}) {
    OneRobot robot({Plant::kDoubleIntegrator, 0.1F, 1000.0}, c);
    for (int tenth = 1; tenth <= 30; ++tenth) {
      robot.step(100);
      const auto expected = reference::double_integrator(
          {static_cast<double>(c.p), static_cast<double>(c.v)}, static_cast<double>(c.u),
          static_cast<double>(c.max_acceleration), 0.1 * tenth);
      ASSERT_NEAR(robot.v(), expected.v, 1e-4);
      ASSERT_NEAR(robot.p(), expected.p, 1e-3);
    }
  }
}

TEST(Plant, DoubleIntegratorTurnsTheShortestWay) {
  auto stepper = make_native_stepper(1, {Plant::kDoubleIntegrator, 0.1F, 10.0});
  const PlantBlock block = stepper->block();
  block.column(MF_PLANT_VX, 1)[0] = 1.0F;      // east …
  block.column(MF_PLANT_UX + 1, 1)[0] = 1.0F;  // … to north
  block.column(MF_PLANT_MAX_SPEED, 1)[0] = kInfinity;
  block.column(MF_PLANT_MAX_ACCELERATION, 1)[0] = 1.0F;
  stepper->step(1);
  EXPECT_NEAR(block.column(MF_PLANT_VX, 1)[0], 1.0F - 0.1F * std::sqrt(0.5F), 1e-6F);
  EXPECT_NEAR(block.column(MF_PLANT_VX + 1, 1)[0], 0.1F * std::sqrt(0.5F), 1e-6F);
}

TEST(Plant, NoneGoesFasterThanItCan) {
  for (const Plant plant : {Plant::kIdeal, Plant::kVelocityLag, Plant::kDoubleIntegrator}) {
    OneRobot robot({plant, 0.1F, 100.0}, {0.0F, 0.0F, 1e6F, 4.0F, 20.0F});
    for (int step = 0; step < 500; ++step) {
      robot.step(1);
      ASSERT_LE(robot.v(), 4.0 + 1e-5);
    }
    EXPECT_NEAR(robot.v(), 4.0, 1e-4);
  }
}

TEST(Plant, ARobotThatCannotAccelerateStaysAsItIs) {
  OneRobot robot({Plant::kDoubleIntegrator, 0.1F, 100.0}, {0.0F, 1.0F, 3.0F, kInfinity, 0.0F});
  robot.step(100);
  EXPECT_NEAR(robot.v(), 1.0, 1e-6);
  OneRobot resting({Plant::kVelocityLag, 0.1F, 100.0},
                   {0.0F, 0.0F, 0.0F, 0.0F, 0.0F});  // 0/0 is not looked at
  resting.step(100);
  EXPECT_EQ(resting.v(), 0.0);
  EXPECT_EQ(resting.p(), 0.0);
}

// Random robots, a new command every tenth step, for a thousand steps.
void expect_same_bits(Plant plant, std::size_t robots) {
  const PlantParameters parameters{plant, 0.1F, 200.0};
  auto native = make_native_stepper(robots, parameters);
  auto made = make_opencl_stepper(robots, parameters);
  ASSERT_TRUE(made.has_value()) << to_string(made.error());
  PlantStepper& opencl = **made;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-5.0F, 5.0F);
  for (int round = 0; round < 100; ++round) {
    for (int column = round == 0 ? 0 : MF_PLANT_UX; column < MF_PLANT_COLUMNS; ++column) {
      for (std::size_t robot = 0; robot < robots; ++robot) {
        const float value = column < MF_PLANT_MAX_SPEED ? uniform(random) : 1.0F + std::abs(uniform(random));
        native->block().column(column, robots)[robot] = value;
        opencl.block().column(column, robots)[robot] = value;
      }
    }
    ASSERT_EQ(native->step(10), "");
    ASSERT_EQ(opencl.step(10), "");
    const auto a = native->block().values;
    const auto b = opencl.block().values;
    ASSERT_EQ(a.size(), b.size());
    ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << "round " << round;
  }
}

TEST(Parity, IdealIsTheSameInBothEngines) {
  expect_same_bits(Plant::kIdeal, 300);
}
TEST(Parity, VelocityLagIsTheSameInBothEngines) {
  expect_same_bits(Plant::kVelocityLag, 300);
}
TEST(Parity, DoubleIntegratorIsTheSameInBothEngines) {
  expect_same_bits(Plant::kDoubleIntegrator, 300);
}
TEST(Parity, OneRobotIsTheSameInBothEngines) {
  expect_same_bits(Plant::kVelocityLag, 1);
}

TEST(Parity, ABatchIsItsSteps) {
  const PlantParameters parameters{Plant::kVelocityLag, 0.1F, 200.0};
  for (const bool opencl : {false, true}) {
    std::vector<std::unique_ptr<PlantStepper>> two;
    for (int i = 0; i < 2; ++i) {
      two.push_back(opencl ? std::move(*make_opencl_stepper(9, parameters))
                           : make_native_stepper(9, parameters));
      two.back()->block().column(MF_PLANT_UX, 9)[8] = 1.0F;
      two.back()->block().column(MF_PLANT_MAX_SPEED, 9)[8] = 9.0F;
      two.back()->block().column(MF_PLANT_MAX_ACCELERATION, 9)[8] = 9.0F;
    }
    two[0]->step(50);
    for (int step = 0; step < 50; ++step) {
      two[1]->step(1);
    }
    EXPECT_GT(two[0]->block().column(MF_PLANT_X, 9)[8], 0.0F);
    EXPECT_EQ(two[0]->block().column(MF_PLANT_X, 9)[8], two[1]->block().column(MF_PLANT_X, 9)[8]);
  }
}

}  // namespace
}  // namespace mayfly::sim_hal
