// The tape holds the last seconds, in order, and what happens while it is stored does not wait for it.
#include "controller/guard/black_box.hpp"

#include <gtest/gtest.h>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/guard/wish.hpp"

namespace mayfly::test {
namespace {

struct Recorder {
  Recorder(const BlackBoxConfig& config, std::size_t of) : robots(of), box(config, kTick, of) {}

  void tick() {
    const auto n = static_cast<float>(++ticks);
    const std::vector<float> column(robots, n);
    const std::vector<float> zero(robots);
    const std::vector<Time> stamp(robots);
    const std::vector<std::uint8_t> one(robots, 1);
    const std::vector<Symptoms> symptoms(robots);
    const std::vector<RobotState> states(robots, RobotState::kFlying);
    const std::vector<Severity> severities(robots, Severity::kHold);
    const WishOf sent(robots, {0, n, 0});
    const TickOutcome outcome{ticks * kTick,
                              sent.columns(Time{0}, static_cast<std::uint64_t>(ticks)),
                              {column, column, column, zero, zero, zero, stamp, one, symptoms, {}, {}},
                              states,
                              severities,
                              one,
                              symptoms,
                              false};
    const std::uint64_t before = allocation_count();
    box.keep({outcome, desk, symptoms, {}, ticks % 2 == 0});
    EXPECT_EQ(allocation_count(), before);
  }

  std::size_t robots;
  BlackBox box;
  WishDesk desk{4, kTick};
  int ticks = 0;
};

TEST(BlackBox, KeepsTheLastTicksInOrder) {
  Recorder recorder({.seconds = 0.05}, 4);
  for (int i = 0; i < 23; ++i) {
    recorder.tick();
  }
  EXPECT_EQ(recorder.box.sealed(), nullptr);
  EXPECT_TRUE(recorder.box.seal());
  const BlackBoxTape* tape = recorder.box.sealed();
  ASSERT_NE(tape, nullptr);
  ASSERT_EQ(tape->size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(tape->frame(i).time, (19 + static_cast<int>(i)) * kTick);
    EXPECT_EQ(tape->frame(i).sequence, 19 + i);
    EXPECT_EQ(tape->rows(i).size(), 4U);
    EXPECT_EQ(tape->rows(i)[3].x, static_cast<float>(19 + i));
    EXPECT_EQ(tape->rows(i)[3].sent_y, static_cast<float>(19 + i));
    EXPECT_EQ(tape->rows(i)[3].severity, Severity::kHold);
  }
}

TEST(BlackBox, OfAShortFlightKeepsAll) {
  Recorder recorder({.seconds = 0.05}, 1);
  recorder.tick();
  recorder.tick();
  recorder.box.seal();
  ASSERT_NE(recorder.box.sealed(), nullptr);
  EXPECT_EQ(recorder.box.sealed()->size(), 2U);
}

TEST(BlackBox, WhatHappensWhileATapeIsStoredIsCounted) {
  Recorder recorder({.seconds = 0.05}, 1);
  recorder.tick();
  EXPECT_TRUE(recorder.box.seal());
  recorder.tick();
  EXPECT_FALSE(recorder.box.seal());
  EXPECT_EQ(recorder.box.incidents(), 2U);
  EXPECT_EQ(recorder.box.sealed()->size(), 1U) << "the first stays as it was";
  recorder.box.release();
  EXPECT_EQ(recorder.box.sealed(), nullptr);
  recorder.tick();
  EXPECT_TRUE(recorder.box.seal());
  EXPECT_EQ(recorder.box.sealed()->size(), 2U) << "since the first was sealed";
}

TEST(BlackBox, TakesNoMoreMemoryThanItMay) {
  Recorder recorder({.seconds = 3600.0, .most_bytes = 100'000}, 4);
  for (int i = 0; i < 2000; ++i) {
    recorder.tick();
  }
  recorder.box.seal();
  const std::size_t ticks = recorder.box.sealed()->size();
  EXPECT_LE(2 * ticks * (4 * sizeof(BlackBoxRow) + sizeof(BlackBoxFrame)), 100'000U);
  EXPECT_GT(ticks, 50U);
}

TEST(BlackBox, OfNobodyKeepsTheTicks) {
  Recorder recorder({.seconds = 0.05}, 0);
  recorder.tick();
  recorder.box.seal();
  EXPECT_EQ(recorder.box.sealed()->size(), 1U);
}

}  // namespace
}  // namespace mayfly::test
