#include "controller/safety/reactions.hpp"

#include <algorithm>

namespace mayfly {
namespace {

// Of one tick; what is more is counted.
constexpr std::size_t kMostBegun = 1024;

}  // namespace

void Reactions::Level::add(Severity severity) noexcept {
  due = std::max(due, severity);
  if (severity >= Severity::kHoldAll) {
    latched = std::max(latched, severity);
  }
}

void Reactions::Level::acknowledge() noexcept {
  latched = due >= Severity::kHoldAll ? due : Severity::kNone;
}

Reactions::Reactions(std::span<const Robot> robots, std::span<const ReactionRow> table)
    : table_(table),
      robots_(robots.begin(), robots.end()),
      slot_of_(robots.size()),
      own_(robots.size()),
      link_(std::max<std::size_t>(robots.size(), 1)),
      severities_(robots.size(), Severity::kNone) {
  std::uint32_t slots = 0;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    slot_of_[i] = slots;
    slots += robots[i].watched ? 1U : 0U;
  }
  slots_.resize(slots);
  begun_.reserve(kMostBegun);
  for (std::size_t s = 0; s < kSymptoms; ++s) {
    const auto is_its = [s](const ReactionRow& row) { return static_cast<std::size_t>(row.symptom) == s; };
    const auto first = std::find_if(table_.begin(), table_.end(), is_its);
    rows_[s] = {first, std::find_if_not(first, table_.end(), is_its)};
  }
}

void Reactions::tick(Time now, std::span<const Symptoms> robots, Symptoms everybody) noexcept {
  const Time passed = has_begun_ ? std::max(now - last_, Time{0}) : Time{0};
  has_begun_ = true;
  last_ = now;
  begun_.clear();
  all_.begin_tick();
  for (Level& level : link_) {
    level.begin_tick();
  }
  for (RobotIndex i = 0; i < robots_.size(); ++i) {
    own_[i].begin_tick();
    if (robots_[i].watched) {
      follow(i, slots_[slot_of_[i]], i < robots.size() ? robots[i] : Symptoms{}, passed);
    }
  }
  follow(kEveryRobot, everybody_, everybody, passed);
  combine();
}

void Reactions::follow(RobotIndex robot, Slot& slot, Symptoms shown, Time passed) noexcept {
  if (slot.kept.empty() && shown.empty()) {
    return;
  }
  Symptoms kept;
  for (std::size_t s = 0; s < kSymptoms; ++s) {
    const auto symptom = static_cast<Symptom>(s);
    const bool shows = shown.has(symptom);
    const bool was_kept = slot.kept.has(symptom);
    if (!shows && !was_kept) {
      continue;
    }
    counters_.by_symptom[s] += shows ? 1U : 0U;
    if (still_counts(slot.tracks[s], symptom, shows, passed, was_kept)) {
      kept.add(symptom);
      react(robot, symptom, slot.tracks[s]);
    }
  }
  slot.kept = kept;
}

bool Reactions::still_counts(Track& track, Symptom symptom, bool shows, Time passed, bool was_kept) noexcept {
  if (!was_kept) {
    track = {.times = 1};
    return true;
  }
  if (!shows) {
    track.healthy += passed;
    return track.healthy < info_of(symptom).forgets;
  }
  track.accrued += passed;
  track.healthy = Time{0};
  track.times += track.times < UINT32_MAX ? 1U : 0U;
  return true;
}

void Reactions::react(RobotIndex robot, Symptom symptom, Track& track) noexcept {
  if (track.healthy > Time{0} && track.healthy >= info_of(symptom).clears) {
    track.due = 0;
    return;
  }
  std::uint32_t bit = 1;
  for (const ReactionRow& row : rows_[static_cast<std::size_t>(symptom)]) {
    const bool is_due = track.accrued >= row.after && track.times >= static_cast<std::uint32_t>(row.times);
    if (is_due && (track.due & bit) == 0) {
      track.due |= bit;
      ++counters_.begun[static_cast<std::size_t>(row.severity)];
      if (begun_.size() < kMostBegun) {
        begun_.push_back({robot, symptom, row.severity, row.scope});
      } else {
        ++counters_.unlisted;
      }
    }
    bit <<= 1U;
    if (!is_due) {
      continue;
    }
    if (robot == kEveryRobot || row.scope == Scope::kEverybody) {
      all_.add(row.severity);
    } else if (row.scope == Scope::kLink) {
      link_[robots_[robot].link].add(row.severity);
    } else {
      own_[robot].add(row.severity);
    }
  }
}

void Reactions::combine() noexcept {
  worst_ = robots_.empty() ? all_.now() : Severity::kNone;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    severities_[i] = std::max({own_[i].now(), link_[robots_[i].link].now(), all_.now()});
    worst_ = std::max(worst_, severities_[i]);
  }
}

Severity Reactions::everybodys() const noexcept {
  return all_.now();
}

// A symptom that is gone leaves nothing behind, so that it is not escalated the moment it comes again.
void Reactions::forget_healthy(Slot& slot) noexcept {
  Symptoms kept;
  for (std::size_t s = 0; s < kSymptoms; ++s) {
    const auto symptom = static_cast<Symptom>(s);
    if (slot.kept.has(symptom) && (slot.tracks[s].due != 0 || slot.tracks[s].healthy == Time{0})) {
      kept.add(symptom);
    }
  }
  slot.kept = kept;
}

Severity Reactions::acknowledge() noexcept {
  all_.acknowledge();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    link_[i].acknowledge();
    own_[i].acknowledge();
  }
  for (Slot& slot : slots_) {
    forget_healthy(slot);
  }
  forget_healthy(everybody_);
  combine();
  return worst_;
}

}  // namespace mayfly
