// Sees what a control tick may not do: link tests/reference/tick_traps.cpp, which replaces malloc and the
// locks of pthread for the whole test program, and call trap_system_calls() in the control thread.
#pragma once

#include <cstdint>

namespace mayfly::test {

// Of all armed ticks (core/armed_tick.hpp) of the program so far.
struct TickOffences {
  std::uint64_t allocations = 0;  // malloc, free and their relatives
  std::uint64_t locks = 0;        // pthread's: mutexes, read-write locks, condition variables
  std::uint64_t system_calls = 0;
  int last_system_call = -1;  // its number

  bool any() const { return allocations + locks + system_calls > 0; }
};
TickOffences tick_offences() noexcept;

// Whether the next can be had: it takes Linux's seccomp, and knows x86-64's registers only.
#if defined(__x86_64__)
inline constexpr bool kTrapsSystemCalls = true;
#else
inline constexpr bool kTrapsSystemCalls = false;
#endif

// From now on, and for as long as it lives, each system call of the calling thread is looked at: one in an
// armed tick is counted, whatever comes of it. Only reading a clock and sleeping on it are free. The thread
// must start no threads any more. False where the system refuses.
bool trap_system_calls() noexcept;

}  // namespace mayfly::test
