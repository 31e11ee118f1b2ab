#include "controller/guard/wish_desk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mayfly {
namespace {

// Of what a robot can do. Models that move agents apart at once wish for some ten times that.
constexpr float kAbsurdShare = 100.0F;

}  // namespace

WishDesk::WishDesk(std::size_t robots, Time most_age, std::vector<float> limits)
    : most_age_(most_age),
      limits_(std::move(limits)),
      kind_(robots, CommandKind::kNone),
      vx_(robots),
      vy_(robots),
      vz_(robots),
      symptoms_(robots) {}

void WishDesk::reset() noexcept {
  sequence_ = 0;
  is_stalled_ = true;
  was_refused_ = false;
  everybody_ = {};
  std::fill(kind_.begin(), kind_.end(), CommandKind::kNone);
  std::fill(symptoms_.begin(), symptoms_.end(), Symptoms{});
}

void WishDesk::refuse() noexcept {
  was_refused_ = true;
  ++counters_.refused;
}

void WishDesk::judge(Time now, const CommandColumns& wish) noexcept {
  everybody_ = {};
  if (was_refused_) {
    everybody_.add(Symptom::kCommandRefused);
    was_refused_ = false;
  }
  if (wish.sequence != sequence_ && !is_in_order(wish)) {
    everybody_.add(Symptom::kCommandRefused);
    ++counters_.refused;
  } else if (wish.sequence > sequence_) {
    take(now, wish);
  }
  is_stalled_ = sequence_ == 0 || now > deadline_;
  if (is_stalled_) {
    everybody_.add(Symptom::kPlannerStalled);
    ++counters_.stalled;
  }
}

bool WishDesk::is_in_order(const CommandColumns& wish) const noexcept {
  const std::size_t least = std::min({wish.kind.size(), wish.vx.size(), wish.vy.size(), wish.vz.size()});
  return wish.sequence > sequence_ && least >= kind_.size();
}

void WishDesk::take(Time now, const CommandColumns& wish) noexcept {
  ++counters_.taken;
  sequence_ = wish.sequence;
  deadline_ = std::min(wish.deadline, now + most_age_);
  for (std::size_t robot = 0; robot < kind_.size(); ++robot) {
    take_robot(robot, wish);
  }
}

// A velocity that is not a number is told whatever the kind: Hal::write, through which a wish has come, has
// made it a hold.
void WishDesk::take_robot(std::size_t robot, const CommandColumns& wish) noexcept {
  symptoms_[robot] = {};
  kind_[robot] = wish.kind[robot];
  if (kind_[robot] > CommandKind::kStop) {
    kind_[robot] = CommandKind::kNone;
    symptoms_[robot].add(Symptom::kCommandRefused);
    ++counters_.unknown_kind;
    return;
  }
  const bool may_move = kind_[robot] == CommandKind::kVelocity || kind_[robot] == CommandKind::kHold;
  if (may_move &&
      !(std::isfinite(wish.vx[robot]) && std::isfinite(wish.vy[robot]) && std::isfinite(wish.vz[robot]))) {
    kind_[robot] = CommandKind::kNone;
    symptoms_[robot].add(Symptom::kCommandNotFinite);
    ++counters_.not_finite;
    return;
  }
  if (kind_[robot] == CommandKind::kVelocity && is_absurd(robot, wish)) {
    symptoms_[robot].add(Symptom::kCommandAbsurd);
    ++counters_.absurd;
  }
  vx_[robot] = wish.vx[robot];
  vy_[robot] = wish.vy[robot];
  vz_[robot] = wish.vz[robot];
}

bool WishDesk::is_absurd(std::size_t robot, const CommandColumns& wish) const noexcept {
  return !limits_.empty() &&
         std::hypot(wish.vx[robot], wish.vy[robot], wish.vz[robot]) > kAbsurdShare * limits_[robot];
}

}  // namespace mayfly
