// What planner and guard tell each other, as columns of plain numbers in a block of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "controller/guard/guard_report.hpp"
#include "controller/link/shared_ring.hpp"
#include "core/clock.hpp"
#include "core/hal.hpp"

namespace mayfly::link {

// Cuts columns from a block, one after the other, each at a multiple of 8 bytes. Without a block it only
// measures.
class Cutter {
 public:
  explicit Cutter(std::byte* block = nullptr) : block_(block) {}

  template <class T>
  std::span<T> cut(std::size_t count) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= sizeof(Word));
    const std::size_t at = used_;
    used_ += (count * sizeof(T) + sizeof(Word) - 1) / sizeof(Word) * sizeof(Word);
    return block_ == nullptr ? std::span<T>() : std::span<T>(reinterpret_cast<T*>(block_ + at), count);
  }
  std::size_t used() const noexcept { return used_; }

 private:
  std::byte* block_;
  std::size_t used_ = 0;
};

// Down, every tick of the planner: what it wishes of each robot. Times are on the run's clock, which both
// sides count from the same instant of CLOCK_MONOTONIC.
struct WishHead {
  Word owner = 0;     // the planner's lease
  Word sequence = 0;  // strictly increasing as long as the segment lives
  Time::rep issued_ns = 0;
  Time::rep deadline_ns = 0;
};
struct WishColumns {
  WishHead* head = nullptr;
  std::span<std::uint8_t> kind;  // CommandKind
  std::span<float> vx, vy, vz;   // m/s
};

// Down, as levels: what holds now, not what happened. A channel that dies cannot lose them, and what is
// repeated does nothing.
struct OperatorHead {
  Word owner = 0;
  std::uint32_t stop = 0;          // StopLevel
  std::uint32_t acknowledged = 0;  // counts up with every acknowledgement
};
struct OperatorColumns {
  OperatorHead* head = nullptr;
};
enum class StopLevel : std::uint32_t { kNone, kHold, kEmergencyStop };

// Up, every tick of the guard.
struct ViewHead {
  Time::rep time_ns = 0;
  Word tick = 0;
  Word wish = 0;                // sequence of the newest wish that was taken
  std::uint64_t taken = 0;      // wishes
  std::uint64_t refused = 0;    // wishes, and commands of one robot within a wish, that made no sense
  std::uint64_t reactions = 0;  // that have begun so far
  // The last time that the wish ran out and everybody was brought to stand still: when the planner issued the
  // last wish before, when the last robot was told to hold or velocity 0, and how late the machine woke the
  // guard in between. All 0 before the first.
  Time::rep wished_ns = 0, still_ns = 0, late_ns = 0;
};
struct ViewColumns {
  ViewHead* head = nullptr;
  GuardReport* report = nullptr;
  std::span<float> x, y, z, vx, vy, vz;  // the estimate; m, m/s
  std::span<Time::rep> stamp_ns;
  std::span<std::uint8_t> fresh;  // 1: the estimate rests on a sample of this tick
  std::span<Symptoms> symptoms;
  std::span<std::uint8_t> state;               // RobotState
  std::span<std::uint8_t> severity;            // Severity
  std::span<std::uint8_t> kind;                // of the command as it was sent
  std::span<float> sent_vx, sent_vy, sent_vz;  // m/s, as sent
  std::span<Time::rep> heard_ns;               // Telemetry
  std::span<float> battery, link_quality;
  std::span<std::uint8_t> airborne;
};

// Up, when something happens.
struct Event {
  Time::rep time_ns = 0;
  std::uint32_t robot = 0;  // kEveryRobot for all
  std::uint32_t fault = 0;  // HalFault; kNone: it is a reaction
  std::uint32_t symptom = 0;
  std::uint32_t severity = 0;
  std::array<char, 24> link{};
  std::array<char, 72> cause{};
};

inline WishColumns wish_columns(Cutter& cutter, std::size_t robots) {
  WishColumns c;
  c.head = cutter.cut<WishHead>(1).data();
  c.kind = cutter.cut<std::uint8_t>(robots);
  for (std::span<float>* column : {&c.vx, &c.vy, &c.vz}) {
    *column = cutter.cut<float>(robots);
  }
  return c;
}

inline OperatorColumns operator_columns(Cutter& cutter, std::size_t) {
  return {cutter.cut<OperatorHead>(1).data()};
}

inline ViewColumns view_columns(Cutter& cutter, std::size_t robots) {
  ViewColumns c;
  c.head = cutter.cut<ViewHead>(1).data();
  c.report = cutter.cut<GuardReport>(1).data();
  for (std::span<float>* column : {&c.x, &c.y, &c.z, &c.vx, &c.vy, &c.vz, &c.sent_vx, &c.sent_vy, &c.sent_vz,
                                   &c.battery, &c.link_quality}) {
    *column = cutter.cut<float>(robots);
  }
  c.stamp_ns = cutter.cut<Time::rep>(robots);
  c.heard_ns = cutter.cut<Time::rep>(robots);
  c.symptoms = cutter.cut<Symptoms>(robots);
  for (std::span<std::uint8_t>* column : {&c.fresh, &c.state, &c.severity, &c.kind, &c.airborne}) {
    *column = cutter.cut<std::uint8_t>(robots);
  }
  return c;
}

// Bytes of a block for so many robots.
template <class Columns>
std::size_t bytes_of(Columns (*cut)(Cutter&, std::size_t), std::size_t robots) {
  Cutter measure;
  static_cast<void>(cut(measure, robots));
  return measure.used();
}

}  // namespace mayfly::link
