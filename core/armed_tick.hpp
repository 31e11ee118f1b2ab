// The part of a thread's time in which nothing may be asked of the system but the time: a control tick.
#pragma once

#include <atomic>
#include <cstdint>

namespace mayfly {

// Marks it, from construction to destruction; marks may nest. Whoever sees what is forbidden there (a
// replaced operator new, a trap in a test) asks is_now() and reports; whoever must know that nothing was
// reported (the guard's invariant of no allocation and no blocking call since arming) compares offences()
// with what it was.
class ArmedTick {
 public:
  ArmedTick() noexcept { ++depth; }
  ~ArmedTick() { --depth; }
  ArmedTick(const ArmedTick&) = delete;
  ArmedTick& operator=(const ArmedTick&) = delete;

  // Of the calling thread. Safe in a signal handler and inside malloc.
  static bool is_now() noexcept { return depth > 0; }
  static void report() noexcept { offence_count.fetch_add(1, std::memory_order_relaxed); }
  // Of all threads, since the program began.
  static std::uint64_t offences() noexcept { return offence_count.load(std::memory_order_relaxed); }

 private:
  static constinit inline thread_local int depth = 0;
  static constinit inline std::atomic<std::uint64_t> offence_count{0};
};

}  // namespace mayfly
