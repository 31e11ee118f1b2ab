// Several HALs as one: a swarm may have real robots and simulated ones at once.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/hal.hpp"

namespace mayfly {

// Robots stand in the order of the children, each child's own order kept. Set-up is all or nothing: where one
// child cannot be configured or activated, nor can the whole, and those that were active are let go of. In
// flight no child can hold up another: every child is read and written whatever the others answer, and the
// gravest fault is reported (the first of those) with the robot's index in the whole; each child's own
// counters tell the rest. Which robots of a faulty child are still valid is that child's to say.
class CompositeHal final : public Hal {
 public:
  CompositeHal(std::string name, std::vector<std::unique_ptr<Hal>> children);

  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return name_; }
  std::span<const std::unique_ptr<Hal>> children() const noexcept { return children_; }

 private:
  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override;
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override;
  Result<void> do_deactivate(Time now) override;

  std::string name_;
  std::vector<std::unique_ptr<Hal>> children_;
  std::vector<RobotInfo> infos_;
};

}  // namespace mayfly
