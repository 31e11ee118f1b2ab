// Between a planner and the robots: hears, estimates, judges, governs and writes, every tick, whatever the
// planner does.
//
//   robots ── HAL.read ─► estimator ─► planner ── wish ─► life cycle, reactions, governor, invariants ──
//   HAL.write ─► robots
//
// It needs a HAL and a GuardConfig, and no scenario, no field, no engine, no file: the same guard flies in
// the planner's process (guarded_hal.hpp) and in one of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "controller/estimator/estimator.hpp"
#include "controller/governor/governor.hpp"
#include "controller/guard/black_box.hpp"
#include "controller/guard/guard_config.hpp"
#include "controller/guard/guard_report.hpp"
#include "controller/guard/monitor.hpp"
#include "controller/guard/orders.hpp"
#include "controller/guard/telemetry_watch.hpp"
#include "controller/guard/wish_desk.hpp"
#include "controller/life_cycle/life_cycle.hpp"
#include "controller/safety/reactions.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly {

// One tick is sense(), then act(), both with the same `now`. Only create() allocates; blocks never; one
// thread. What is seen in a tick is answered in it, but for what the governor and the monitor see in what is
// about to be sent: that is answered in the next.
class Guard {
 public:
  // `hal` is configured, has as many robots as the configuration, and outlives the guard. The caller
  // activates it, and lets go of it.
  static Result<std::unique_ptr<Guard>> create(GuardConfig config, Hal& hal);

  // After each activation of the HAL: sequences and the reference of what was sent begin anew. Severities
  // stay.
  void restart() noexcept;

  // Hears the robots and works out where they are. The result is the HAL's.
  HalResult sense(Time now) noexcept;
  // `wish` is the newest that a planner handed over, however old (wish_desk.hpp judges it); its columns need
  // not outlive the call. kNone for a robot means that nothing is wished of it. The result is the HAL's.
  HalResult act(Time now, const CommandColumns& wish) noexcept;

  // What somebody else sees, for the next act(): the operator's hold and emergency stop, a failed simulation,
  // a lost link, a late tick of the caller's. Fresh every tick: tell it again as long as it is so.
  void tell(Symptom of_everybody) noexcept { told_.add(of_everybody); }
  void tell(RobotIndex robot, Symptom symptom) noexcept { told_of_[robot].add(symptom); }
  // A wish was refused on its way here, out of sequence: told in the next act().
  void refuse_wish() noexcept { wish_.refuse(); }
  // 0 for robots that are not there: nobody minds them, and they are told to hold. Empty: all are there. The
  // column is read in each act().
  void set_present(std::span<const std::uint8_t> present) noexcept { present_ = present; }
  // An operator's event: arm, take off, land, return, clear. False: the table of lives refuses it.
  // One that returns goes straight back, as far as the governor lets it, to where it was when its motors
  // might turn first, and lands there.
  bool request(RobotIndex robot, RobotEvent event) noexcept;
  // Returns a robot to another place (m), where it holds; kResume gives it back to the planner. False: as
  // request().
  bool lead(RobotIndex robot, glm::vec3 place) noexcept;
  // An operator's: clears what is latched where its cause is gone; returns what stays.
  Severity acknowledge() noexcept;

  EstimateColumns estimate() const noexcept { return estimator_.estimate(); }
  std::span<const Telemetry> telemetry() const noexcept { return estimator_.telemetry(); }
  // Where the governor takes a robot to be, as of the last act().
  GovernorReference reference(RobotIndex robot) const noexcept { return governor_.reference(robot); }
  std::span<const RobotState> states() const noexcept { return lives_.states(); }
  std::span<const Severity> severities() const noexcept { return reactions_.severities(); }
  std::span<const Symptoms> symptoms() const noexcept { return symptoms_; }  // as of the last act()
  Symptoms everybody() const noexcept { return everybody_; }
  // As handed to the HAL by the last act().
  CommandColumns written() const noexcept;
  // Whether all invariants held in the last act() and the HAL took what was written: only then whoever feeds
  // a watchdog may feed it (I17).
  bool held() const noexcept { return monitor_.held() && was_written_; }

  // Reactions that began, as they began; at most kMostEvents, the report says how many more there were.
  std::span<const GuardEvent> events() const noexcept { return events_; }
  std::uint64_t reactions() const noexcept { return events_.size() + report_.events_not_kept; }
  GuardReport report() const noexcept;
  BlackBox& black_box() noexcept { return black_box_; }

  static constexpr std::size_t kMostEvents = 1000;

 private:
  Guard(GuardConfig config, Hal& hal, Estimator estimator, Governor governor);

  void note_link(const HalResult& result) noexcept;
  void gather(Time now) noexcept;
  void live(Time now) noexcept;
  void follow_severity(RobotIndex robot) noexcept;
  void react(Time now) noexcept;
  void govern(Time now) noexcept;
  HalResult write(Time now) noexcept;
  void tell_estimator(Time now) noexcept;
  void end_tick(Time now, const TickOutcome& outcome) noexcept;

  GuardConfig config_;
  Hal& hal_;
  std::size_t robots_;
  Estimator estimator_;
  TelemetryWatch telemetry_;
  WishDesk wish_;
  LifeCycles lives_;
  Reactions reactions_;
  Orders orders_;
  Governor governor_;
  Monitor monitor_;
  BlackBox black_box_;

  std::span<const std::uint8_t> present_;
  std::vector<Symptoms> symptoms_, told_of_, governed_;
  Symptoms everybody_, told_;
  std::vector<std::uint8_t> unmeasured_;  // 0 of all
  std::vector<std::uint8_t> held_;        // 1: holds because of its severity, and goes on when that is over
  std::vector<CommandKind> kind_, told_kind_;
  std::vector<float> vx_, vy_, vz_;
  std::vector<GuardEvent> events_;
  GuardReport report_;
  std::uint64_t sequence_ = 0;
  Time deadline_{0};
  Time last_tick_{Time::min()};
  Time sensed_{Time::min()};  // what was heard in another tick than act() is not where anybody is now
  bool has_sensed_ = false;
  bool acknowledged_ = false;
  bool was_written_ = true;
  bool is_incident_ = false;  // a reaction began that is worth a black box
  bool held_before_ = true;
};

}  // namespace mayfly
