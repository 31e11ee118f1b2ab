#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/time.h>

#include <atomic>

#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/virtual_clock.hpp"

namespace mayfly {
namespace {

using namespace std::chrono_literals;

TEST(VirtualClock, StartsAtZeroAndOnlyMovesInSleep) {
  VirtualClock clock;
  EXPECT_TRUE(clock.is_virtual());
  EXPECT_EQ(clock.now(), 0ns);
  EXPECT_EQ(clock.now(), 0ns);
  clock.sleep_until(10ms);
  EXPECT_EQ(clock.now(), 10ms);
}

TEST(VirtualClock, NeverGoesBack) {
  VirtualClock clock;
  clock.sleep_until(10ms);
  clock.sleep_until(3ms);
  clock.sleep_until(-1s);
  EXPECT_EQ(clock.now(), 10ms);
}

TEST(VirtualClock, HoldsCenturiesOfNanoseconds) {
  VirtualClock clock;
  clock.sleep_until(200 * 365 * 24h);
  EXPECT_EQ(clock.now(), 200 * 365 * 24h);
}

TEST(RealtimeClock, CountsFromItsConstructionAndNeverGoesBack) {
  const RealtimeClock clock;
  EXPECT_FALSE(clock.is_virtual());
  Time last = clock.now();
  EXPECT_GE(last, 0ns);
  for (int i = 0; i < 1000; ++i) {
    const Time now = clock.now();
    ASSERT_GE(now, last);
    last = now;
  }
}

TEST(RealtimeClock, SleepsToTheDeadlineOrLonger) {
  RealtimeClock clock;
  const Time deadline = clock.now() + 2ms;
  clock.sleep_until(deadline);
  EXPECT_GE(clock.now(), deadline);
}

TEST(RealtimeClock, ReturnsAtOnceFromThePast) {
  RealtimeClock clock;
  clock.sleep_until(0ns);
  clock.sleep_until(-5s);
  clock.sleep_until(Time::min() / 2);  // before the machine was started
  SUCCEED();
}

std::atomic<int> g_signals{0};

// A timer that interrupts every 200 µs must not wake a sleep of 5 ms.
TEST(RealtimeClock, SignalsDoNotCutASleepShort) {
  struct sigaction action {};
  struct sigaction before {};
  action.sa_handler = [](int) { ++g_signals; };
  ASSERT_EQ(sigaction(SIGALRM, &action, &before), 0);
  const itimerval every{{0, 200}, {0, 200}};
  ASSERT_EQ(setitimer(ITIMER_REAL, &every, nullptr), 0);
  RealtimeClock clock;
  const Time deadline = clock.now() + 5ms;
  clock.sleep_until(deadline);
  const Time woken = clock.now();
  const itimerval off{};
  setitimer(ITIMER_REAL, &off, nullptr);
  sigaction(SIGALRM, &before, nullptr);
  EXPECT_GT(g_signals.load(), 0);
  EXPECT_GE(woken, deadline);
}

}  // namespace
}  // namespace mayfly
