#include "controller/executor/handover.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

using namespace std::chrono_literals;

TEST(Handover, NothingIsThereUntilSomethingWasPublished) {
  Handover<int> box("a to b", 10ms, 7);
  EXPECT_EQ(box.read(0ms), nullptr);
  EXPECT_EQ(box.age(0ms), Time::max());
  const AgeStats stats = box.stats();
  EXPECT_EQ(stats.name, "a to b");
  EXPECT_EQ(stats.limit, 10ms);
  EXPECT_EQ(stats.read, 1U);
  EXPECT_EQ(stats.missing, 1U);
  EXPECT_EQ(stats.expired, 0U);
  EXPECT_EQ(stats.max, 0ns);
}

TEST(Handover, AValueCountsUpToItsLimitAndNotANanosecondLonger) {
  Handover<int> box("", 10ms, 0);
  box.draft() = 1;
  box.publish(5ms);
  const Aged<int>* at_limit = box.read(15ms);
  ASSERT_NE(at_limit, nullptr);
  EXPECT_EQ(at_limit->value, 1);
  EXPECT_EQ(at_limit->age(15ms), 10ms);
  EXPECT_EQ(box.read(15ms + 1ns), nullptr);
  EXPECT_EQ(box.age(16ms), 11ms);
  EXPECT_EQ(box.stats().expired, 1U);
  box.draft() = 2;
  box.publish(16ms);  // it clears as soon as something fresh is there
  ASSERT_NE(box.read(16ms), nullptr);
  EXPECT_EQ(box.stats().expired, 1U);
}

TEST(Handover, TheNewestWinsAndAgesAreOfEachRead) {
  Handover<std::vector<float>> box("", 1s, std::vector<float>(3));
  for (int k = 1; k <= 3; ++k) {
    box.draft().assign(3, static_cast<float>(k));
    box.publish(k * 1ms);
  }
  EXPECT_EQ(box.read(4ms)->value, std::vector<float>(3, 3.0F));
  box.read(8ms);
  const AgeStats stats = box.stats();
  EXPECT_EQ(stats.read, 2U);
  EXPECT_EQ(stats.max, 5ms);
  EXPECT_GE(stats.p50, 1ms);
  EXPECT_LT(stats.p50, 1010us);
}

// A producer whose clock was read a moment later than the consumer's.
TEST(Handover, WhatIsFromTheFutureIsFresh) {
  Handover<int> box("", 0ns, 0);
  box.publish(5ms);
  EXPECT_NE(box.read(4ms), nullptr);
  EXPECT_EQ(box.stats().max, 0ns);
}

TEST(Handover, AllocatesNothing) {
  Handover<std::vector<float>> box("", 1s, std::vector<float>(1000));
  const std::uint64_t before = allocation_count();
  for (int k = 0; k < 100; ++k) {
    box.draft()[0] = 1.0F;
    box.publish(k * 1ms);
    box.read(k * 1ms);
  }
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace mayfly
