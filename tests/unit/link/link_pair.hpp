// Both ends of one link in this process.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "controller/link/guard_end.hpp"
#include "controller/link/planner_end.hpp"

namespace mayfly::link::test {

inline std::vector<RobotInfo> some_robots(std::size_t count) {
  std::vector<RobotInfo> robots;
  for (std::size_t robot = 0; robot < count; ++robot) {
    robots.push_back({"fly_" + std::to_string(robot), "sim"});
  }
  return robots;
}

inline Segment same_segment(const Segment& segment, std::size_t robots) {
  auto other =
      Segment::attach(::fcntl(segment.descriptor(), F_DUPFD_CLOEXEC, 0), roster_of(some_robots(robots)));
  EXPECT_TRUE(other) << (other ? "" : to_string(other.error()));
  return std::move(*other);
}

struct Pair {
  static constexpr Time kMostAge{50'000'000};

  explicit Pair(std::size_t robots)
      : planner(*PlannerEnd::make(*Segment::create(roster_of(some_robots(robots)), Time(1)))),
        guard(*GuardEnd::make(same_segment(planner.segment(), robots), kMostAge)) {}

  void wish_velocity(float vx, Time now, Time deadline) {
    std::fill(planner.wish().kind.begin(), planner.wish().kind.end(),
              static_cast<std::uint8_t>(CommandKind::kVelocity));
    std::fill(planner.wish().vx.begin(), planner.wish().vx.end(), vx);
    planner.send_wish(now, deadline);
  }

  PlannerEnd planner;
  GuardEnd guard;
};

}  // namespace mayfly::link::test
