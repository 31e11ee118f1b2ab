// A HAL that answers as a test tells it to.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/hal.hpp"

namespace mayfly::contract {

class ScriptedHal final : public Hal {
 public:
  explicit ScriptedHal(std::size_t robots, const std::string& prefix = "r") : name_(prefix) {
    for (std::size_t robot = 0; robot < robots; ++robot) {
      infos_.push_back({prefix + std::to_string(robot), "wire"});
    }
  }
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return name_; }

  // What the next calls answer.
  bool configure_fails = false;
  bool activate_fails = false;
  bool deactivate_fails = false;
  HalResult read_result;
  HalResult write_result;
  // What reached the robots.
  int configured = 0, activated = 0, deactivated = 0, reads = 0, writes = 0;
  std::vector<CommandKind> last_kinds = std::vector<CommandKind>(64);
  std::size_t last_size = 0;

 private:
  static Result<void> answer(bool fails) {
    return fails ? Result<void>(fail(Cause::kDevice, "no")) : Result<void>();
  }
  Result<void> do_configure() override { return ++configured, answer(configure_fails); }
  Result<void> do_activate(Time) override { return ++activated, answer(activate_fails); }
  Result<void> do_deactivate(Time) override { return ++deactivated, answer(deactivate_fails); }
  HalResult do_read(Time now, const StateColumns& states) noexcept override {
    ++reads;
    last_size = states.x.size();
    for (std::size_t robot = 0; robot < infos_.size(); ++robot) {
      states.stamp[robot] = now;
      states.valid[robot] = read_result.ok() ? 1 : 0;
    }
    return read_result;
  }
  HalResult do_write(Time, const CommandColumns& commands) noexcept override {
    ++writes;
    last_size = commands.kind.size();
    std::copy(commands.kind.begin(), commands.kind.end(), last_kinds.begin());
    return write_result;
  }

  std::string name_;
  std::vector<RobotInfo> infos_;
};

}  // namespace mayfly::contract
