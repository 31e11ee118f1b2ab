#include "sim_hal/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_set>
#include <vector>

#include "sim_hal/step_clock.hpp"

namespace mayfly::sim_hal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kLongestDelay = 10.0F;  // s

tl::unexpected<Error> refuse(const SimHalConfig& config, const std::string& what) {
  return fail(Cause::kCaller, config.name + ": " + what);
}

struct Range {
  const char* what;
  double value, least, most;
  bool holds() const { return value >= least && value <= most; }  // false for NaN
};

Result<void> check_numbers(const SimHalConfig& c) {
  const Faults& f = c.faults;
  const std::vector<Range> ranges{
      {"the plant rate, Hz,", c.rate_hz, StepClock::kSlowestHz, StepClock::kFastestHz},
      {"the time constant, s,", static_cast<double>(c.time_constant), 0.0, 1e6},
      {"pose noise, m,", static_cast<double>(f.pose_noise), 0.0, 1e6},
      {"delay, s,", static_cast<double>(f.delay), 0.0, static_cast<double>(kLongestDelay)},
      {"dropout", static_cast<double>(f.dropout), 0.0, 1.0},
      {"freeze", static_cast<double>(f.freeze), 0.0, 1.0},
      {"freeze time, s,", static_cast<double>(f.freeze_time), 0.0, 60.0},
      {"nan", static_cast<double>(f.nan), 0.0, 1.0},
  };
  for (const Range& range : ranges) {
    if (!range.holds()) {
      Error error{Cause::kCaller, c.name + ": " + range.what + " is out of range"};
      error.found = std::to_string(range.value);
      error.wanted = std::to_string(range.least) + " to " + std::to_string(range.most);
      return fail(std::move(error));
    }
  }
  return {};
}

Result<void> check_limits(const SimHalConfig& c, const char* what, const std::vector<float>& limits) {
  if (limits.size() > 1 && limits.size() != c.positions.size()) {
    return refuse(c, std::string(what) + ": give none, one, or one a robot");
  }
  const bool good = std::all_of(limits.begin(), limits.end(), [](float limit) {
    return Range{"", static_cast<double>(limit), 0.0, kInfinity}.holds();
  });
  return good ? Result<void>{} : refuse(c, std::string(what) + ": a limit is negative or not a number");
}

Result<void> check_robots(const SimHalConfig& c) {
  if (c.robot_names.size() != c.positions.size()) {
    return refuse(c, std::to_string(c.robot_names.size()) + " robot names, but " +
                         std::to_string(c.positions.size()) + " positions");
  }
  std::unordered_set<std::string> names;
  for (std::size_t robot = 0; robot < c.positions.size(); ++robot) {
    const glm::vec3 at = c.positions[robot];
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) {
      return refuse(c, "robot '" + c.robot_names[robot] + "' starts nowhere: its position is not finite");
    }
    if (!names.insert(c.robot_names[robot]).second) {
      return refuse(c, "two robots are called '" + c.robot_names[robot] + "'");
    }
  }
  return {};
}

}  // namespace

Result<void> check(const SimHalConfig& config) {
  if (!config.lock_step && config.clock == nullptr) {
    return refuse(config, "needs a clock where it does not run in lock step");
  }
  if (auto checked = check_numbers(config); !checked) {
    return checked;
  }
  if (auto checked = check_limits(config, "maximum speed", config.max_speed); !checked) {
    return checked;
  }
  if (auto checked = check_limits(config, "maximum acceleration", config.max_acceleration); !checked) {
    return checked;
  }
  return check_robots(config);
}

}  // namespace mayfly::sim_hal
