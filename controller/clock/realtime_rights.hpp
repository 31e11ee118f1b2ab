// What the operating system grants a loop that must be punctual.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mayfly {

struct RealtimeRights {
  // One right that was refused: what, why, and how to get it. Written for a person.
  struct Refusal {
    std::string right;   // "SCHED_FIFO priority 80"
    std::string reason;  // "Operation not permitted"
    std::string remedy;  // "add '@mayfly - rtprio 80' to …"
  };

  int priority = 0;            // SCHED_FIFO priority of the calling thread; 0 where it keeps its ordinary one
  bool memory_locked = false;  // what was mapped at the time of the call cannot be paged out
  bool sharp_timers =
      false;  // timer slack of 1 ns, where an ordinary thread has 50 µs (moot under SCHED_FIFO)
  std::vector<Refusal> refused;

  bool complete() const { return refused.empty(); }
};

// Asks for SCHED_FIFO at `priority` (1…99) and sharp timers for the calling thread, and locks the process's
// memory. Call it in the thread that will run the loop, after everything is allocated: memory mapped later is
// not locked, because with a small limit it would make allocations fail in the middle of a run. Threads and
// processes started by this one get their ordinary priority back. Never fails: a right that is refused is
// reported, and the run goes on without it.
RealtimeRights request_realtime(int priority);

// Gives the calling thread its ordinary priority and the process its unlocked memory back.
void drop_realtime() noexcept;

// Parts of the above, for a thread that needs no more. Each: whether it was granted; errno tells why not.
bool request_priority(int priority) noexcept;
bool sharpen_timers() noexcept;

// The processors that the calling thread may run on, ascending.
std::vector<int> allowed_cpus();
// Which of them a control loop keeps to: the last, because interrupts and start-up work favour the first; -1
// where there is but one, and nothing to choose.
int control_cpu();
bool pin_thread(int cpu) noexcept;
// Lets the calling thread run on any of `cpus`. Needs no right within what allowed_cpus() told.
bool allow_cpus(const std::vector<int>& cpus) noexcept;

}  // namespace mayfly
