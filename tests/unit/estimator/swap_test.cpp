// Robots whose names were exchanged.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

// Robots on a ring, at most 2 m/s, of which a test may exchange the names.
class Swap : public ::testing::Test {
 protected:
  explicit Swap(std::size_t robots = 3, float noise = 0.0F) : rig(config_of(robots, noise)), column(robots) {
    for (std::size_t r = 0; r < robots; ++r) {
      column[r] = r;
      place.push_back({static_cast<double>(r), 0.0, 1.0});
      velocity.push_back({0.0, r % 2 == 0 ? 1.0 : -1.0, 0.0});
    }
  }
  void fly(int ticks, bool moves = true) {
    for (int i = 0; i < ticks; ++i) {
      for (std::size_t r = 0; r < column.size(); ++r) {
        for (std::size_t k = 0; k < 3 && moves; ++k) {
          place[r][k] += 0.01 * velocity[r][k];
        }
        rig.put(column[r], place[r], moves ? velocity[r] : Vec{});
        if (moves) {
          rig.tell(r, velocity[r]);
        } else {
          rig.tell_hold(r);
        }
      }
      rig.tick();
    }
  }
  bool is_told() const { return rig.estimator.estimate().everybody.has(Symptom::kIdSwap); }

 public:
  Rig rig;
  std::vector<std::size_t> column;  // where a robot's samples stand
  std::vector<Vec> place, velocity;
};

TEST_F(Swap, IsToldWithTheFirstSampleAndNotBefore) {
  fly(20);
  EXPECT_FALSE(is_told());
  std::swap(column[0], column[2]);
  fly(1);
  EXPECT_TRUE(is_told());
  EXPECT_TRUE(rig.has(0, Symptom::kPoseJump));
  EXPECT_TRUE(rig.has(2, Symptom::kPoseJump));
  EXPECT_TRUE(rig.estimator.estimate().symptoms[1].empty());
  EXPECT_EQ(rig.estimator.counters().id_swaps, 1U);
}

TEST_F(Swap, OfThreeInARingIsToldToo) {
  fly(20);
  column = {1, 2, 0};
  fly(1);
  EXPECT_TRUE(is_told());
  EXPECT_EQ(rig.estimator.counters().id_swaps, 1U);
}

TEST_F(Swap, WithinThreeSamplesWhereOnesPoseWasMissing) {
  fly(20);
  std::swap(column[0], column[2]);
  rig.put(0, place[2], velocity[2]);
  rig.lose(2);
  rig.tick();
  EXPECT_FALSE(is_told()) << "one jump is no exchange";
  fly(1);
  EXPECT_TRUE(is_told());
}

TEST_F(Swap, TwoJumpsThatDoNotFitAreNone) {
  fly(20);
  for (int i = 0; i < 3; ++i) {
    rig.put(0, {2.0, place[2][1] + 0.3, 1.0});
    rig.put(2, place[0]);
    rig.tick();
    EXPECT_FALSE(is_told());
  }
}

TEST_F(Swap, MovingRobotsAreNotIdentifiedAnew) {
  fly(20);
  std::swap(column[0], column[2]);
  for (int i = 0; i < 300; ++i) {
    fly(1);
    ASSERT_TRUE(is_told()) << i;
  }
  EXPECT_FALSE(rig.known(0));
  EXPECT_FALSE(rig.known(2));
  EXPECT_TRUE(rig.known(1));
}

TEST_F(Swap, WhoIsToldToMoveDoesNotStand) {
  fly(20);
  std::swap(column[0], column[2]);
  for (int i = 0; i < 50; ++i) {
    for (std::size_t r = 0; r < 3; ++r) {
      const double jitter = i % 2 == 0 ? 1e-4 : 0.0;
      rig.put(column[r], {place[r][0] + jitter, place[r][1], 1.0});
    }
    rig.tick();
    ASSERT_TRUE(is_told()) << i;
  }
}

TEST_F(Swap, OnceAllStandEachGoesOnUnderItsNewName) {
  fly(20);
  std::swap(column[0], column[2]);
  fly(5);
  int ticks = 0;
  for (; is_told() && ticks < 100; ++ticks) {
    fly(1, false);
  }
  // They are told to stop in the first tick, brake from 1 m/s at 20 m/s², and are then seen to stand.
  EXPECT_LE(ticks, 2 + 5 + 5);
  EXPECT_GE(ticks, 5);
  fly(1, false);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_TRUE(rig.known(r));
    EXPECT_NEAR(rig.place(r)[0], place[r][0], 1e-6) << "robot " << r;
    EXPECT_NEAR(rig.place(r)[1], place[r][1], 1e-6);
    EXPECT_TRUE(rig.estimator.estimate().symptoms[r].empty());
  }
  fly(50);
  EXPECT_NEAR(rig.place(0)[1], place[0][1], 1e-5);
}

TEST_F(Swap, EndsWhereTheNamesAreGivenBack) {
  fly(20);
  std::swap(column[0], column[2]);
  fly(4);
  EXPECT_TRUE(is_told());
  std::swap(column[0], column[2]);
  fly(1);
  EXPECT_FALSE(is_told());
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_TRUE(rig.estimator.estimate().symptoms[r].empty());
    EXPECT_NEAR(rig.place(r)[1], place[r][1], 1e-6);
  }
}

TEST_F(Swap, WhereOnlyOneNameIsGivenBackTheOtherHasJumped) {
  fly(20);
  std::swap(column[0], column[2]);
  fly(4);
  rig.tell_hold(0), rig.tell_hold(1), rig.tell_hold(2);
  for (int i = 0; i < 20; ++i) {
    rig.put(0, place[0]);
    rig.put(1, place[1]);
    rig.put(2, place[0]);
    rig.tick();
  }
  EXPECT_FALSE(is_told());
  EXPECT_TRUE(rig.known(0));
  EXPECT_TRUE(rig.has(2, Symptom::kPoseJump));
  EXPECT_FALSE(rig.known(2));
}

TEST_F(Swap, MayHappenAgain) {
  fly(20);
  std::swap(column[0], column[2]);
  fly(3);
  fly(30, false);
  EXPECT_FALSE(is_told());
  std::swap(column[0], column[1]);
  fly(2, false);
  EXPECT_TRUE(is_told());
  EXPECT_EQ(rig.estimator.counters().id_swaps, 2U);
  fly(30, false);
  EXPECT_FALSE(is_told());
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_NEAR(rig.place(r)[0], place[r][0], 1e-6);
  }
}

// Two that cross, 30 cm from each other, as seen through noise: the moment at which trackers fail.
TEST(SwapAtACrossing, IsTold) {
  Rig rig(config_of(2, 0.005F));
  const auto fly = [&rig](int from, int until, bool swapped) {
    for (int i = from; i < until; ++i) {
      const double s = 0.01 * i;
      const Vec a{s - 1.0, 0.15, 1.0}, b{1.0 - s, -0.15, 1.0};
      rig.put(swapped ? 1 : 0, a);
      rig.put(swapped ? 0 : 1, b);
      rig.tick();
    }
  };
  fly(0, 100, false);
  EXPECT_FALSE(rig.estimator.estimate().everybody.has(Symptom::kIdSwap));
  fly(100, 101, true);
  EXPECT_TRUE(rig.estimator.estimate().everybody.has(Symptom::kIdSwap));
}

// The first flew towards the second, and brakes; a belief that knows nothing of commands flies on through it.
TEST(SwapAhead, OneIsNotTakenForTheOtherWhereItWouldHaveFlownThrough) {
  Rig rig(config_of(2));
  double x = -0.2, speed = 2.0;
  for (int i = 0; i < 80; ++i) {
    const bool swapped = i >= 20;
    speed = swapped ? std::max(0.0, speed - 0.04) : speed;
    const double other = 1.0 + (i % 2 == 0 ? 0.0 : 1e-3);
    rig.put(swapped ? 1 : 0, {x, 0.0, 1.0}, {speed, 0.0, 0.0});
    rig.put(swapped ? 0 : 1, {other, 0.0, 1.0});
    rig.tell(0, {speed, 0.0, 0.0});
    rig.tick();
    x += 0.01 * speed;
    ASSERT_EQ(rig.estimator.counters().started_anew, 0U) << i;
  }
  rig.tell_hold(0);
  for (int i = 0; i < 20; ++i) {
    rig.put(1, {x, 0.0, 1.0});
    rig.put(0, {1.0, 0.0, 1.0});
    rig.tick();
  }
  EXPECT_TRUE(rig.known(0));
  EXPECT_NEAR(rig.place(0)[0], x, 1e-3);
  EXPECT_NEAR(rig.place(1)[0], 1.0, 2e-3);
  EXPECT_EQ(rig.estimator.counters().id_swaps, 1U);
}

TEST(SwapOfMany, IsAFrameThatMovedAndNotLookedInto) {
  const std::size_t robots = 40;
  Rig rig(config_of(robots));
  for (int i = 0; i < 25; ++i) {
    for (std::size_t r = 0; r < robots; ++r) {
      rig.put(r, {static_cast<double>((r + (i < 20 ? 0 : 1)) % robots), 0.0, 1.0});
    }
    rig.tick();
    EXPECT_FALSE(rig.estimator.estimate().everybody.has(Symptom::kIdSwap));
  }
  EXPECT_EQ(rig.estimator.counters().started_anew, robots);
}

}  // namespace
}  // namespace mayfly::estimator_test
