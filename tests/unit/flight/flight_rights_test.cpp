#include "controller/flight/flight_rights.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mayfly {
namespace {

// In a process of its own that may do nothing. The exit code is the number of the check that failed.
template <class Checks>
int failed_check_as_ordinary_user(Checks checks) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    setrlimit(RLIMIT_MEMLOCK, &none);
    const bool ordinary = geteuid() != 0 || (setgid(65534) == 0 && setuid(65534) == 0);
    _exit(ordinary ? checks() : 254);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
}

TEST(FlightRights, EnforcedAndRefusedNothingFliesAndTheMessageNamesWhatIsMissing) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer answers mlockall itself, with yes";
#endif
  const int failed = failed_check_as_ordinary_user([] {
    const auto rights = FlightRights::take(RealtimePolicy::kEnforce);
    if (rights) return 1;
    const std::string text = to_string(rights.error());
    if (rights.error().cause != Cause::kEnvironment) return 2;
    for (const char* part : {"control.realtime", "SCHED_FIFO priority 80 (", "rtprio 80", "locked memory (",
                             "memlock unlimited", "'ignore'"}) {
      if (text.find(part) == std::string::npos) return 3;
    }
    return sched_getscheduler(0) == SCHED_OTHER ? 0 : 4;
  });
  EXPECT_EQ(failed, 0);
}

TEST(FlightRights, IgnoredWhatWasRefusedIsTold) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer answers mlockall itself, with yes";
#endif
  const int failed = failed_check_as_ordinary_user([] {
    const auto rights = FlightRights::take(RealtimePolicy::kIgnore);
    if (!rights) return 1;
    if (rights->granted().complete() || rights->missing().size() != 2) return 2;
    return rights->missing()[1].starts_with("locked memory (") ? 0 : 3;
  });
  EXPECT_EQ(failed, 0);
}

// Whatever this machine grants: it is held as long as the flight, and no longer.
TEST(FlightRights, AreGivenBack) {
  {
    auto first = FlightRights::take(RealtimePolicy::kIgnore);
    ASSERT_TRUE(first);
    const FlightRights held(std::move(*first));
    EXPECT_EQ(sched_getscheduler(0) != SCHED_OTHER, held.granted().priority > 0);
    EXPECT_EQ(held.missing().empty(), held.granted().complete());
  }
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

}  // namespace
}  // namespace mayfly
