#include "record/frame_ring.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "tests/unit/record/frames.hpp"

namespace mayfly::record {
namespace {

TEST(FrameRing, DropsWhatDoesNotFitAndTellsTheNextFrame) {
  FrameRing ring(4, 2);
  test::Frames frames(2);
  for (std::uint64_t tick = 0; tick < 6; ++tick) {
    frames.numbers[0][1] = static_cast<float>(tick);
    EXPECT_EQ(ring.push(frames.at(tick)), tick < 4);
  }
  EXPECT_EQ(ring.lost_at_end(), 2U);
  EXPECT_EQ(ring.front()->view.tick, 0U);
  ring.pop();
  EXPECT_TRUE(ring.push(frames.at(6)));
  EXPECT_EQ(ring.lost_at_end(), 0U);
  for (std::uint64_t tick = 1; tick < 4; ++tick, ring.pop()) {
    ASSERT_NE(ring.front(), nullptr);
    EXPECT_EQ(ring.front()->view.tick, tick);
    EXPECT_EQ(ring.front()->view.x[1], static_cast<float>(tick));
    EXPECT_EQ(ring.front()->lost_before, 0U);
  }
  EXPECT_EQ(ring.front()->view.tick, 6U);
  EXPECT_EQ(ring.front()->lost_before, 2U);
  ring.pop();
  EXPECT_EQ(ring.front(), nullptr);
}

TEST(FrameRing, EveryFrameArrivesOnceOrIsCounted) {
  FrameRing ring(8, 3);
  test::Frames frames(3);
  constexpr std::uint64_t kTicks = 20'000;
  std::atomic<bool> done{false};
  std::uint64_t arrived = 0;
  std::uint64_t lost = 0;
  std::uint64_t next = 0;
  std::thread consumer([&] {
    while (true) {
      const bool last_look = done.load();
      for (const auto* frame = ring.front(); frame != nullptr; frame = ring.front()) {
        lost += frame->lost_before;
        next += frame->lost_before;
        EXPECT_EQ(frame->view.tick, next);
        EXPECT_EQ(frame->view.z[2], static_cast<float>(next));
        ++next;
        ++arrived;
        ring.pop();
      }
      if (last_look) {
        return;
      }
      std::this_thread::yield();
    }
  });
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
    frames.numbers[2][2] = static_cast<float>(tick);
    ring.push(frames.at(tick));
  }
  done = true;
  consumer.join();
  EXPECT_EQ(arrived + lost + ring.lost_at_end(), kTicks);
}

}  // namespace
}  // namespace mayfly::record
