// That the traps catch what they are for, and nothing else.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <mutex>
#include <thread>

#include "controller/clock/virtual_clock.hpp"
#include "controller/executor/executor.hpp"
#include "core/armed_tick.hpp"
#include "tests/reference/tick_traps.hpp"

namespace mayfly::test {
namespace {

using namespace std::chrono_literals;

const std::atomic<bool> kNeverStop{false};

// What `deed` adds in the third of five ticks, in a thread whose system calls are trapped.
TickOffences offences_of(const std::function<void()>& deed, bool trap = false) {
  const TickOffences before = tick_offences();
  std::thread([&] {
    if (trap) {
      EXPECT_TRUE(trap_system_calls());
    }
    VirtualClock clock;
    Executor executor(clock);
    EXPECT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo& tick) noexcept {
      if (tick.release == 2) {
        deed();
      }
    }));
    EXPECT_TRUE(executor.run(50ms, kNeverStop));
  }).join();
  TickOffences after = tick_offences();
  after.allocations -= before.allocations;
  after.locks -= before.locks;
  after.system_calls -= before.system_calls;
  return after;
}

volatile void* g_kept = nullptr;

TEST(TickTraps, AnEmptyTickIsClean) {
  EXPECT_FALSE(offences_of([] {}).any());
}

TEST(TickTraps, APlantedAllocationIsCaught) {
  const std::uint64_t before = ArmedTick::offences();
  EXPECT_EQ(offences_of([] { g_kept = std::malloc(17); }).allocations, 1U);
  std::free(const_cast<void*>(g_kept));
  EXPECT_EQ(offences_of([] { g_kept = ::operator new(17); }).allocations, 1U);
  EXPECT_EQ(offences_of([] { ::operator delete(const_cast<void*>(g_kept)); }).allocations, 1U);
  EXPECT_EQ(ArmedTick::offences() - before, 3U);  // what the guard looks at
}

TEST(TickTraps, APlantedLockIsCaught) {
  std::mutex mutex;
  EXPECT_EQ(offences_of([&] { const std::lock_guard lock(mutex); }).locks, 1U);
  const std::lock_guard outside(mutex);
  EXPECT_FALSE(offences_of([] {}).any());
}

TEST(TickTraps, APlantedSystemCallIsCaughtAndMade) {
  if (!kTrapsSystemCalls) {
    GTEST_SKIP() << "no traps for this processor";
  }
  pid_t parent = 0;
  const TickOffences seen = offences_of([&] { parent = getppid(); }, true);
  EXPECT_EQ(seen.system_calls, 1U);
  EXPECT_FALSE(seen.allocations + seen.locks > 0);
  EXPECT_EQ(parent, getppid());
}

TEST(TickTraps, TheClockIsFree) {
  if (!kTrapsSystemCalls) {
    GTEST_SKIP() << "no traps for this processor";
  }
  EXPECT_FALSE(offences_of([] { (void)std::chrono::steady_clock::now(); }, true).any());
}

}  // namespace
}  // namespace mayfly::test
