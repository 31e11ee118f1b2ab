// A HAL of your own: points that fly as told. Yours would hand commands to the thread that owns its bus.
#include <algorithm>
#include <glm/vec3.hpp>
#include "core/hal.hpp"

using mayfly::CommandKind, mayfly::HalResult, mayfly::Result, mayfly::RobotInfo, mayfly::Time;

class MyHal final : public mayfly::Hal {
 public:
  explicit MyHal(std::size_t robots) : infos_(robots), places_(robots), speeds_(robots) {
    for (std::size_t i = 0; i < robots; ++i) infos_[i] = {"point" + std::to_string(i), "air"};
  }
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return "mine"; }

 private:  // the base class has seen to the order of calls, to lengths, NaN and expired commands
  Result<void> do_configure() override { return {}; }
  Result<void> do_activate(Time now) override { return deadline_ = last_ = now, Result<void>(); }
  Result<void> do_deactivate(Time now) override { return move(now), deadline_ = now, Result<void>(); }
  HalResult do_read(Time now, const mayfly::StateColumns& s) noexcept override {
    move(now);
    for (std::size_t i = 0; i < infos_.size(); ++i) {
      s.x[i] = places_[i].x, s.y[i] = places_[i].y, s.z[i] = places_[i].z;
      s.vx[i] = speeds_[i].x, s.vy[i] = speeds_[i].y, s.vz[i] = speeds_[i].z, s.stamp[i] = now,
      s.valid[i] = 1;
    }
    return {};
  }
  HalResult do_write(Time now, const mayfly::CommandColumns& c) noexcept override {
    move(now);
    for (std::size_t i = 0; i < infos_.size(); ++i) {
      const bool flies = c.kind[i] == CommandKind::kVelocity;  // everything else is to hold
      speeds_[i] = flies ? glm::vec3(c.vx[i], c.vy[i], c.vz[i]) : glm::vec3(0.0F);
    }
    deadline_ = c.deadline;
    return {};
  }
  void move(Time now) noexcept {
    const std::chrono::duration<float> dt = std::max(Time(0), std::min(now, deadline_) - last_);
    for (std::size_t i = 0; i < infos_.size(); ++i) places_[i] += speeds_[i] * dt.count();
    if (now >= deadline_) std::fill(speeds_.begin(), speeds_.end(), glm::vec3(0.0F));  // nobody leads: hold
    last_ = now;
  }
  std::vector<RobotInfo> infos_;
  std::vector<glm::vec3> places_, speeds_;
  Time last_{0}, deadline_{0};
};

int main() {
  MyHal hal(3);
  if (!hal.configure() || !hal.activate(Time(0))) return 1;
  const std::vector<CommandKind> fly(3, CommandKind::kVelocity);
  std::vector<float> one(3, 1.0F), zero(3), x(3), y(3), z(3), vx(3), vy(3), vz(3);
  hal.write(Time(0), {fly, one, zero, zero, std::chrono::seconds(2), 1});  // 1 m/s for 2 s, then silence
  std::vector<Time> stamp(3);
  std::vector<std::uint8_t> valid(3);
  hal.read(std::chrono::seconds(5), {x, y, z, vx, vy, vz, stamp, valid});
  return x[1] == 2.0F && vx[1] == 0.0F ? 0 : 1;
}
