#include "controller/estimator/told_motion.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly::estimator {

void ToldMotion::advance(Time now) noexcept {
  if (!began_ || now <= at_) {
    return;
  }
  const Time until = std::clamp(deadline_, at_, now);
  pass(to_seconds(until - at_), true);
  pass(to_seconds(now - until), false);
  at_ = now;
}

void ToldMotion::told(Time now, const CommandColumns& commands) noexcept {
  const std::size_t robots = models_.size();
  if (commands.kind.size() < robots || commands.vx.size() < robots || commands.vy.size() < robots ||
      commands.vz.size() < robots) {
    return;
  }
  advance(now);
  if (!began_) {
    began_ = true;
    at_ = now;
  }
  deadline_ = commands.deadline;
  for (std::size_t r = 0; r < robots; ++r) {
    const Velocity wish(static_cast<double>(commands.vx[r]), static_cast<double>(commands.vy[r]),
                        static_cast<double>(commands.vz[r]));
    const bool flies = commands.kind[r] == CommandKind::kVelocity && wish.allFinite();
    wanted_[r] = flies ? wish : Velocity::Zero();
  }
}

void ToldMotion::pass(double seconds, bool commanded) noexcept {
  if (seconds <= 0.0) {
    return;
  }
  for (std::size_t r = 0; r < models_.size(); ++r) {
    Model& model = models_[r];
    const auto lag = static_cast<double>(limits_[r].response_time);
    const double share = lag > 0.0 ? 1.0 - std::exp(-seconds / lag) : 1.0;
    const Velocity wanted = commanded ? wanted_[r] : Velocity(Velocity::Zero());
    Velocity change = share * (wanted - model.velocity);
    const double most = static_cast<double>(limits_[r].acceleration) * seconds;
    const double size = change.norm();
    if (size > most) {
      change *= most / size;
    }
    // Who brakes is told to stand: it may do so sooner than the model.
    if (!wanted.isZero(0.0)) {
      model.travel += seconds * (model.velocity + 0.5 * change);
    }
    model.velocity += change;
  }
}

}  // namespace mayfly::estimator
