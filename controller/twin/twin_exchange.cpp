#include "controller/twin/twin_exchange.hpp"

#include <glm/geometric.hpp>
#include <utility>

#include "controller/guard/guard.hpp"

namespace mayfly {

TwinExchange::TwinExchange(TwinHal& hal, std::vector<TwinSpell> spells, std::vector<float> braking,
                           std::vector<float> response_time)
    : hal_(hal),
      spells_(std::move(spells)),
      stages_(spells_.size(), Stage::kIn),
      braking_(std::move(braking)),
      response_time_(std::move(response_time)) {
  kept_clear_.reserve(spells_.size());
}

void TwinExchange::tick(Time now, Guard& guard) noexcept {
  began_ = began_ == Time::min() ? now : began_;
  for (std::size_t i = 0; i < spells_.size(); ++i) {
    stages_[i] = next(spells_[i], stages_[i], now - began_, guard);
  }
}

// One step a tick: what was asked of the HAL is done in its next read.
TwinExchange::Stage TwinExchange::next(const TwinSpell& spell, Stage stage, Time flown,
                                       Guard& guard) noexcept {
  const bool is_twin = hal_.is_twin(spell.robot);
  switch (stage) {
    case Stage::kIn:
      return flown >= spell.out && hal_.take_out(spell.robot) ? Stage::kAskedOut : stage;
    case Stage::kAskedOut:
      return is_twin ? Stage::kOut : Stage::kIn;
    case Stage::kOut: {
      const RealPose at = hal_.real_pose(spell.robot);
      return flown >= spell.back && guard.lead(spell.robot, {at.x, at.y, at.z}) ? Stage::kLed : stage;
    }
    case Stage::kLed:
      switch (guard.states()[spell.robot]) {
        case RobotState::kReturning:
          return stage;
        case RobotState::kHolding:
          return hal_.put_back(spell.robot) ? Stage::kAskedBack : stage;
        default:
          return Stage::kOut;  // somebody wanted something else of it
      }
    case Stage::kAskedBack:
      if (is_twin) {
        return Stage::kOut;
      }
      guard.request(spell.robot, RobotEvent::kResume);
      return Stage::kDone;
    case Stage::kDone:
      break;
  }
  return stage;
}

// A robot that is taken out brakes: it needs the way to where it comes to rest.
std::span<const KeptClear> TwinExchange::kept_clear() noexcept {
  kept_clear_.clear();
  for (const TwinSpell& spell : spells_) {
    if (!hal_.is_twin(spell.robot)) {
      continue;
    }
    const RealPose at = hal_.real_pose(spell.robot);
    const glm::vec3 velocity(at.vx, at.vy, at.vz);
    const float seconds =
        glm::length(velocity) / (2.0F * braking_[spell.robot]) + response_time_[spell.robot];
    const glm::vec3 from(at.x, at.y, at.z);
    kept_clear_.push_back({from, from + seconds * velocity, spell.robot});
  }
  return kept_clear_;
}

}  // namespace mayfly
