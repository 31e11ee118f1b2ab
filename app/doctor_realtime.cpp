#include "app/doctor_realtime.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>

#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/realtime_rights.hpp"

namespace mayfly::app {
namespace {

constexpr int kPriority = 80;
constexpr int kReleases = 150;
constexpr Time kPeriod = std::chrono::milliseconds(2);
// A tenth of a 100 Hz control period: later than that, and timing is the machine's, not ours.
constexpr double kAcceptableUs = 1000.0;

std::string limit_text(int resource, double unit) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) {
    return "unknown";
  }
  return limit.rlim_cur == RLIM_INFINITY ? "unlimited"
                                         : fmt::format("{:.0f}", static_cast<double>(limit.rlim_cur) / unit);
}

std::vector<double> measure_lateness_us() {
  RealtimeClock clock;
  std::vector<double> late;
  late.reserve(kReleases);
  const Time start = clock.now();
  for (int i = 1; i <= kReleases; ++i) {
    const Time due = start + i * kPeriod;
    clock.sleep_until(due);
    late.push_back(1e6 * to_seconds(clock.now() - due));
  }
  std::sort(late.begin(), late.end());
  return late;
}

Finding timer_finding() {
  const auto late = measure_lateness_us();
  const double median = late[late.size() / 2];
  const double high = late[late.size() * 99 / 100];
  return {high < kAcceptableUs, "timers",
          fmt::format("late by {:.0f} µs (median), {:.0f} µs (99 %), {:.0f} µs at worst of {}", median, high,
                      late.back(), late.size()),
          high < kAcceptableUs ? ""
                               : "this machine wakes programs late: use one that is not shared, or a kernel "
                                 "with PREEMPT_RT (linux-image-rt-amd64)"};
}

Finding processor_finding() {
  const int cpu = control_cpu();
  return {true, "processors for it",
          cpu < 0 ? "one, which control shares with everybody"
                  : fmt::format("control keeps to number {} of {}", cpu, allowed_cpus().size()),
          ""};
}

}  // namespace

std::vector<Finding> look_at_realtime() {
  std::vector<Finding> findings;
  const RealtimeRights rights = request_realtime(kPriority);
  findings.push_back(timer_finding());
  drop_realtime();
  const auto remedy_of = [&](std::string_view part) {
    for (const auto& refusal : rights.refused) {
      if (refusal.right.find(part) != std::string::npos) {
        return refusal.reason + "; " + refusal.remedy;
      }
    }
    return std::string();
  };
  findings.push_back({rights.priority > 0, "real-time priority",
                      rights.priority > 0 ? fmt::format("SCHED_FIFO {} granted", rights.priority)
                                          : fmt::format("SCHED_FIFO {} refused (RLIMIT_RTPRIO {})", kPriority,
                                                        limit_text(RLIMIT_RTPRIO, 1.0)),
                      remedy_of("SCHED_FIFO")});
  findings.push_back({rights.memory_locked, "locked memory",
                      fmt::format("{} (RLIMIT_MEMLOCK {} KiB)", rights.memory_locked ? "granted" : "refused",
                                  limit_text(RLIMIT_MEMLOCK, 1024.0)),
                      remedy_of("memory")});
  findings.push_back(processor_finding());
  std::ifstream realtime("/sys/kernel/realtime");
  int is_realtime = 0;
  realtime >> is_realtime;
  findings.push_back(
      {true, "kernel", is_realtime == 1 ? "PREEMPT_RT" : "not PREEMPT_RT: good enough for a simulation", ""});
  return findings;
}

}  // namespace mayfly::app
