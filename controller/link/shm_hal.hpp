// The guard, as its planner sees it: one more HAL, whose robots are the guard's.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/guard/guard_port.hpp"
#include "controller/link/planner_end.hpp"
#include "controller/link/process_watch.hpp"
#include "core/hal.hpp"

namespace mayfly::link {

struct ShmHalConfig {
  std::string name = "guard";
  std::vector<RobotInfo> robots;  // as the segment was made for
  Time period{0};                 // of the guard's tick
  // Of the user, as mayfly::StopRequest: while the guard is waited for it is not waited for any more. May be
  // null.
  const std::atomic<int>* asked_to_stop = nullptr;
};

// configure() waits until the guard is ready, activate() until it flies, deactivate() until it has brought
// the robots to rest, or its process has ended: those three may take long. read() gives the guard's estimate,
// write() hands it a wish.
//
// What happened at the guard's HAL comes out of read() as it came out of the guard's, once an event.
class ShmHal final : public GuardPort {
 public:
  // `guard` outlives it.
  ShmHal(ShmHalConfig config, PlannerEnd end, const ProcessWatch& guard);

  std::span<const RobotInfo> robots() const noexcept override { return config_.robots; }
  std::string_view name() const noexcept override { return config_.name; }

  // All of the guard's is as old as the newest that crossed; report() and events() are whole after
  // deactivate().
  void ask_to_stop(int level) noexcept override;
  // The guard has its own account of who is there: it does not take a planner's word for it.
  void set_present(std::span<const std::uint8_t>) noexcept override {}
  void acknowledge() noexcept override { end_.acknowledge(); }
  Severity severity() const noexcept override;
  CommandColumns written() const noexcept override;
  std::uint64_t reactions() const noexcept override { return end_.view().head->reactions; }
  GuardReport report() const override { return *end_.view().report; }
  std::vector<GuardEvent> events() const override { return events_; }

  // From whoever watches the guard's process, in any thread: it has ended.
  void guard_ended() noexcept { guard_ended_.store(true, std::memory_order_relaxed); }
  // It did so before it had let go of the robots: they are left to their own watchdogs.
  bool lost() const noexcept {
    return guard_ended_.load(std::memory_order_relaxed) && end_.phase() < Phase::kEnded;
  }
  // What the flight has to heed, as mayfly::StopRequest: the user's, or an end at once where the guard is
  // lost.
  const std::atomic<int>& stop() const noexcept { return stop_; }

 private:
  // As many beats may be missing before the link counts as down.
  static constexpr int kMostMissing = 5;
  static constexpr std::size_t kMostTexts = 64;
  static constexpr std::size_t kMostEvents = 1000;
  struct Text {
    std::array<char, 24> link{};
    std::array<char, 72> cause{};
  };

  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override;
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override;
  Result<void> do_deactivate(Time now) override;
  std::optional<float> do_decode(const EchoColumns& to) noexcept override;

  Result<void> wait_for(Phase phase, Time now, Time most);
  void send_hold(Time now) noexcept;
  void copy_view(const StateColumns& states) noexcept;
  HalResult link_state(Time now) const noexcept;
  HalResult hear_events() noexcept;
  HalResult told(const Event& event) noexcept;

  ShmHalConfig config_;
  PlannerEnd end_;
  const ProcessWatch& guard_;
  Time seen_{0};  // when the guard's beat was new
  std::atomic<bool> guard_ended_{false};
  std::atomic<int> stop_{0};
  // Results name their link and cause by views that live as long as the HAL.
  std::vector<Text> texts_;
  std::vector<GuardEvent> events_;
  std::vector<CommandKind> sent_kind_;
};

}  // namespace mayfly::link
