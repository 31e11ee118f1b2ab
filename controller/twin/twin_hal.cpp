#include "controller/twin/twin_hal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "controller/twin/twins.hpp"

namespace mayfly {
namespace {

bool is_positive(float value) {
  return std::isfinite(value) && value > 0.0F;
}

Result<void> refuse(const std::string& what, std::string found, std::string wanted) {
  Error error;
  error.message = "twins: " + what;
  error.found = std::move(found);
  error.wanted = std::move(wanted);
  return fail(std::move(error));
}

}  // namespace

Result<void> check(const TwinConfig& config) {
  for (std::size_t r = 0; r < config.robots.size(); ++r) {
    const TwinLimits& limits = config.robots[r];
    const bool lags = std::isfinite(limits.response_time) && limits.response_time >= 0.0F;
    if (!is_positive(limits.speed) || !is_positive(limits.acceleration) || !lags) {
      return refuse(
          fmt::format("limits of robot {}", r),
          fmt::format("{} m/s, {} m/s² and {} s", limits.speed, limits.acceleration, limits.response_time),
          "above 0, finite; s may be 0");
    }
  }
  if (!is_positive(config.most_distance) || !is_positive(config.most_speed) || config.most_age <= Time{0}) {
    return refuse("where a robot may be put back",
                  fmt::format("{} m, {} m/s and {} ns", config.most_distance, config.most_speed,
                              config.most_age.count()),
                  "above 0, finite");
  }
  if (config.parked != CommandKind::kHold && config.parked != CommandKind::kLand) {
    return refuse("what a robot does while its twin flies",
                  fmt::format("command {}", static_cast<int>(config.parked)), "hold or land");
  }
  return {};
}

TwinHal::TwinHal(std::unique_ptr<Hal> real, TwinConfig config)
    : real_(std::move(real)), config_(std::move(config)) {}
TwinHal::~TwinHal() = default;

bool TwinHal::take_out(RobotIndex robot) noexcept {
  return twins_ != nullptr && twins_->ask(robot, true);
}

bool TwinHal::put_back(RobotIndex robot) noexcept {
  return twins_ != nullptr && twins_->ask(robot, false);
}

bool TwinHal::is_twin(RobotIndex robot) const noexcept {
  return twins_ != nullptr && twins_->flies(robot);
}

TwinReport TwinHal::report(RobotIndex robot) const noexcept {
  return twins_ != nullptr ? twins_->report(robot) : TwinReport{};
}

void TwinHal::show_twins(const StateColumns& states) const noexcept {
  twins_->show(twins_->now(), states);
}

RealPose TwinHal::real_pose(RobotIndex robot) const noexcept {
  return twins_->real_pose(robot);
}

Result<void> TwinHal::do_configure() {
  if (auto good = check(config_); !good) {
    return good;
  }
  // A second try finds it configured already.
  if (real_->state() == HalState::kCreated) {
    if (auto done = real_->configure(); !done) {
      return done;
    }
  }
  if (real_->robots().size() != config_.robots.size()) {
    return refuse("limits", fmt::format("those of {} robots", config_.robots.size()),
                  fmt::format("one for each of {}", real_->robots().size()));
  }
  twins_ = std::make_unique<Twins>(config_);
  return {};
}

Result<void> TwinHal::do_activate(Time now) {
  if (auto done = real_->activate(now); !done) {
    return done;
  }
  twins_->restart(now);
  return {};
}

HalResult TwinHal::do_read(Time now, const StateColumns& states) noexcept {
  twins_->hide(states);
  const HalResult result = real_->read(now, states);
  twins_->hear(states);
  twins_->advance(now);
  twins_->do_what_was_asked(now);
  twins_->show(now, states);
  return result;
}

HalResult TwinHal::do_write(Time now, const CommandColumns& commands) noexcept {
  twins_->advance(now);
  twins_->command(commands);
  CommandColumns own = commands;
  own.kind = twins_->park(commands.kind);
  return real_->write(now, own);
}

Result<void> TwinHal::do_deactivate(Time now) {
  return real_->deactivate(now);
}

std::string describe(const TwinReport& report, const TwinConfig& config) {
  switch (report.outcome) {
    case TwinOutcome::kNone:
      return "nothing was asked of it";
    case TwinOutcome::kPending:
      return "waits for the next tick";
    case TwinOutcome::kTakenOut:
      return "taken out: its twin flies";
    case TwinOutcome::kPutBack:
      return fmt::format("put back, {:.3g} m from where its twin was", report.distance);
    case TwinOutcome::kAlready:
      return "is so already";
    case TwinOutcome::kNoPose:
      return fmt::format("refused: its pose is missing or older than {:.3g} s", to_seconds(config.most_age));
    case TwinOutcome::kTooFar:
      return fmt::format("refused: it is {:.3g} m from its twin; wanted at most {:.3g} m", report.distance,
                         config.most_distance);
    case TwinOutcome::kTooFast:
      return fmt::format("refused: it moves at {:.3g} m/s past its twin; wanted at most {:.3g} m/s",
                         report.speed, config.most_speed);
  }
  return {};
}

}  // namespace mayfly
