// Between a planner and its guard: wishes that stop coming, come again, are too fast or are no numbers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "controller/guard/guard_port.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly::simulate {

// To the planner its guard. While `planner_stall` is on, each tick hands over the last wish before, with its
// old deadline: only the number is new, as a mailbox that is read again and again has none. While
// `command_replay` is on, a wish of the past comes before each one, with a fresh deadline and its old number.
// `planner_absurd` and `planner_nan` alter velocities. `guard` and `scenario` outlive it.
class BadWishes final : public GuardPort {
 public:
  BadWishes(const Scenario& scenario, GuardPort& guard);
  static bool has_any(const Scenario& scenario);

  std::span<const RobotInfo> robots() const noexcept override { return guard_.robots(); }
  std::string_view name() const noexcept override { return guard_.name(); }
  void ask_to_stop(int level) noexcept override { guard_.ask_to_stop(level); }
  void set_present(std::span<const std::uint8_t> present) noexcept override { guard_.set_present(present); }
  void acknowledge() noexcept override { guard_.acknowledge(); }
  Severity severity() const noexcept override { return guard_.severity(); }
  CommandColumns written() const noexcept override { return guard_.written(); }
  std::uint64_t reactions() const noexcept override { return guard_.reactions(); }
  GuardReport report() const override { return guard_.report(); }
  std::vector<GuardEvent> events() const override { return guard_.events(); }
  const BlackBoxTape* tape() const noexcept override { return guard_.tape(); }

 private:
  struct Wish {
    std::vector<CommandKind> kind;
    std::vector<float> x, y, z;
    Time made{0}, deadline{0};
    std::uint64_t sequence = 0;  // 0: none yet

    void copy(Time now, const CommandColumns& from) noexcept;
    CommandColumns columns() const { return {kind, x, y, z, deadline, sequence}; }
  };

  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override {
    return guard_.read(now, states);
  }
  HalResult do_write(Time now, const CommandColumns& wish) noexcept override;
  Result<void> do_deactivate(Time now) override { return guard_.deactivate(now); }

  const FaultSpec* on(FaultKind kind, Time now) const noexcept;
  void spoil(Time now) noexcept;
  void spoil(const FaultSpec& fault, std::uint64_t tick) noexcept;
  HalResult replay(Time now, Time age) noexcept;

  GuardPort& guard_;
  std::vector<FaultSpec> faults_;
  std::uint64_t seed_;
  Time origin_{0};
  bool started_ = false;
  Wish newest_;
  std::vector<Wish> past_;  // a ring
  std::size_t last_ = 0;    // in it
};

}  // namespace mayfly::simulate
