#include "controller/clock/realtime_rights.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace mayfly {
namespace {

constexpr const char* kLimitsFile = "/etc/security/limits.d/mayfly.conf";
constexpr std::size_t kLoopStackBytes = 256 * 1024;  // more than any tick uses

// A locked stack that grows past RLIMIT_MEMLOCK is a crash, so it grows before it is locked.
void touch_stack() noexcept {
  std::array<std::byte, kLoopStackBytes> pages{};
  volatile std::byte* const first = pages.data();
  for (std::size_t offset = 0; offset < pages.size(); offset += 4096) {
    first[offset] = std::byte{0};
  }
}

std::string limits_line(const char* item, const std::string& value) {
  return std::string("add '<user> - ") + item + ' ' + value + "' to " + kLimitsFile + " and log in again";
}

void request_priority(int priority, RealtimeRights& rights) {
  const int lowest = sched_get_priority_min(SCHED_FIFO);
  const int highest = sched_get_priority_max(SCHED_FIFO);
  sched_param param{};
  param.sched_priority = std::clamp(priority, lowest, highest);
  if (sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &param) == 0) {
    rights.priority = param.sched_priority;
    return;
  }
  const int error = errno;
  const std::string level = std::to_string(param.sched_priority);
  rights.refused.push_back({"SCHED_FIFO priority " + level, std::generic_category().message(error),
                            limits_line("rtprio", level) + ", or grant CAP_SYS_NICE"});
}

void request_locked_memory(RealtimeRights& rights) {
  touch_stack();
  if (mlockall(MCL_CURRENT) == 0) {
    rights.memory_locked = true;
    return;
  }
  const int error = errno;
  rights.refused.push_back({"locked memory", std::generic_category().message(error),
                            limits_line("memlock", "unlimited") + ", or grant CAP_IPC_LOCK"});
}

void request_sharp_timers(RealtimeRights& rights) {
  if (prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) == 0) {
    rights.sharp_timers = true;
    return;
  }
  const int error = errno;
  rights.refused.push_back({"timer slack of 1 ns", std::generic_category().message(error),
                            "a kernel with PR_SET_TIMERSLACK (Linux 2.6.28 or later)"});
}

}  // namespace

RealtimeRights request_realtime(int priority) {
  RealtimeRights rights;
  request_sharp_timers(rights);
  request_priority(priority, rights);
  request_locked_memory(rights);
  return rights;
}

void drop_realtime() noexcept {
  const sched_param param{};
  sched_setscheduler(0, SCHED_OTHER, &param);
  prctl(PR_SET_TIMERSLACK, 0UL, 0UL, 0UL, 0UL);  // 0: the thread's default
  munlockall();
}

}  // namespace mayfly
