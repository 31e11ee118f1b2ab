// The HAL contract: what the controller may ask of robots, real or simulated, and in which order.
//
//   configure → activate → (read → write)* → deactivate        (deactivate → activate again is allowed)
//
// The order is enforced here, for every HAL alike: a call in the wrong state is refused, counted, and never
// reaches the robots. read and write neither block, nor allocate, nor throw: I/O threads own the buses and
// hand over the newest value. One thread calls a HAL; its counters may be read from any.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly {

using RobotIndex = std::uint32_t;
inline constexpr RobotIndex kEveryRobot = std::numeric_limits<RobotIndex>::max();

enum class CommandKind : std::uint8_t { kNone, kVelocity, kHold, kTakeOff, kLand, kStop };

enum class HalState : std::uint8_t { kCreated, kConfigured, kActive, kInactive };

enum class HalFault : std::uint8_t {
  kNone,
  kWrongState,     // called out of order
  kWrongSize,      // a column shorter than robots()
  kOutOfSequence,  // an old or repeated command; none of it reached a robot
  kNotFinite,      // a velocity that is not a number; that robot got `hold` instead
  kExpired,        // the command's deadline had passed; that robot got `hold` instead
  kLinkDown,       // the bus, dongle or port does not answer
  kRobotSilent,    // the link works, this robot does not answer
  kMisencoded,     // what was encoded for a robot does not decode to its command
  kGivenUp,        // what drives the robots has failed for good: a simulation's device is lost
};

// What happened to a call in the loop. Plain data: no allocation on the way.
struct HalResult {
  HalFault fault = HalFault::kNone;
  RobotIndex robot = kEveryRobot;
  std::string_view link{};   // lives as long as the HAL
  std::string_view cause{};  // a literal

  bool ok() const { return fault == HalFault::kNone; }
};

struct RobotInfo {
  std::string name;
  std::string link;  // "sim", "can0", "radio://0/80/2M"
};

// What a robot or its link tells beside its motion. A HAL leaves alone what it has no means to know.
struct Telemetry {
  Time heard{0};  // when the link last had an answer of any kind from it, on the run's clock
  float battery = std::numeric_limits<float>::quiet_NaN();       // share of the charge, 0 to 1
  float link_quality = std::numeric_limits<float>::quiet_NaN();  // share of the last second's polls answered
  bool airborne = true;  // motors carry it, or it drives; false: at rest, and safe to touch
};

// Where read() puts what is known of each robot, one element a robot, in the order of robots().
// Positions in m, velocities in m/s, world frame. Columns may be longer than robots(); the excess is not
// touched. `stamp` is when the state was measured, on the run's clock; in real time that may be a little
// after `now`, by as long as the caller took to call. Where `valid` is 0 the other columns keep their last
// value.
struct StateColumns {
  std::span<float> x, y, z;
  std::span<float> vx, vy, vz;
  std::span<Time> stamp;
  std::span<std::uint8_t> valid;
  std::span<Telemetry> telemetry{};  // may be left empty: then it is not told
};

// One command for each robot, in the order of robots(); columns may be longer, the excess is ignored.
// Velocities (m/s, world frame) count only where kind is kVelocity.
// After `deadline` the HAL makes every robot hold on its own: a controller that died must not fly on.
struct CommandColumns {
  std::span<const CommandKind> kind;
  std::span<const float> vx, vy, vz;
  Time deadline{0};
  std::uint64_t sequence = 0;  // strictly increasing from 1 on; begins anew with each activation
};

// Where a HAL tells what it has encoded, decoded again: as in CommandColumns.
struct EchoColumns {
  std::span<CommandKind> kind;
  std::span<float> vx, vy, vz;  // looked at only where kind is kVelocity
};

// Every drop has a counter.
struct HalCounters {
  std::atomic<std::uint64_t> reads{0};
  std::atomic<std::uint64_t> writes{0};
  std::atomic<std::uint64_t> refused_calls{0};     // wrong state or wrong size, set-up calls included
  std::atomic<std::uint64_t> refused_commands{0};  // one a robot: not finite, expired, or out of sequence
  std::atomic<std::uint64_t> misencoded{0};        // writes in which some robot's command was
};

class Hal {
 public:
  Hal() = default;
  Hal(const Hal&) = delete;
  Hal& operator=(const Hal&) = delete;
  virtual ~Hal() = default;

  // Opens links, checks robots, allocates. Once, before anything else; after a failure it may be tried again.
  Result<void> configure();
  // Robots may move from here on.
  Result<void> activate(Time now);
  // Fills the state of every robot, as known at `now`.
  HalResult read(Time now, const StateColumns& states) noexcept;
  // Hands one command to each robot. `now` is compared with the deadline.
  HalResult write(Time now, const CommandColumns& commands) noexcept;
  // Makes every robot safe (hold, land or stop: the device's own choice), then lets go of it. Idempotent, and
  // harmless in every state; if it fails the HAL stays active, so that it can be tried again.
  Result<void> deactivate(Time now);

  HalState state() const noexcept { return state_; }
  const HalCounters& counters() const noexcept { return counters_; }
  // Fixed after configure().
  virtual std::span<const RobotInfo> robots() const noexcept = 0;
  virtual std::string_view name() const noexcept = 0;

 protected:
  virtual Result<void> do_configure() = 0;
  virtual Result<void> do_activate(Time now) = 0;
  // Every column is exactly as long as robots().
  virtual HalResult do_read(Time now, const StateColumns& states) noexcept = 0;
  // `commands` are in sequence, of the right length, finite and not expired: the base class has replaced or
  // refused the rest.
  virtual HalResult do_write(Time now, const CommandColumns& commands) noexcept = 0;
  virtual Result<void> do_deactivate(Time now) = 0;
  // Decodes what the last do_write() encoded for the robots, which write() then compares with what it was
  // given, whatever the HAL. The result is by how much a velocity may differ for the encoding's sake, m/s;
  // nothing where nothing is encoded: then the columns are not looked at.
  virtual std::optional<float> do_decode(const EchoColumns&) noexcept { return std::nullopt; }
  // A command was refused whole, out of sequence; do_write() does not see it.
  virtual void on_refused() noexcept {}

 private:
  HalResult refuse_call(HalFault fault, std::string_view cause) noexcept;
  // Fills kinds_ with what may be written, and says what had to be replaced.
  HalResult sanitise(Time now, const CommandColumns& commands) noexcept;
  HalResult check_encoding(const CommandColumns& commands) noexcept;

  HalState state_ = HalState::kCreated;
  HalCounters counters_;
  std::uint64_t last_sequence_ = 0;
  std::vector<CommandKind> kinds_;  // the commands as they will be written: `hold` where one was refused
  std::vector<CommandKind> echo_kind_;
  std::vector<float> echo_vx_, echo_vy_, echo_vz_;
};

}  // namespace mayfly
