// The planner is killed, at any moment: every robot is told to stand still within 50 ms, plus what the
// machine was late by.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <random>

#include "tests/sim/guard_process/two_processes.hpp"

namespace mayfly::test {
namespace {

constexpr double kBound = 50e-3;  // s
constexpr double kPeriod = 5e-3;  // s
constexpr int kTrials = 200;
constexpr int kAtOnce = 4;  // flights

struct Trial {
  std::unique_ptr<TwoProcesses> flight;
  double phase = 0.0;  // of a tick
  Time killed{0};
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
  EXPECT_EQ(trial.flight->wait().exit_code, 128 + SIGKILL);
  if (!stop) {
    ADD_FAILURE() << "the guard has ended before everybody stood still";
    return {};
  }
  return {to_seconds(stop->still - trial.killed), to_seconds(stop->late)};
}

void print(std::vector<Stopped> all) {
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
      "still after the kill: p50 %.1f, p99 %.1f, max %.1f ms; the machine's lateness meanwhile: p50 "
      "%.1f, p99 %.1f, max %.1f ms; %zu trials\n",
      of(after, 0.5), of(after, 0.99), of(after, 1.0), of(late, 0.5), of(late, 0.99), of(late, 1.0),
      all.size());
}

TEST(Kill, ThePlannerDiesAtAnyPhaseOfATickAndEveryRobotStandsStill) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> phases(0.0, kPeriod);
  std::vector<Stopped> all;
  for (int done = 0; done < kTrials; done += kAtOnce) {
    std::vector<Trial> trials(kAtOnce);
    for (Trial& trial : trials) {
      trial.flight = std::make_unique<TwoProcesses>();
      trial.phase = phases(random);
    }
    for (Trial& trial : trials) {
      // Long enough to be on their way.
      ASSERT_TRUE(trial.flight->fly() && trial.flight->wait_for_beats(40));
      wait_for(trial.phase);
      trial.killed = monotonic_now();
      trial.flight->send_planner(SIGKILL);
    }
    for (Trial& trial : trials) {
      all.push_back(outcome(trial));
      EXPECT_LE(all.back().after, kBound + all.back().late) << "trial " << all.size();
    }
  }
  print(all);
}

}  // namespace
}  // namespace mayfly::test
