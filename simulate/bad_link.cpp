#include "simulate/bad_link.hpp"

#include <algorithm>

namespace mayfly::simulate {
namespace {

constexpr std::size_t kKept = 256;  // commands
constexpr Time kReplayed = std::chrono::milliseconds(500);

}  // namespace

void BadLink::Command::copy(Time now, const CommandColumns& from) noexcept {
  std::copy(from.kind.begin(), from.kind.end(), kind.begin());
  std::copy(from.vx.begin(), from.vx.end(), x.begin());
  std::copy(from.vy.begin(), from.vy.end(), y.begin());
  std::copy(from.vz.begin(), from.vz.end(), z.begin());
  written = now;
  deadline = from.deadline;
  sequence = from.sequence;
}

Result<void> BadLink::do_configure() {
  if (auto done = hal_.configure(); !done) {
    return done;
  }
  const std::size_t n = hal_.robots().size();
  last_ = {std::vector<CommandKind>(n),
           std::vector<float>(n),
           std::vector<float>(n),
           std::vector<float>(n),
           {},
           {},
           0};
  past_.assign(kKept, last_);
  return {};
}

Result<void> BadLink::do_activate(Time now) {
  if (!started_) {
    started_ = true;
    origin_ = now;
  }
  last_.sequence = 0;
  for (Command& command : past_) {
    command.sequence = 0;
  }
  return hal_.activate(now);
}

HalResult BadLink::do_write(Time now, const CommandColumns& commands) noexcept {
  if (is_on(FaultKind::kPlannerStall, now) && last_.sequence > 0) {
    return hal_.write(now, last_.columns());
  }
  last_.copy(now, commands);
  newest_ = (newest_ + 1) % past_.size();
  past_[newest_].copy(now, commands);
  const HalResult written = hal_.write(now, commands);
  const HalResult replayed =
      is_on(FaultKind::kCommandReplay, now) ? replay(now, commands.deadline) : HalResult{};
  return written.ok() ? replayed : written;
}

bool BadLink::is_on(FaultKind kind, Time now) const noexcept {
  return std::any_of(faults_.begin(), faults_.end(), [&](const FaultSpec& fault) {
    return fault.kind == kind && fault.is_on(to_seconds(now - origin_));
  });
}

// The newest that is old enough.
HalResult BadLink::replay(Time now, Time fresh_deadline) noexcept {
  for (std::size_t age = 0; age < past_.size(); ++age) {
    const Command& command = past_[(newest_ + past_.size() - age) % past_.size()];
    if (command.sequence > 0 && now - command.written >= kReplayed) {
      CommandColumns columns = command.columns();
      columns.deadline = fresh_deadline;
      return hal_.write(now, columns);
    }
  }
  return {};
}

}  // namespace mayfly::simulate
