#include "sim_hal/radio.hpp"

#include <algorithm>
#include <limits>

namespace mayfly::sim_hal {

namespace {

constexpr Time kSlice = std::chrono::milliseconds(50);

bool is_about_links(const FaultScript& script) {
  return script.has(Effect::kLinkLost) || script.has(Effect::kSilent) || script.has(Effect::kLinkLoss) ||
         script.has(Effect::kLinkLatency);
}

}  // namespace

Radio::Radio(std::span<const RobotInfo> robots, std::string_view hal, const FaultScript& script,
             std::uint64_t seed, float endurance_s)
    : robots_(robots),
      hal_(hal),
      script_(&script),
      seed_(seed),
      endurance_s_(endurance_s),
      never_fails_(!is_about_links(script)),
      answers_(never_fails_ ? 0 : robots.size()),
      late_(never_fails_ ? 0 : robots.size()),
      heard_of_(never_fails_ ? 0 : robots.size()),
      windows_(never_fails_ ? 0 : robots.size()) {}

void Radio::start(Time now) noexcept {
  if (!started_) {
    origin_ = now;
    started_ = true;
    polled_ = now;
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
  const Time since = now - origin_;
  std::fill(late_.begin(), late_.end(), Time{0});
  mark_late(since, late_);
  for (std::size_t robot = 0; robot < answers_.size(); ++robot) {
    Answers& window = windows_[robot];
    const bool in_time = answers_[robot] != 0 && late_[robot] < std::max(now - polled_, Time{1});
    ++window.polls[slice];
    window.answered[slice] = static_cast<std::uint16_t>(window.answered[slice] + (in_time ? 1 : 0));
    heard_of_[robot] =
        answers_[robot] != 0 ? std::max(heard_of_[robot], now - late_[robot]) : heard_of_[robot];
  }
  polled_ = now;
  HalResult result;
  script_->each_robot(Effect::kSilent, since, [&](RobotIndex robot, const ScriptedFault&) {
    if (result.ok()) {
      result = {HalFault::kRobotSilent, robot, robots_[robot].link, "the robot does not answer"};
    }
  });
  const HalResult down = link_state(since);
  return down.ok() ? result : down;
}

HalResult Radio::send(Time now, std::span<std::uint8_t> reaches, std::span<Time> late) noexcept {
  std::fill(reaches.begin(), reaches.end(), std::uint8_t{1});
  std::fill(late.begin(), late.end(), Time{0});
  if (never_fails_) {
    return {};
  }
  mark_lost(now - origin_, sends_++, Draw::kSend, reaches);
  mark_late(now - origin_, late);
  return link_state(now - origin_);
}

// The link that is down; the HAL's name, which is no link's, where it is several of them.
HalResult Radio::link_state(Time since) const noexcept {
  std::string_view link;
  script_->each_robot(Effect::kLinkLost, since, [&](RobotIndex robot, const ScriptedFault&) {
    const std::string_view its = robots_[robot].link;
    link = link.empty() || link == its ? its : hal_;
  });
  return link.empty() ? HalResult{}
                      : HalResult{HalFault::kLinkDown, kEveryRobot, link, "the link does not answer"};
}

void Radio::mark_late(Time since, std::span<Time> late) const noexcept {
  script_->each_robot(Effect::kLinkLatency, since, [&](RobotIndex robot, const ScriptedFault& fault) {
    late[robot] = std::max(late[robot], from_seconds(static_cast<double>(fault.size)));
  });
}

void Radio::mark_lost(Time since, std::int64_t number, Draw what,
                      std::span<std::uint8_t> answers) const noexcept {
  script_->each_robot(Effect::kSilent, since,
                      [&](RobotIndex robot, const ScriptedFault&) { answers[robot] = 0; });
  script_->each_robot(Effect::kLinkLoss, since, [&](RobotIndex robot, const ScriptedFault& fault) {
    const double chance = unit(draw(seed_, robot, number, what)[0]);
    answers[robot] = chance < static_cast<double>(fault.size) ? std::uint8_t{0} : answers[robot];
  });
  script_->each_robot(Effect::kLinkLost, since, [&](RobotIndex robot, const ScriptedFault&) {
    for (std::size_t other = 0; other < answers.size(); ++other) {
      answers[other] = robots_[other].link == robots_[robot].link ? std::uint8_t{0} : answers[other];
    }
  });
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
