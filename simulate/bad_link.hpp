// Between a planner and the HAL that it writes to: a planner that stalls, and commands that come again.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/scenario/fault_spec.hpp"
#include "core/hal.hpp"

namespace mayfly::simulate {

// To the planner one more HAL. While `planner_stall` is on, the HAL behind gets what it was written last,
// with its old deadline and number; while `command_replay` is on, beside each command one of half a second
// ago, with a fresh deadline and its old number. `hal` and `faults` outlive it.
class BadLink final : public Hal {
 public:
  BadLink(Hal& hal, const std::vector<FaultSpec>& faults) : hal_(hal), faults_(faults) {}

  std::span<const RobotInfo> robots() const noexcept override { return hal_.robots(); }
  std::string_view name() const noexcept override { return hal_.name(); }

 private:
  struct Command {
    std::vector<CommandKind> kind;
    std::vector<float> x, y, z;
    Time written{0}, deadline{0};
    std::uint64_t sequence = 0;

    void copy(Time now, const CommandColumns& from) noexcept;
    CommandColumns columns() const { return {kind, x, y, z, deadline, sequence}; }
  };

  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override { return hal_.read(now, states); }
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override;
  Result<void> do_deactivate(Time now) override { return hal_.deactivate(now); }

  bool is_on(FaultKind kind, Time now) const noexcept;
  HalResult replay(Time now, Time fresh_deadline) noexcept;

  Hal& hal_;
  const std::vector<FaultSpec>& faults_;
  Time origin_{0};
  bool started_ = false;
  Command last_;
  std::vector<Command> past_;  // a ring
  std::size_t newest_ = 0;
};

}  // namespace mayfly::simulate
