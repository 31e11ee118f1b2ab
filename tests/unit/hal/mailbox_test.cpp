#include "core/mailbox.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace mayfly {
namespace {

TEST(Mailbox, IsEmptyUntilSomethingIsPublished) {
  Mailbox<int> box(7);
  EXPECT_FALSE(box.collect());
  EXPECT_EQ(box.latest(), 7);
  box.draft() = 1;
  EXPECT_FALSE(box.collect());
  box.publish();
  EXPECT_TRUE(box.collect());
  EXPECT_EQ(box.latest(), 1);
  EXPECT_FALSE(box.collect());
  EXPECT_EQ(box.latest(), 1);
}

TEST(Mailbox, TheNewestWins) {
  Mailbox<int> box;
  for (int value = 1; value <= 5; ++value) {
    box.draft() = value;
    box.publish();
  }
  EXPECT_TRUE(box.collect());
  EXPECT_EQ(box.latest(), 5);
  EXPECT_FALSE(box.collect());
}

TEST(Mailbox, WhatIsBeingReadIsNotOverwritten) {
  Mailbox<int> box;
  box.draft() = 1;
  box.publish();
  ASSERT_TRUE(box.collect());
  const int* reading = &box.latest();
  for (int value = 2; value <= 9; ++value) {
    box.draft() = value;
    EXPECT_NE(&box.draft(), reading);
    box.publish();
  }
  EXPECT_EQ(*reading, 1);
}

// Every value is whole, none comes twice or out of order, and the last one arrives. With a thread sanitizer
// this is also the proof that the slots are handed over properly.
TEST(Mailbox, TwoThreadsSeeWholeValuesInOrder) {
  constexpr int kLast = 100000;
  Mailbox<std::vector<int>> box(std::vector<int>(16));
  std::thread producer([&box] {
    for (int value = 1; value <= kLast; ++value) {
      for (int& element : box.draft()) {
        element = value;
      }
      box.publish();
    }
  });
  int previous = 0;
  bool whole = true;
  bool in_order = true;
  while (previous < kLast) {
    if (!box.collect()) {
      std::this_thread::yield();
      continue;
    }
    const std::vector<int>& value = box.latest();
    whole = whole && value == std::vector<int>(16, value.front());
    in_order = in_order && value.front() > previous;
    previous = value.front();
  }
  producer.join();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(in_order);
}

}  // namespace
}  // namespace mayfly
