#include "controller/link/shm_hal.hpp"

#include <algorithm>
#include <utility>

namespace mayfly::link {
namespace {

using namespace std::chrono_literals;

// A guard reads the cached world and opens its buses: seconds. It brakes, lands and lets go: seconds, too.
constexpr Time kMostStart = 120s;
constexpr Time kMostEnd = 20s;
constexpr Time kLook = 2ms;  // between two looks at its phase while it is waited for

constexpr std::string_view kLink = "guard";
constexpr std::string_view kSilent = "the guard's heartbeat is missing";
constexpr std::string_view kLost = "the guard's process has ended: robots are left to their own watchdogs";
constexpr std::string_view kTooMany = "more kinds of faults than are told apart";

}  // namespace

ShmHal::ShmHal(ShmHalConfig config, PlannerEnd end, const ProcessWatch& guard)
    : config_(std::move(config)), end_(std::move(end)), guard_(guard) {
  texts_.reserve(kMostTexts);
  events_.reserve(kMostEvents);
  sent_kind_.assign(config_.robots.size(), CommandKind::kHold);
}

// Set-up calls may block, the loop's may not: see core/hal.hpp.
Result<void> ShmHal::wait_for(Phase phase, Time now, Time most) {
  for (Time waited{0}; end_.phase() < phase; waited += kLook) {
    const bool stopped = config_.asked_to_stop != nullptr && config_.asked_to_stop->load() > 0;
    if (stopped && phase < Phase::kEnding) {
      return fail(Cause::kDevice, "stopped before the guard was ready");
    }
    // In this order: a guard that has ended may have said what was waited for before.
    if (guard_.has_ended(kLook) && end_.phase() < phase) {
      return fail(Cause::kDevice, "the guard's process ended before it was " +
                                      std::string(phase < Phase::kEnding ? "ready" : "done"));
    }
    if (waited > most) {
      return fail(Cause::kDevice,
                  "the guard takes longer than " + std::to_string(static_cast<int>(to_seconds(most))) + " s");
    }
    send_hold(now);
  }
  return {};
}

// So that a guard that begins to fly before its planner has decided anything has something to go by. It lives
// no longer than the guard lets it.
void ShmHal::send_hold(Time now) noexcept {
  std::fill(end_.wish().kind.begin(), end_.wish().kind.end(), static_cast<std::uint8_t>(CommandKind::kHold));
  end_.send_wish(now, now + kMostStart);
}

Result<void> ShmHal::do_configure() {
  if (config_.robots.size() != end_.segment().robots()) {
    return fail(Cause::kCaller, "the segment was made for " + std::to_string(end_.segment().robots()) +
                                    " robots, not for " + std::to_string(config_.robots.size()));
  }
  return wait_for(Phase::kReady, Time(0), kMostStart);
}

Result<void> ShmHal::do_activate(Time now) {
  send_hold(now);
  end_.want(Want::kFly);
  if (auto flies = wait_for(Phase::kActive, now, kMostStart); !flies) {
    return flies;
  }
  seen_ = now;
  return {};
}

HalResult ShmHal::do_read(Time now, const StateColumns& states) noexcept {
  const int asked = config_.asked_to_stop == nullptr ? 0 : config_.asked_to_stop->load();
  stop_.store(lost() ? std::max(asked, 2) : asked, std::memory_order_relaxed);
  end_.beat();
  if (end_.collect()) {
    seen_ = now;
    copy_view(states);
  } else {
    std::fill(states.valid.begin(), states.valid.end(), std::uint8_t{0});
  }
  const HalResult happened = hear_events();
  const HalResult down = link_state(now);
  return down.ok() ? happened : down;
}

// All that has come: reactions are kept, and the first of the HAL's results is told now, the others with the
// next reads.
HalResult ShmHal::hear_events() noexcept {
  while (const auto event = end_.next_event()) {
    if (event->fault != static_cast<std::uint32_t>(HalFault::kNone)) {
      return told(*event);
    }
    if (events_.size() < kMostEvents && event->symptom < kSymptoms && event->severity < kSeverities) {
      events_.push_back({Time(event->time_ns), event->robot, static_cast<Symptom>(event->symptom),
                         static_cast<Severity>(event->severity)});
    }
  }
  return {};
}

void ShmHal::ask_to_stop(int level) noexcept {
  end_.request_stop(static_cast<StopLevel>(std::clamp(level, 0, 2)));
}

Severity ShmHal::severity() const noexcept {
  std::uint8_t worst = 0;
  for (const std::uint8_t one : end_.view().severity) {
    worst = std::max(worst, one);
  }
  return static_cast<Severity>(std::min<std::uint8_t>(worst, kSeverities - 1));
}

CommandColumns ShmHal::written() const noexcept {
  const ViewColumns& view = end_.view();
  return {sent_kind_, view.sent_vx, view.sent_vy, view.sent_vz, Time(view.head->time_ns), view.head->tick};
}

void ShmHal::copy_view(const StateColumns& states) noexcept {
  const ViewColumns& view = end_.view();
  const std::array<std::pair<std::span<const float>, std::span<float>>, 6> columns{
      std::pair{view.x, states.x},   std::pair{view.y, states.y},   std::pair{view.z, states.z},
      std::pair{view.vx, states.vx}, std::pair{view.vy, states.vy}, std::pair{view.vz, states.vz}};
  for (std::size_t robot = 0; robot < states.valid.size(); ++robot) {
    sent_kind_[robot] = view.kind[robot] > static_cast<std::uint8_t>(CommandKind::kStop)
                            ? CommandKind::kNone
                            : static_cast<CommandKind>(view.kind[robot]);
    states.valid[robot] = view.fresh[robot] != 0 ? 1 : 0;
    for (const auto& [from, to] : columns) {
      to[robot] = from[robot];
    }
    states.stamp[robot] = Time(view.stamp_ns[robot]);
  }
  for (std::size_t robot = 0; robot < states.telemetry.size(); ++robot) {
    states.telemetry[robot] = {Time(view.heard_ns[robot]), view.battery[robot], view.link_quality[robot],
                               view.airborne[robot] != 0};
  }
}

HalResult ShmHal::link_state(Time now) const noexcept {
  if (lost()) {
    return {HalFault::kLinkDown, kEveryRobot, kLink, kLost};
  }
  if (now - seen_ > kMostMissing * config_.period) {
    return {HalFault::kLinkDown, kEveryRobot, kLink, kSilent};
  }
  return {};
}

HalResult ShmHal::told(const Event& event) noexcept {
  const auto fault = event.fault > static_cast<std::uint32_t>(HalFault::kGivenUp)
                         ? HalFault::kLinkDown
                         : static_cast<HalFault>(event.fault);
  auto text = std::find_if(texts_.begin(), texts_.end(), [&](const Text& known) {
    return known.link == event.link && known.cause == event.cause;
  });
  if (text == texts_.end()) {
    if (texts_.size() == kMostTexts) {
      return {fault, event.robot, kLink, kTooMany};
    }
    texts_.push_back({event.link, event.cause});
    text = texts_.end() - 1;
  }
  return {fault, event.robot, text->link.data(), text->cause.data()};
}

HalResult ShmHal::do_write(Time now, const CommandColumns& commands) noexcept {
  WishColumns& wish = end_.wish();
  for (std::size_t robot = 0; robot < wish.kind.size(); ++robot) {
    wish.kind[robot] = static_cast<std::uint8_t>(commands.kind[robot]);
  }
  std::copy(commands.vx.begin(), commands.vx.end(), wish.vx.begin());
  std::copy(commands.vy.begin(), commands.vy.end(), wish.vy.begin());
  std::copy(commands.vz.begin(), commands.vz.end(), wish.vz.begin());
  end_.send_wish(now, commands.deadline);
  return link_state(now);
}

// As the guard will read it, and exactly.
std::optional<float> ShmHal::do_decode(const EchoColumns& to) noexcept {
  const std::optional<WishColumns> sent = end_.sent();
  if (!sent) {
    std::fill(to.kind.begin(), to.kind.end(), CommandKind::kNone);
    return 0.0F;
  }
  for (std::size_t robot = 0; robot < to.kind.size(); ++robot) {
    to.kind[robot] = static_cast<CommandKind>(sent->kind[robot]);
  }
  std::copy(sent->vx.begin(), sent->vx.end(), to.vx.begin());
  std::copy(sent->vy.begin(), sent->vy.end(), to.vy.begin());
  std::copy(sent->vz.begin(), sent->vz.end(), to.vz.begin());
  return 0.0F;
}

// A guard that is lost cannot be asked to let go, and nothing is left to do from here: lost() tells.
Result<void> ShmHal::do_deactivate(Time now) {
  end_.want(Want::kEnd);
  if (auto ended = wait_for(Phase::kEnded, now, kMostEnd); !ended && !lost()) {
    if (!guard_.has_ended()) {
      return ended;
    }
    guard_ended();
  }
  static_cast<void>(end_.collect());
  static_cast<void>(hear_events());
  return {};
}

}  // namespace mayfly::link
