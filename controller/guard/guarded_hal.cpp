#include "controller/guard/guarded_hal.hpp"

#include <algorithm>

namespace mayfly {

Result<void> GuardedHal::do_configure() {
  if (robots_.state() == HalState::kCreated) {
    if (auto done = robots_.configure(); !done) {
      return done;
    }
  }
  auto guard = Guard::create(config_, robots_);
  if (!guard) {
    return fail(std::move(guard.error()));
  }
  guard_ = std::move(*guard);
  return {};
}

Result<void> GuardedHal::do_activate(Time now) {
  guard_->restart();
  waits_for_wish_ = false;
  return robots_.activate(now);
}

// A wish that was refused on its way here (out of sequence) has left a tick without an act: the robots hear
// from the guard all the same.
HalResult GuardedHal::do_read(Time now, const StateColumns& states) noexcept {
  if (waits_for_wish_) {
    static_cast<void>(do_write(now, {}));
  }
  waits_for_wish_ = true;
  const HalResult result = guard_->sense(now);
  const EstimateColumns e = guard_->estimate();
  const auto copy = [](const auto& from, const auto& to) { std::copy(from.begin(), from.end(), to.begin()); };
  copy(e.x, states.x);
  copy(e.y, states.y);
  copy(e.z, states.z);
  copy(e.vx, states.vx);
  copy(e.vy, states.vy);
  copy(e.vz, states.vz);
  copy(e.stamp, states.stamp);
  copy(e.fresh, states.valid);
  if (!states.telemetry.empty()) {
    copy(guard_->telemetry(), states.telemetry);
  }
  return result;
}

HalResult GuardedHal::do_write(Time now, const CommandColumns& wish) noexcept {
  waits_for_wish_ = false;
  if (stop_level_ > 0) {
    guard_->tell(stop_level_ > 1 ? Symptom::kEmergencyStop : Symptom::kOperatorHold);
  }
  const HalResult result = guard_->act(now, wish);
  const std::span<const Severity> severities = guard_->severities();
  const auto worst = std::max_element(severities.begin(), severities.end());
  worst_ = worst == severities.end() ? Severity::kNone : *worst;
  return result;
}

}  // namespace mayfly
