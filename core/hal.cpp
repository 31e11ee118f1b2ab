#include "core/hal.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {

namespace {

void count(std::atomic<std::uint64_t>& counter, std::uint64_t how_many = 1) noexcept {
  counter.fetch_add(how_many, std::memory_order_relaxed);
}

template <class... Columns>
bool long_enough(std::size_t size, const Columns&... columns) noexcept {
  return ((columns.size() >= size) && ...);
}

StateColumns first(std::size_t n, const StateColumns& s) noexcept {
  return {s.x.first(n),     s.y.first(n),     s.z.first(n),
          s.vx.first(n),    s.vy.first(n),    s.vz.first(n),
          s.stamp.first(n), s.valid.first(n), s.telemetry.empty() ? s.telemetry : s.telemetry.first(n)};
}

bool is_finite(const CommandColumns& c, std::size_t robot) noexcept {
  return std::isfinite(c.vx[robot]) && std::isfinite(c.vy[robot]) && std::isfinite(c.vz[robot]);
}

}  // namespace

Result<void> Hal::configure() {
  if (state_ != HalState::kCreated) {
    count(counters_.refused_calls);
    return fail(Cause::kCaller, std::string(name()) + ": configure() was called twice");
  }
  if (auto done = do_configure(); !done) {
    return done;
  }
  const std::size_t size = robots().size();
  kinds_.assign(size, CommandKind::kHold);
  echo_kind_.assign(size, CommandKind::kNone);
  for (std::vector<float>* column : {&echo_vx_, &echo_vy_, &echo_vz_}) {
    column->assign(size, 0.0F);
  }
  state_ = HalState::kConfigured;
  return {};
}

Result<void> Hal::activate(Time now) {
  if (state_ != HalState::kConfigured && state_ != HalState::kInactive) {
    count(counters_.refused_calls);
    return fail(Cause::kCaller,
                std::string(name()) + (state_ == HalState::kActive ? ": activate() while it is active"
                                                                   : ": activate() before configure()"));
  }
  if (auto done = do_activate(now); !done) {
    return done;
  }
  last_sequence_ = 0;
  state_ = HalState::kActive;
  return {};
}

HalResult Hal::read(Time now, const StateColumns& states) noexcept {
  if (state_ != HalState::kActive) {
    return refuse_call(HalFault::kWrongState, "read() while not active");
  }
  const std::size_t size = kinds_.size();
  if (!long_enough(size, states.x, states.y, states.z, states.vx, states.vy, states.vz, states.stamp,
                   states.valid) ||
      (!states.telemetry.empty() && states.telemetry.size() < size)) {
    return refuse_call(HalFault::kWrongSize, "a state column is shorter than robots()");
  }
  count(counters_.reads);
  return do_read(now, first(size, states));
}

HalResult Hal::write(Time now, const CommandColumns& commands) noexcept {
  if (state_ != HalState::kActive) {
    return refuse_call(HalFault::kWrongState, "write() while not active");
  }
  const std::size_t size = kinds_.size();
  if (!long_enough(size, commands.kind, commands.vx, commands.vy, commands.vz)) {
    return refuse_call(HalFault::kWrongSize, "a command column is shorter than robots()");
  }
  if (commands.sequence <= last_sequence_) {
    count(counters_.refused_commands, size);
    on_refused();
    return {HalFault::kOutOfSequence, kEveryRobot, {}, "the command's sequence number is not above the last"};
  }
  last_sequence_ = commands.sequence;
  const HalResult cleaned = sanitise(now, commands);
  count(counters_.writes);
  const HalResult written = do_write(now, {kinds_, commands.vx.first(size), commands.vy.first(size),
                                           commands.vz.first(size), commands.deadline, commands.sequence});
  // A robot that was told something else is worse than a device that complains, and that is worse than what
  // was mended here; the counters tell of all.
  const HalResult encoded = check_encoding(commands);
  if (!encoded.ok()) {
    return encoded;
  }
  return written.ok() ? cleaned : written;
}

Result<void> Hal::deactivate(Time now) {
  if (state_ != HalState::kActive) {
    return {};
  }
  if (auto done = do_deactivate(now); !done) {
    return done;
  }
  state_ = HalState::kInactive;
  return {};
}

HalResult Hal::refuse_call(HalFault fault, std::string_view cause) noexcept {
  count(counters_.refused_calls);
  return {fault, kEveryRobot, {}, cause};
}

HalResult Hal::sanitise(Time now, const CommandColumns& commands) noexcept {
  if (now > commands.deadline) {
    std::fill(kinds_.begin(), kinds_.end(), CommandKind::kHold);
    count(counters_.refused_commands, kinds_.size());
    return {HalFault::kExpired, kEveryRobot, {}, "the command's deadline had passed"};
  }
  HalResult result;
  for (std::size_t robot = 0; robot < kinds_.size(); ++robot) {
    kinds_[robot] = commands.kind[robot];
    if (kinds_[robot] != CommandKind::kVelocity || is_finite(commands, robot)) {
      continue;
    }
    kinds_[robot] = CommandKind::kHold;
    count(counters_.refused_commands);
    if (result.ok()) {
      result = {HalFault::kNotFinite, static_cast<RobotIndex>(robot), robots()[robot].link,
                "a velocity that is not a finite number"};
    }
  }
  return result;
}

HalResult Hal::check_encoding(const CommandColumns& commands) noexcept {
  const std::optional<float> rounding = do_decode({echo_kind_, echo_vx_, echo_vy_, echo_vz_});
  if (!rounding) {
    return {};
  }
  // What is no number is not near.
  const auto near = [&](float a, float b) { return std::fabs(a - b) <= *rounding; };
  for (std::size_t robot = 0; robot < kinds_.size(); ++robot) {
    const bool same = echo_kind_[robot] == kinds_[robot] && (kinds_[robot] != CommandKind::kVelocity ||
                                                             (near(echo_vx_[robot], commands.vx[robot]) &&
                                                              near(echo_vy_[robot], commands.vy[robot]) &&
                                                              near(echo_vz_[robot], commands.vz[robot])));
    if (!same) {
      count(counters_.misencoded);
      return {HalFault::kMisencoded, static_cast<RobotIndex>(robot), robots()[robot].link,
              "what was encoded for the robot does not decode to its command"};
    }
  }
  return {};
}

}  // namespace mayfly
