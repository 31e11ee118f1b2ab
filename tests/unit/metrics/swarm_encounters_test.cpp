// Clouds that part before something and close again, by construction.
#include "controller/metrics/swarm_encounters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

using Kind = MotionQuestion::Kind;

// Eight agents at the corners of a cube of half a side `half` (m) about `centre`.
struct Cube {
  std::vector<float> x, y, z, still;
  Cube() : x(8), y(8), z(8), still(8) {}
  MetricsTick at(glm::dvec3 centre, double half) {
    for (unsigned i = 0; i < 8; ++i) {
      x[i] = static_cast<float>(centre.x + ((i & 1U) != 0 ? half : -half));
      y[i] = static_cast<float>(centre.y + ((i & 2U) != 0 ? half : -half));
      z[i] = static_cast<float>(centre.z + ((i & 4U) != 0 ? half : -half));
    }
    return {x, y, z, still, still, still};
  }
};

MotionQuestion ask(Kind kind, const glm::dvec3& place, double within) {
  MotionQuestion question{kind, 0, 8, [&place] { return place; }};
  question.within = within;
  return question;
}

// A hunter comes along x; from tick 40 to 60 the cube is three times as large, at the end 1.2 times.
struct Hunt {
  glm::dvec3 hunter{0.0};
  SwarmEncounters encounters;
  explicit Hunt(double within)
      : encounters({ask(Kind::kParting, hunter, within), ask(Kind::kClosing, hunter, within),
                    ask(Kind::kClearing, hunter, within), ask(Kind::kNone, hunter, within)},
                   100) {}
  std::vector<std::optional<double>> answers() {
    Cube cube;
    LastSeen seen(8);
    for (int tick = 0; tick < 100; ++tick) {
      hunter = glm::dvec3(tick - 50.0, 0.0, 0.0);
      seen.update(cube.at(glm::dvec3(0.0), tick < 40 ? 1.0 : tick < 60 ? 3.0 : 1.2));
      const std::uint64_t before = allocation_count();
      encounters.observe(seen);
      EXPECT_EQ(allocation_count(), before);
    }
    return encounters.answers();
  }
};

TEST(Encounters, PartingAndClosingAreByTheSpreadWhenItBegan) {
  const auto answers = Hunt(15.0).answers();
  EXPECT_NEAR(answers.at(0).value(), 3.0, 1e-5);
  EXPECT_NEAR(answers.at(1).value(), 1.2, 1e-5);
  EXPECT_FALSE(answers.at(3));
}

TEST(Encounters, ClearingIsTheLeastDistanceOfAll) {
  // Three metres from its middle the hunter is level with a face of the cube of half a side 3.
  EXPECT_NEAR(Hunt(15.0).answers().at(2).value(), std::sqrt(18.0), 1e-5);
}

TEST(Encounters, WithoutOneNothingIsMeasured) {
  const auto answers = Hunt(0.5).answers();
  EXPECT_FALSE(answers.at(0));
  EXPECT_FALSE(answers.at(1));
  EXPECT_TRUE(answers.at(2));
}

TEST(Arrived, IsTheShareOfAllAtItsTime) {
  const glm::dvec3 lamp(1.0, 0.0, 0.0);
  MotionQuestion at_the_end = ask(Kind::kArrived, lamp, 2.0);
  MotionQuestion half_way = at_the_end;
  half_way.at_tick = 4;
  SwarmEncounters encounters({at_the_end, half_way}, 10);
  LastSeen seen(8);
  std::vector<float> x(8), zero(8);
  std::vector<std::uint8_t> present(8, 1);
  present[7] = 0;
  for (std::size_t tick = 0; tick < 10; ++tick) {
    for (std::size_t i = 0; i < 8; ++i) {
      x[i] = tick >= i ? 0.0F : 50.0F;  // one more a tick
    }
    MetricsTick now{x, zero, zero, zero, zero, zero};
    now.present = present;
    seen.update(now);
    encounters.observe(seen);
  }
  EXPECT_DOUBLE_EQ(encounters.answers().at(0).value(), 7.0 / 8.0);  // the last is not there
  EXPECT_DOUBLE_EQ(encounters.answers().at(1).value(), 5.0 / 8.0);
}

}  // namespace
}  // namespace mayfly
