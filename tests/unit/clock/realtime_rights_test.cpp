#include "controller/clock/realtime_rights.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace mayfly {
namespace {

// In a process of its own, so that nothing of it stays with the other tests. The exit code is the number of
// the check that failed.
template <class Checks>
int failed_check_in_child(Checks checks) {
  const pid_t child = fork();
  if (child == 0) {
    _exit(checks());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
}

void become_ordinary_user() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_RTPRIO, &none);
  setrlimit(RLIMIT_MEMLOCK, &none);
  if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) {
    _exit(254);
  }
}

TEST(RealtimeRights, AnOrdinaryUserIsToldWhatWasRefusedAndHowToGetIt) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer answers mlockall itself, with yes";
#endif
  const int failed = failed_check_in_child([] {
    become_ordinary_user();
    const RealtimeRights rights = request_realtime(80);
    if (rights.complete() || rights.refused.size() != 2) return 1;
    if (rights.priority != 0 || rights.memory_locked || !rights.sharp_timers) return 2;
    if (rights.refused[0].right != "SCHED_FIFO priority 80") return 3;
    if (rights.refused[0].remedy.find("rtprio 80") == std::string::npos) return 4;
    if (rights.refused[1].remedy.find("memlock unlimited") == std::string::npos) return 5;
    for (const auto& refusal : rights.refused) {
      if (refusal.reason.empty()) return 6;
    }
    return 0;
  });
  EXPECT_EQ(failed, 0);
}

// Whatever the machine grants, the report says what the thread really has.
TEST(RealtimeRights, TheReportIsWhatTheSystemSays) {
  const int failed = failed_check_in_child([] {
    const RealtimeRights rights = request_realtime(42);
    sched_param param{};
    sched_getparam(0, &param);
    if (param.sched_priority != rights.priority) return 1;
    const bool fifo = (sched_getscheduler(0) & ~SCHED_RESET_ON_FORK) == SCHED_FIFO;
    if (fifo != (rights.priority == 42)) return 2;
    if (rights.sharp_timers && !fifo && prctl(PR_GET_TIMERSLACK) != 1) return 3;
    int child_policy = -1;
    std::thread([&] { child_policy = sched_getscheduler(0); }).join();
    if (child_policy != SCHED_OTHER) return 4;
    drop_realtime();
    if (sched_getscheduler(0) != SCHED_OTHER) return 5;
    return 0;
  });
  EXPECT_EQ(failed, 0);
}

TEST(RealtimeRights, AThreadKeepsToTheLastProcessorAndGetsAllBack) {
  const int failed = failed_check_in_child([] {
    const std::vector<int> all = allowed_cpus();
    if (all.empty()) return 1;
    if (!pin_thread(all.front())) return 2;
    if (allowed_cpus() != std::vector<int>{all.front()}) return 3;
    if (control_cpu() != -1) return 4;  // nothing to choose
    if (!allow_cpus(all) || allowed_cpus() != all) return 5;
    if (control_cpu() != (all.size() > 1 ? all.back() : -1)) return 6;
    if (pin_thread(-1) || pin_thread(1 << 20) || allow_cpus({})) return 7;
    return allowed_cpus() == all ? 0 : 8;
  });
  EXPECT_EQ(failed, 0);
}

TEST(RealtimeRights, APriorityOutsideTheRangeIsBroughtIntoIt) {
  const int failed = failed_check_in_child([] {
    become_ordinary_user();
    const RealtimeRights high = request_realtime(1000);
    const RealtimeRights low = request_realtime(-7);
    if (high.refused.empty() || high.refused[0].right != "SCHED_FIFO priority 99") return 1;
    if (low.refused.empty() || low.refused[0].right != "SCHED_FIFO priority 1") return 2;
    return 0;
  });
  EXPECT_EQ(failed, 0);
}

}  // namespace
}  // namespace mayfly
