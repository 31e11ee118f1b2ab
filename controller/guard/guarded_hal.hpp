// A HAL with a guard before it, in one process and one thread: read() is the guard's sense(), write() its
// act().
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "controller/guard/guard.hpp"
#include "controller/guard/guard_config.hpp"
#include "controller/guard/guard_port.hpp"

namespace mayfly {

class GuardedHal final : public GuardPort {
 public:
  // `robots` outlives it. configure() fails as Guard::create does, and as the robots' own does.
  GuardedHal(GuardConfig config, Hal& robots) : config_(std::move(config)), robots_(robots) {}

  std::span<const RobotInfo> robots() const noexcept override { return robots_.robots(); }
  std::string_view name() const noexcept override { return robots_.name(); }

  void ask_to_stop(int level) noexcept override { stop_level_ = level; }
  void set_present(std::span<const std::uint8_t> present) noexcept override { guard_->set_present(present); }
  void acknowledge() noexcept override { guard_->acknowledge(); }
  Severity severity() const noexcept override { return worst_; }
  std::uint64_t reactions() const noexcept override { return guard_->reactions(); }
  CommandColumns written() const noexcept override { return guard_->written(); }
  GuardReport report() const override { return guard_->report(); }
  std::vector<GuardEvent> events() const override {
    return {guard_->events().begin(), guard_->events().end()};
  }

  const BlackBoxTape* tape() const noexcept override { return guard_->black_box().sealed(); }

  // From configure() on.
  Guard& guard() noexcept { return *guard_; }

 private:
  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override;
  HalResult do_write(Time now, const CommandColumns& wish) noexcept override;
  Result<void> do_deactivate(Time now) override { return robots_.deactivate(now); }
  void on_refused() noexcept override { guard_->refuse_wish(); }

  GuardConfig config_;
  Hal& robots_;
  std::unique_ptr<Guard> guard_;
  int stop_level_ = 0;
  Severity worst_ = Severity::kNone;
  bool waits_for_wish_ = false;
};

}  // namespace mayfly
