// How a guard is made: what its parts are told of its configuration.
#include <algorithm>
#include <string>
#include <utility>

#include "controller/guard/guard.hpp"

namespace mayfly {
namespace {

// m above the lowest place that a robot can be brought to, where landing is left to its firmware.
constexpr float kLandingHeight = 0.25F;

std::size_t robots_of(const GovernorConfig& config) {
  return config.groups.empty() ? 0 : config.groups.back().first + config.groups.back().count;
}

std::vector<float> speeds_of(const GovernorConfig& config) {
  std::vector<float> speeds;
  for (const GovernorGroup& group : config.groups) {
    speeds.insert(speeds.end(), group.count, group.limits.speed);
  }
  return speeds;
}

std::vector<Reactions::Robot> watched(const GuardConfig& config, std::span<const RobotInfo> robots) {
  std::vector<std::string> links;
  std::vector<Reactions::Robot> all;
  for (const RobotInfo& info : robots) {
    const auto link = std::find(links.begin(), links.end(), info.link);
    all.push_back({static_cast<std::uint32_t>(link - links.begin()), true});
    if (link == links.end()) {
      links.push_back(info.link);
    }
  }
  for (const GovernorGroup& group : config.governor.groups) {
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      all[i].watched = group.enabled;
    }
  }
  return all;
}

Orders::Config orders_config(const GuardConfig& config) {
  Orders::Config orders;
  orders.robots = robots_of(config.governor);
  orders.descent = config.descent;
  orders.homing = config.homing;
  for (const GovernorGroup& group : config.governor.groups) {
    orders.floor.insert(
        orders.floor.end(), group.count,
        config.governor.fence.min.z + group.limits.radius + group.limits.tube + kLandingHeight);
  }
  return orders;
}

MonitorConfig monitor_config(const GuardConfig& config) {
  return {config.period,         config.command_life,         config.tick_budget,
          config.governor.fence, config.governor.half_spaces, config.governor.groups,
          config.hooks};
}

// Nothing is promised of robots that are not governed: no tape is kept of them.
std::size_t taped(const GuardConfig& config) {
  const auto& groups = config.governor.groups;
  const bool any =
      std::any_of(groups.begin(), groups.end(), [](const GovernorGroup& g) { return g.enabled; });
  return any ? robots_of(config.governor) : 0;
}

Result<void> refuse(std::string message, std::string found, std::string wanted) {
  return fail({.message = std::move(message), .found = std::move(found), .wanted = std::move(wanted)});
}

}  // namespace

Result<void> check(const GuardConfig& config) {
  for (const auto& [what, time] :
       {std::pair{"period", config.period}, std::pair{"age limit of plans", config.most_plan_age},
        std::pair{"life of commands", config.command_life}}) {
    if (time <= Time{0}) {
      return refuse(std::string("the guard's ") + what, std::to_string(to_seconds(time)) + " s", "> 0 s");
    }
  }
  if (config.command_life <= config.period) {
    return refuse("the guard's commands end before the next tick",
                  std::to_string(to_seconds(config.command_life)) + " s",
                  "> " + std::to_string(to_seconds(config.period)) + " s, the period");
  }
  if (config.command_life != config.governor.command_life) {
    return refuse("the governor keeps room for commands of another life than the guard's",
                  std::to_string(to_seconds(config.governor.command_life)) + " s",
                  std::to_string(to_seconds(config.command_life)) + " s");
  }
  const std::size_t robots = robots_of(config.governor);
  if (config.estimator.robots.size() != robots || config.life_cycle.robots != robots) {
    return refuse(
        "the guard's parts differ on how many robots there are",
        std::to_string(config.estimator.robots.size()) + " and " + std::to_string(config.life_cycle.robots),
        std::to_string(robots));
  }
  return {};
}

Result<std::unique_ptr<Guard>> Guard::create(GuardConfig config, Hal& hal) {
  if (auto ok = check(config); !ok) {
    return fail(std::move(ok.error()));
  }
  const std::size_t robots = robots_of(config.governor);
  if (hal.robots().size() != robots) {
    return fail(Cause::kDevice, "the HAL has " + std::to_string(hal.robots().size()) +
                                    " robots, the scenario " + std::to_string(robots) + " agents");
  }
  auto governor = Governor::make(config.governor);
  if (!governor) {
    return fail(std::move(governor.error()));
  }
  auto estimator = Estimator::create(config.estimator);
  if (!estimator) {
    return fail(std::move(estimator.error()));
  }
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the constructor is private
  return std::unique_ptr<Guard>(
      new Guard(std::move(config), hal, std::move(*estimator), std::move(*governor)));
}

Guard::Guard(GuardConfig config, Hal& hal, Estimator estimator, Governor governor)
    : config_(std::move(config)),
      hal_(hal),
      robots_(hal.robots().size()),
      estimator_(std::move(estimator)),
      telemetry_(robots_, config_.telemetry),
      wish_(robots_, config_.most_plan_age, speeds_of(config_.governor)),
      lives_(config_.life_cycle),
      reactions_(watched(config_, hal.robots())),
      orders_(orders_config(config_)),
      governor_(std::move(governor)),
      monitor_(monitor_config(config_)),
      black_box_(config_.black_box, config_.period, taped(config_)),
      symptoms_(robots_),
      told_of_(robots_),
      governed_(robots_),
      unmeasured_(robots_),
      held_(robots_),
      kind_(robots_, CommandKind::kHold),
      told_kind_(robots_, CommandKind::kHold),
      vx_(robots_),
      vy_(robots_),
      vz_(robots_) {
  events_.reserve(kMostEvents);
}

}  // namespace mayfly
