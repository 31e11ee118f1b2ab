#include "sim_hal/radio.hpp"

#include <algorithm>
#include <limits>

namespace mayfly::sim_hal {

namespace {

constexpr std::string_view kLink = "sim";
constexpr Time kSlice = std::chrono::milliseconds(50);

bool is_about_links(const FaultScript& script) {
  return script.has(Effect::kLinkLost) || script.has(Effect::kSilent) || script.has(Effect::kLinkLoss);
}

bool is_on(const FaultScript& script, Effect effect, Time since) noexcept {
  bool on = false;
  script.each(effect, [&](const ScriptedFault& fault) { on = on || fault.is_on(since); });
  return on;
}

HalResult link_down() noexcept {
  return {HalFault::kLinkDown, kEveryRobot, kLink, "the link does not answer"};
}

}  // namespace

Radio::Radio(std::size_t robots, const FaultScript& script, std::uint64_t seed, float endurance_s)
    : script_(&script),
      seed_(seed),
      endurance_s_(endurance_s),
      never_fails_(!is_about_links(script)),
      answers_(never_fails_ ? 0 : robots),
      heard_of_(never_fails_ ? 0 : robots),
      windows_(never_fails_ ? 0 : robots) {}

void Radio::start(Time now) noexcept {
  if (!started_) {
    origin_ = now;
    started_ = true;
  }
}

HalResult Radio::poll(Time now) noexcept {
  heard_ = now;
  if (never_fails_) {
    return {};
  }
  turn_slices(now);
  std::fill(answers_.begin(), answers_.end(), std::uint8_t{1});
  mark_lost(now - origin_, polls_++, Draw::kPoll, answers_);
  const auto slice = static_cast<std::size_t>(slice_) % kSlices;
  HalResult result;
  for (std::size_t robot = 0; robot < answers_.size(); ++robot) {
    Answers& window = windows_[robot];
    ++window.polls[slice];
    window.answered[slice] = static_cast<std::uint16_t>(window.answered[slice] + answers_[robot]);
    heard_of_[robot] = answers_[robot] != 0 ? now : heard_of_[robot];
  }
  script_->each_robot(Effect::kSilent, now - origin_, [&](RobotIndex robot, const ScriptedFault&) {
    if (result.ok()) {
      result = {HalFault::kRobotSilent, robot, kLink, "the robot does not answer"};
    }
  });
  return is_on(*script_, Effect::kLinkLost, now - origin_) ? link_down() : result;
}

HalResult Radio::send(Time now, std::span<std::uint8_t> reaches) noexcept {
  std::fill(reaches.begin(), reaches.end(), std::uint8_t{1});
  if (never_fails_) {
    return {};
  }
  mark_lost(now - origin_, sends_++, Draw::kSend, reaches);
  return is_on(*script_, Effect::kLinkLost, now - origin_) ? link_down() : HalResult{};
}

void Radio::mark_lost(Time since, std::int64_t number, Draw what,
                      std::span<std::uint8_t> answers) const noexcept {
  script_->each_robot(Effect::kSilent, since,
                      [&](RobotIndex robot, const ScriptedFault&) { answers[robot] = 0; });
  script_->each_robot(Effect::kLinkLoss, since, [&](RobotIndex robot, const ScriptedFault& fault) {
    const double chance = unit(draw(seed_, robot, number, what)[0]);
    answers[robot] = chance < static_cast<double>(fault.size) ? std::uint8_t{0} : answers[robot];
  });
  if (is_on(*script_, Effect::kLinkLost, since)) {
    std::fill(answers.begin(), answers.end(), std::uint8_t{0});
  }
}

// What is older than a second is forgotten, slice by slice.
void Radio::turn_slices(Time now) noexcept {
  const std::int64_t slice = (now - origin_) / kSlice;
  const std::int64_t forget = std::min<std::int64_t>(slice - slice_, kSlices);
  for (std::int64_t i = 1; i <= forget; ++i) {
    const auto index = static_cast<std::size_t>(slice - forget + i) % kSlices;
    for (Answers& window : windows_) {
      window.polls[index] = window.answered[index] = 0;
    }
  }
  slice_ = std::max(slice_, slice);
}

float Radio::charge(Time since, RobotIndex robot) const noexcept {
  float charge = 1.0F;
  if (endurance_s_ > 0.0F) {
    charge = std::max(0.0F, 1.0F - static_cast<float>(to_seconds(since)) / endurance_s_);
  }
  const auto alter = [&](Effect effect, auto&& change) {
    script_->each_robot(effect, since, [&](RobotIndex who, const ScriptedFault& fault) {
      charge = who == robot ? change(fault.size) : charge;
    });
  };
  alter(Effect::kBatteryLow, [&](float size) { return std::min(charge, size); });
  alter(Effect::kBatteryJump, [&](float size) { return std::max(0.0F, charge - size); });
  alter(Effect::kBatteryNan, [](float) { return std::numeric_limits<float>::quiet_NaN(); });
  return charge;
}

void Radio::tell(Time now, std::span<const std::uint8_t> airborne, std::span<Telemetry> to) const noexcept {
  for (std::size_t robot = 0; robot < to.size(); ++robot) {
    Telemetry& told = to[robot];
    if (never_fails_) {
      told.heard = heard_;
      told.link_quality = 1.0F;
    } else {
      unsigned polls = 0;
      unsigned answered = 0;
      for (std::size_t slice = 0; slice < kSlices; ++slice) {
        polls += windows_[robot].polls[slice];
        answered += windows_[robot].answered[slice];
      }
      told.heard = heard_of_[robot];
      told.link_quality = polls > 0 ? static_cast<float>(answered) / static_cast<float>(polls) : 1.0F;
      if (answers_[robot] == 0) {
        continue;  // what it has to tell is what was heard last
      }
    }
    told.battery = charge(now - origin_, static_cast<RobotIndex>(robot));
    told.airborne = airborne.empty() || airborne[robot] != 0;
  }
}

}  // namespace mayfly::sim_hal
