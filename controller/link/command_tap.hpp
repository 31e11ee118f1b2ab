// A HAL that passes everything on, and remembers what was sent.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/hal.hpp"

namespace mayfly::link {

class CommandTap final : public Hal {
 public:
  // `robots` outlives it.
  explicit CommandTap(Hal& robots) : robots_(robots) {}

  std::span<const RobotInfo> robots() const noexcept override { return robots_.robots(); }
  std::string_view name() const noexcept override { return robots_.name(); }

  // As of the last write that reached the robots' HAL; m/s.
  std::span<const CommandKind> kind() const noexcept { return kind_; }
  std::span<const float> vx() const noexcept { return vx_; }
  std::span<const float> vy() const noexcept { return vy_; }
  std::span<const float> vz() const noexcept { return vz_; }
  // Whether no robot was told to move, and since which write.
  bool all_still() const noexcept { return all_still_; }
  Time still_since() const noexcept { return still_since_; }

 private:
  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override { return robots_.activate(now); }
  HalResult do_read(Time now, const StateColumns& states) noexcept override {
    return robots_.read(now, states);
  }
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override;
  Result<void> do_deactivate(Time now) override { return robots_.deactivate(now); }

  Hal& robots_;
  std::vector<CommandKind> kind_;
  std::vector<float> vx_, vy_, vz_;
  bool all_still_ = true;
  Time still_since_{0};
};

}  // namespace mayfly::link
