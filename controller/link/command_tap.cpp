#include "controller/link/command_tap.hpp"

#include <algorithm>

namespace mayfly::link {

Result<void> CommandTap::do_configure() {
  auto done = robots_.configure();
  if (done) {
    const std::size_t robots = robots_.robots().size();
    kind_.assign(robots, CommandKind::kHold);
    for (std::vector<float>* column : {&vx_, &vy_, &vz_}) {
      column->assign(robots, 0.0F);
    }
  }
  return done;
}

HalResult CommandTap::do_write(Time now, const CommandColumns& commands) noexcept {
  const HalResult written = robots_.write(now, commands);
  bool still = true;
  for (std::size_t robot = 0; robot < kind_.size(); ++robot) {
    kind_[robot] = commands.kind[robot];
    const bool moves = kind_[robot] == CommandKind::kVelocity;
    vx_[robot] = moves ? commands.vx[robot] : 0.0F;
    vy_[robot] = moves ? commands.vy[robot] : 0.0F;
    vz_[robot] = moves ? commands.vz[robot] : 0.0F;
    still = still && vx_[robot] == 0.0F && vy_[robot] == 0.0F && vz_[robot] == 0.0F &&
            kind_[robot] != CommandKind::kTakeOff;
  }
  still_since_ = still && !all_still_ ? now : still_since_;
  all_still_ = still;
  return written;
}

}  // namespace mayfly::link
