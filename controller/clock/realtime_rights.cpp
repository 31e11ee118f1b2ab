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

int in_range(int priority) noexcept {
  return std::clamp(priority, sched_get_priority_min(SCHED_FIFO), sched_get_priority_max(SCHED_FIFO));
}

void request_priority(int priority, RealtimeRights& rights) {
  const int wanted = in_range(priority);
  if (mayfly::request_priority(wanted)) {
    rights.priority = wanted;
    return;
  }
  const int error = errno;
  const std::string level = std::to_string(wanted);
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
  if (sharpen_timers()) {
    rights.sharp_timers = true;
    return;
  }
  const int error = errno;
  rights.refused.push_back({"timer slack of 1 ns", std::generic_category().message(error),
                            "a kernel with PR_SET_TIMERSLACK (Linux 2.6.28 or later)"});
}

}  // namespace

bool request_priority(int priority) noexcept {
  sched_param param{};
  param.sched_priority = in_range(priority);
  return sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &param) == 0;
}

bool sharpen_timers() noexcept {
  return prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) == 0;
}

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

std::vector<int> allowed_cpus() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> cpus;
  if (sched_getaffinity(0, sizeof(set), &set) != 0) {
    return cpus;
  }
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &set)) {
      cpus.push_back(cpu);
    }
  }
  return cpus;
}

int control_cpu() {
  const std::vector<int> cpus = allowed_cpus();
  return cpus.size() > 1 ? cpus.back() : -1;
}

bool allow_cpus(const std::vector<int>& cpus) noexcept {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int cpu : cpus) {
    if (cpu >= 0 && cpu < CPU_SETSIZE) {
      CPU_SET(cpu, &set);
    }
  }
  return sched_setaffinity(0, sizeof(set), &set) == 0;
}

bool pin_thread(int cpu) noexcept {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (cpu < 0 || cpu >= CPU_SETSIZE) {
    return false;
  }
  CPU_SET(cpu, &set);
  return sched_setaffinity(0, sizeof(set), &set) == 0;
}

}  // namespace mayfly
