#include "controller/estimator/estimator_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

Result<void> refuse(std::string what, std::string found, std::string wanted) {
  Error error;
  error.message = "estimator: " + std::move(what);
  error.found = std::move(found);
  error.wanted = std::move(wanted);
  return fail(std::move(error));
}

bool is_size(float value) {
  return std::isfinite(value) && value >= 0.0F;
}

Result<void> check_robot(std::size_t robot, const EstimatorLimits& limits) {
  if (!(limits.speed > 0.0F)) {
    return refuse(fmt::format("speed of robot {}", robot), fmt::format("{}", limits.speed), "above 0 m/s");
  }
  if (!(limits.acceleration > 0.0F) || std::isinf(limits.acceleration)) {
    return refuse(fmt::format("acceleration of robot {}", robot), fmt::format("{}", limits.acceleration),
                  "above 0 m/s², finite");
  }
  if (!is_size(limits.response_time)) {
    return refuse(fmt::format("response time of robot {}", robot), fmt::format("{}", limits.response_time),
                  "0 s or more, finite");
  }
  return {};
}

Result<void> check_source(const EstimatorSource& source) {
  if (!is_size(source.pose_noise) || !is_size(source.velocity_noise) || !is_size(source.resolution)) {
    return refuse("noise and resolution of source '" + source.name + "'",
                  fmt::format("{}, {} and {}", source.pose_noise, source.velocity_noise, source.resolution),
                  "0 or more, finite");
  }
  return {};
}

Result<void> check_times(const EstimatorConfig& config) {
  if (config.period <= Time{0}) {
    return refuse("period of the control tick", fmt::format("{} ns", config.period.count()), "more than 0");
  }
  if (config.pose_period < Time{0} || config.most_age < Time{0} || config.most_ahead < Time{0}) {
    return refuse("pose period, age limit and limit ahead",
                  fmt::format("{}, {} and {} ns", config.pose_period.count(), config.most_age.count(),
                              config.most_ahead.count()),
                  "0 or more");
  }
  if (config.frozen_samples < 2) {
    return refuse("equal samples of a frozen pose", fmt::format("{}", config.frozen_samples), "2 or more");
  }
  return {};
}

Result<void> check_sources(const EstimatorConfig& config) {
  const std::vector<EstimatorSource>& sources = config.sources;
  if (sources.empty() || sources.size() > EstimatorConfig::kMostSources) {
    return refuse("sources", fmt::format("{}", sources.size()),
                  fmt::format("1 to {}", EstimatorConfig::kMostSources));
  }
  for (const EstimatorSource& source : sources) {
    if (auto good = check_source(source); !good) {
      return good;
    }
  }
  const auto measures = [](const EstimatorSource& source) { return source.takes_pose; };
  if (std::none_of(sources.begin(), sources.end(), measures)) {
    return refuse("sources", "none that measures poses", "at least one");
  }
  return {};
}

}  // namespace

Result<void> check_and_fill(EstimatorConfig& config) {
  if (auto good = check_times(config); !good) {
    return good;
  }
  if (auto good = check_sources(config); !good) {
    return good;
  }
  for (std::size_t robot = 0; robot < config.robots.size(); ++robot) {
    if (auto good = check_robot(robot, config.robots[robot]); !good) {
      return good;
    }
  }
  const auto fill = [](Time& value, Time by) { value = value == Time{0} ? by : value; };
  fill(config.pose_period, config.period);
  fill(config.most_age, 3 * config.pose_period + config.period);
  fill(config.most_ahead, config.period);
  return {};
}

}  // namespace mayfly
