// The program's own watch over its ticks.
#include <gtest/gtest.h>

#include <cstdint>
#include <new>

#include "core/armed_tick.hpp"

namespace mayfly {
namespace {

// Kept where the compiler cannot know that nobody looks.
void* volatile g_kept = nullptr;

TEST(TickAllocations, CountWithinATickAndNowhereElse) {
  const std::uint64_t before = ArmedTick::offences();
  g_kept = ::operator new(24);
  ::operator delete(g_kept);
  EXPECT_EQ(ArmedTick::offences(), before);
  {
    const ArmedTick armed;
    g_kept = ::operator new(24);
  }
  ::operator delete(g_kept);
  EXPECT_EQ(ArmedTick::offences(), before + 1);
  g_kept = ::operator new(0);
  ::operator delete(g_kept);
  EXPECT_EQ(ArmedTick::offences(), before + 1);
}

TEST(TickAllocations, EveryFormIsWatchedAndAligned) {
  const std::uint64_t before = ArmedTick::offences();
  {
    const ArmedTick armed;
    g_kept = ::operator new (100, std::align_val_t{64});
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(g_kept) % 64, 0U);
    ::operator delete (g_kept, std::align_val_t{64});
    g_kept = ::operator new[](3, std::nothrow);
    ::operator delete[](g_kept);
  }
  EXPECT_EQ(ArmedTick::offences(), before + 2);
}

}  // namespace
}  // namespace mayfly
