// A planner that has gone mad writes what it likes, where it likes, while the guard reads.
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <random>
#include <thread>

#include "tests/unit/link/link_pair.hpp"

namespace mayfly::link::test {
namespace {

constexpr std::size_t kRobots = 7;
constexpr Time kNow{1'000'000'000};

std::span<SharedWord> all_words(const Segment& segment) {
  return {reinterpret_cast<SharedWord*>(&segment.header()), segment.layout().words};
}

// What holds of a wish whatever the memory says.
void expect_sane(GuardEnd& guard, Time now, std::uint64_t& sequence) {
  const CommandColumns wish = guard.wish(now);
  ASSERT_EQ(wish.kind.size(), kRobots);
  ASSERT_EQ(wish.vx.size(), kRobots);
  for (const CommandKind kind : wish.kind) {
    ASSERT_LE(kind, CommandKind::kStop);
  }
  ASSERT_LE(wish.deadline, now + Pair::kMostAge);
  ASSERT_GE(wish.deadline, Time(-1));
  ASSERT_GE(wish.sequence, sequence);
  ASSERT_GE(guard.issued(), Time(0));
  ASSERT_LE(guard.issued(), now);
  ASSERT_LE(guard.stop(), StopLevel::kEmergencyStop);
  ASSERT_LE(guard.want(), Want::kEnd);
  sequence = wish.sequence;
}

// Words as a bug would leave them: small numbers, neighbours of what was there, all bits, chance.
Word garbage(std::mt19937_64& random, Word was) {
  switch (random() % 5) {
    case 0:
      return random() % 64;
    case 1:
      return was + random() % 5 - 2;
    case 2:
      return ~Word{0};
    case 3:
      return was ^ (Word{1} << random() % 64);
    default:
      return random();
  }
}

TEST(HostilePlanner, GarbageAnywhereIsNeitherBelievedNorFollowed) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    std::mt19937_64 random(seed);
    Pair link(kRobots);
    const std::span<SharedWord> words = all_words(link.planner.segment());
    std::uint64_t sequence = 0;
    Time now = kNow;
    for (int tick = 0; tick < 50; ++tick) {
      now += Time(10'000'000);
      link.wish_velocity(1.0F, now, now + Time(20'000'000));
      for (std::uint64_t hits = random() % 20; hits > 0; --hits) {
        SharedWord& word = words[random() % words.size()];
        word = garbage(random, word);
      }
      expect_sane(link.guard, now, sequence);
      link.guard.show();
      link.guard.tell({});
      if (HasFatalFailure()) {
        FAIL() << "seed " << seed << ", tick " << tick;
      }
    }
  }
}

TEST(HostilePlanner, AWishOfAnotherOwnerIsRefused) {
  Pair link(kRobots);
  link.wish_velocity(1.0F, kNow, kNow + Time(1));
  EXPECT_EQ(link.guard.wish(kNow).sequence, 1U);
  link.planner.wish().head->owner ^= 1U;
  link.wish_velocity(9.0F, kNow, kNow + Time(1));
  EXPECT_EQ(link.guard.wish(kNow).sequence, 1U);
  EXPECT_EQ(link.guard.wish(kNow).vx[0], 1.0F);
  EXPECT_EQ(link.guard.refused(), 1U);
  EXPECT_FALSE(link.guard.has_one_owner());
  EXPECT_TRUE(link.guard.has_one_owner()) << "each is told once";
}

TEST(HostilePlanner, WhoeverTakesTheLeaseFromItsOwnerIsNotOne) {
  Pair link(kRobots);
  EXPECT_TRUE(link.guard.has_one_owner());
  link.planner.segment().header().planner += 1;
  EXPECT_FALSE(link.guard.has_one_owner());
  EXPECT_FALSE(link.guard.has_one_owner()) << "as long as it is so";
}

TEST(HostilePlanner, ASecondOneIsRefusedAndCounted) {
  Pair link(kRobots);
  EXPECT_EQ(link.guard.leases_refused(), 0U);
  EXPECT_FALSE(PlannerEnd::make(same_segment(link.planner.segment(), kRobots)));
  EXPECT_FALSE(GuardEnd::make(same_segment(link.planner.segment(), kRobots), Pair::kMostAge));
  EXPECT_EQ(link.guard.leases_refused(), 2U);
  EXPECT_TRUE(link.guard.has_one_owner()) << "the first is the owner as before";
}

TEST(HostilePlanner, AnOldOrRepeatedWishIsRefused) {
  Pair link(kRobots);
  link.planner.wish().head->sequence = 10;
  link.wish_velocity(1.0F, kNow, kNow + Time(1));
  EXPECT_EQ(link.guard.wish(kNow).sequence, 11U);
  for (const Word before : {10U, 4U}) {
    link.planner.wish().head->sequence = before;  // sent as the next
    link.wish_velocity(9.0F, kNow, kNow + Time(1));
    EXPECT_EQ(link.guard.wish(kNow).vx[0], 1.0F);
  }
  EXPECT_EQ(link.guard.refused(), 2U);
}

TEST(HostilePlanner, ARequestToStopThatIsGarbledStops) {
  Pair link(kRobots);
  link.planner.request_stop(static_cast<StopLevel>(0xffffU));
  static_cast<void>(link.guard.wish(kNow));
  EXPECT_EQ(link.guard.stop(), StopLevel::kEmergencyStop);
}

// Both at once. The writer's garbage is atomic words, as another process's would be to this one.
TEST(HostilePlanner, GarbageWhileTheGuardReads) {
  Pair link(kRobots);
  const std::span<SharedWord> words = all_words(link.planner.segment());
  std::atomic<bool> done{false};
  std::thread mad([&] {
    std::mt19937_64 random(5);
    while (!done) {
      SharedWord& word = words[random() % words.size()];
      word = garbage(random, word);
    }
  });
  std::uint64_t sequence = 0;
  Time now = kNow;
  for (int tick = 0; tick < 20000 && !::testing::Test::HasFatalFailure(); ++tick) {
    now += Time(1'000'000);
    expect_sane(link.guard, now, sequence);
    link.guard.show();
  }
  done = true;
  mad.join();
}

// An honest planner in a thread of its own: the guard never sees half a wish.
TEST(Wish, IsNeverTorn) {
  Pair link(kRobots);
  std::atomic<bool> done{false};
  std::thread planner([&] {
    for (int tick = 1; tick <= 20000; ++tick) {
      std::fill(link.planner.wish().vy.begin(), link.planner.wish().vy.end(), static_cast<float>(tick));
      link.wish_velocity(static_cast<float>(tick), kNow, kNow);
    }
    done = true;
  });
  bool whole = true;
  std::uint64_t sequence = 0;
  while (!done || sequence < 20000) {
    const CommandColumns wish = link.guard.wish(kNow);
    whole = whole && wish.sequence >= sequence;
    sequence = wish.sequence;
    for (std::size_t robot = 0; robot < kRobots; ++robot) {
      whole = whole && wish.vx[robot] == static_cast<float>(sequence) && wish.vy[robot] == wish.vx[robot];
    }
  }
  planner.join();
  EXPECT_TRUE(whole);
}

}  // namespace
}  // namespace mayfly::link::test
