#include "simulate/bad_wishes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace mayfly::simulate {
namespace {

constexpr std::size_t kKept = 256;  // wishes

bool is_of_the_planner(const FaultSpec& fault) {
  return fault_row(fault.kind).place == FaultPlace::kPlanner;
}

// A direction of all, new at every tick and for every agent (SplitMix64's mixing, Steele et al. 2014).
std::array<float, 3> any_direction(std::uint64_t seed, std::uint64_t tick, std::uint64_t who) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15U * (tick + 1) + 0xD1B54A32D192ED03U * (who + 1);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  const double up = 2.0 * static_cast<double>(z >> 32U) * 0x1p-32 - 1.0;
  const double angle = 2.0 * std::numbers::pi * static_cast<double>(z & 0xFFFFFFFFU) * 0x1p-32;
  const double level = std::sqrt(std::max(0.0, 1.0 - up * up));
  return {static_cast<float>(level * std::cos(angle)), static_cast<float>(level * std::sin(angle)),
          static_cast<float>(up)};
}

}  // namespace

void BadWishes::Wish::copy(Time now, const CommandColumns& from) noexcept {
  std::copy(from.kind.begin(), from.kind.end(), kind.begin());
  std::copy(from.vx.begin(), from.vx.end(), x.begin());
  std::copy(from.vy.begin(), from.vy.end(), y.begin());
  std::copy(from.vz.begin(), from.vz.end(), z.begin());
  made = now;
  deadline = from.deadline;
  sequence = from.sequence;
}

BadWishes::BadWishes(const Scenario& scenario, GuardPort& guard) : guard_(guard), seed_(scenario.seed) {
  std::copy_if(scenario.faults.begin(), scenario.faults.end(), std::back_inserter(faults_),
               is_of_the_planner);
}

bool BadWishes::has_any(const Scenario& scenario) {
  return std::any_of(scenario.faults.begin(), scenario.faults.end(), is_of_the_planner);
}

Result<void> BadWishes::do_configure() {
  if (auto done = guard_.configure(); !done) {
    return done;
  }
  const std::size_t n = guard_.robots().size();
  const std::vector<float> zeros(n);
  newest_ = {std::vector<CommandKind>(n), zeros, zeros, zeros};
  past_.assign(kKept, newest_);
  return {};
}

Result<void> BadWishes::do_activate(Time now) {
  if (!started_) {
    started_ = true;
    origin_ = now;
  }
  newest_.sequence = 0;
  for (Wish& wish : past_) {
    wish.sequence = 0;
  }
  return guard_.activate(now);
}

HalResult BadWishes::do_write(Time now, const CommandColumns& wish) noexcept {
  if (on(FaultKind::kPlannerStall, now) != nullptr && newest_.sequence > 0) {
    newest_.sequence = wish.sequence;
    return guard_.write(now, newest_.columns());
  }
  newest_.copy(now, wish);
  spoil(now);
  last_ = (last_ + 1) % past_.size();
  past_[last_].copy(now, newest_.columns());
  HalResult replayed;
  if (const FaultSpec* fault = on(FaultKind::kCommandReplay, now)) {
    replayed = replay(now, from_seconds(fault->size));
  }
  const HalResult written = guard_.write(now, newest_.columns());
  return written.ok() ? replayed : written;
}

const FaultSpec* BadWishes::on(FaultKind kind, Time now) const noexcept {
  const auto found = std::find_if(faults_.begin(), faults_.end(), [&](const FaultSpec& fault) {
    return fault.kind == kind && fault.is_on(to_seconds(now - origin_));
  });
  return found == faults_.end() ? nullptr : &*found;
}

void BadWishes::spoil(Time now) noexcept {
  for (const FaultSpec& fault : faults_) {
    const bool alters = fault.kind == FaultKind::kPlannerNan || fault.kind == FaultKind::kPlannerAbsurd;
    if (alters && fault.is_on(to_seconds(now - origin_))) {
      spoil(fault, newest_.sequence);
    }
  }
}

void BadWishes::spoil(const FaultSpec& fault, std::uint64_t tick) noexcept {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const bool nan = fault.kind == FaultKind::kPlannerNan;
  const auto size = static_cast<float>(fault.size);
  for (const StruckAgents& range : fault.agents) {
    for (std::size_t a = range.first; a < range.first + range.count; ++a) {
      const auto way = any_direction(seed_, tick, a);
      newest_.x[a] = nan ? kNan : size * way[0];
      newest_.y[a] = nan ? kNan : size * way[1];
      newest_.z[a] = nan ? kNan : size * way[2];
    }
  }
}

// The newest that is old enough; nothing before there is one.
HalResult BadWishes::replay(Time now, Time age) noexcept {
  for (std::size_t back = 1; back < past_.size(); ++back) {
    const Wish& wish = past_[(last_ + past_.size() - back) % past_.size()];
    if (wish.sequence > 0 && now - wish.made >= age) {
      CommandColumns columns = wish.columns();
      columns.deadline = newest_.deadline;
      return guard_.write(now, columns);
    }
  }
  return {};
}

}  // namespace mayfly::simulate
