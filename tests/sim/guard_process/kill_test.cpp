// The planner is killed or stopped, at any moment: every robot is told to stand still within 50 ms, plus what
// the machine was late by.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <random>

#include "tests/sim/guard_process/two_processes.hpp"

namespace mayfly::test {
namespace {

constexpr double kBound = 50e-3;  // s
// Of the trials. What the guard can't see of its own lateness (it was put off in the middle of a tick) is
// left to the others, which must stop all the same.
constexpr double kWithinBound = 0.95;
constexpr double kGross = 0.5;    // s: whoever needs longer was not stopped by this
constexpr double kPeriod = 5e-3;  // s
constexpr int kKills = 200;
constexpr int kPauses = 40;
constexpr int kAtOnce = 4;  // flights

struct Trial {
  std::unique_ptr<TwoProcesses> flight;
  double phase = 0.0;  // of a tick
  Time killed{0};      // when the signal was to be sent
  Time late{0};        // until it was: this program, too, may have to wait for a processor
};

// Busy, because a phase is shorter than a sleep is exact.
void wait_for(double seconds) {
  const Time until = monotonic_now() + from_seconds(seconds);
  while (monotonic_now() < until) {
  }
}

struct Stopped {
  double after = 0.0;  // s from the kill to the last robot's standing still
  double late = 0.0;   // s, the machine
};

// What the guard does after that (land) takes longer than there is time for in so many trials.
Stopped outcome(Trial& trial) {
  const auto stop = trial.flight->wait_for_stop(trial.killed);
  trial.flight->send_guard(SIGKILL);
  trial.flight->send_planner(SIGKILL);  // where it was only stopped
  EXPECT_EQ(trial.flight->wait().exit_code, 128 + SIGKILL);
  if (!stop) {
    ADD_FAILURE() << "the guard has ended before everybody stood still";
    return {};
  }
  return {to_seconds(stop->still - trial.killed), to_seconds(stop->late + trial.late)};
}

void print(const char* what, std::vector<Stopped> all) {
  const auto of = [&](auto value, double share) {
    std::vector<double> sorted;
    for (const Stopped& one : all) {
      sorted.push_back(1e3 * value(one));
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  const auto after = [](const Stopped& one) { return one.after; };
  const auto late = [](const Stopped& one) { return one.late; };
  std::printf(
      "still after the %s: p50 %.1f, p99 %.1f, max %.1f ms; the machine's lateness meanwhile: p50 "
      "%.1f, p99 %.1f, max %.1f ms; %zu trials\n",
      what, of(after, 0.5), of(after, 0.99), of(after, 1.0), of(late, 0.5), of(late, 0.99), of(late, 1.0),
      all.size());
}

// What `signal` does to the planner at so many phases of its tick.
void ill_treat(int signal, int trials, const char* what) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> phases(0.0, kPeriod);
  std::vector<Stopped> all;
  int within = 0;
  for (int done = 0; done < trials; done += kAtOnce) {
    std::vector<Trial> batch(kAtOnce);
    for (Trial& trial : batch) {
      trial.flight = std::make_unique<TwoProcesses>();
      trial.phase = phases(random);
    }
    for (Trial& trial : batch) {
      // Long enough to be on their way.
      ASSERT_TRUE(trial.flight->fly() && trial.flight->wait_for_beats(40));
      wait_for(trial.phase);
      trial.killed = monotonic_now();
      trial.flight->send_planner(signal);
      trial.late = monotonic_now() - trial.killed;
    }
    for (Trial& trial : batch) {
      all.push_back(outcome(trial));
      EXPECT_LE(all.back().after, kGross + all.back().late) << "trial " << all.size();
      within += all.back().after <= kBound + all.back().late ? 1 : 0;
    }
  }
  print(what, all);
  std::printf("within 50 ms and the machine's lateness: %d of %d\n", within, trials);
  EXPECT_GE(within, kWithinBound * trials);
}

TEST(Kill, ThePlannerDiesAtAnyPhaseOfATickAndEveryRobotStandsStill) {
  ill_treat(SIGKILL, kKills, "kill");
}

// Nothing dies: it is the wish that runs out.
TEST(Kill, ThePlannerStopsAtAnyPhaseOfATickAndEveryRobotStandsStill) {
  ill_treat(SIGSTOP, kPauses, "stop");
}

}  // namespace
}  // namespace mayfly::test
