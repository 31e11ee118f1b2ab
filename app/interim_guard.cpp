#include "app/interim_guard.hpp"

#include <utility>

namespace mayfly::app {

InterimGuard::InterimGuard(Governor governor, Hal& hal, Time command_life)
    : governor_(std::move(governor)),
      hal_(hal),
      command_life_(command_life),
      estimate_(hal.robots().size()),
      states_(hal.robots().size(), RobotState::kFlying),
      severities_(hal.robots().size(), Severity::kNone),
      symptoms_(hal.robots().size()) {
  kind_.assign(hal.robots().size(), CommandKind::kHold);
  for (std::vector<float>* column : {&wish_x_, &wish_y_, &wish_z_, &vx_, &vy_, &vz_}) {
    column->assign(hal.robots().size(), 0.0F);
  }
}

HalResult InterimGuard::sense(Time now) noexcept {
  const HalResult heard = hal_.read(now, estimate_.inbox());
  static_cast<void>(estimate_.update());
  return heard;
}

HalResult InterimGuard::act(Time now, const CommandColumns& wish) noexcept {
  const bool is_void = now > wish.deadline;
  for (std::size_t robot = 0; robot < kind_.size(); ++robot) {
    const bool moves = !is_void && wish.kind[robot] == CommandKind::kVelocity;
    wish_x_[robot] = moves ? wish.vx[robot] : 0.0F;
    wish_y_[robot] = moves ? wish.vy[robot] : 0.0F;
    wish_z_[robot] = moves ? wish.vz[robot] : 0.0F;
  }
  governor_.govern(
      now, {estimate_.x, estimate_.y, estimate_.z, estimate_.vx, estimate_.vy, estimate_.vz, estimate_.valid},
      {wish_x_, wish_y_, wish_z_}, {kind_, vx_, vy_, vz_, {}});
  for (std::size_t robot = 0; robot < kind_.size(); ++robot) {
    const bool still = vx_[robot] == 0.0F && vy_[robot] == 0.0F && vz_[robot] == 0.0F;
    if (!is_void &&
        (wish.kind[robot] == CommandKind::kStop || (still && wish.kind[robot] == CommandKind::kLand))) {
      kind_[robot] = wish.kind[robot];
    }
  }
  return hal_.write(now, {kind_, vx_, vy_, vz_, now + command_life_, ++sequence_});
}

EstimateColumns InterimGuard::estimate() const noexcept {
  return {estimate_.x,  estimate_.y,     estimate_.z,     estimate_.vx, estimate_.vy,
          estimate_.vz, estimate_.stamp, estimate_.valid, symptoms_,    {}};
}

}  // namespace mayfly::app
