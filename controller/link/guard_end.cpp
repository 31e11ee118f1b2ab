#include "controller/link/guard_end.hpp"

#include <algorithm>
#include <utility>

namespace mayfly::link {
namespace {

constexpr Time kPast{-1};
constexpr auto kLastKind = static_cast<std::uint8_t>(CommandKind::kStop);

}  // namespace

Result<GuardEnd> GuardEnd::make(Segment segment, Time most_age) {
  auto lease = take_lease(segment.header(), segment.header().guard, "guard");
  if (!lease) {
    return fail(std::move(lease.error()));
  }
  // Whose wishes count is settled here, before any is read, and not asked of the memory again.
  const Word owner = segment.header().planner.load();
  if (owner == 0) {
    return fail(Cause::kEnvironment, "this link has no planner: nobody would own the commands");
  }
  return GuardEnd(std::move(segment), owner, most_age);
}

GuardEnd::GuardEnd(Segment segment, Word owner, Time most_age)
    : segment_(std::move(segment)),
      most_age_(most_age),
      wishes_(segment_.wish(), segment_.layout().wish),
      operators_(segment_.operators(), segment_.layout().operators),
      views_(segment_.view(), segment_.layout().view),
      events_(segment_.events(), segment_.layout().events),
      view_block_(segment_.layout().view.bytes),
      kind_(segment_.robots(), CommandKind::kNone),
      vx_(segment_.robots()),
      vy_(segment_.robots()),
      vz_(segment_.robots()),
      owner_(owner) {
  Cutter cutter(view_block_.data());
  view_ = view_columns(cutter, segment_.robots());
}

CommandColumns GuardEnd::wish(Time now) noexcept {
  if (!planner_gone_) {
    take_operator();
    if (wishes_.collect()) {
      take_wish(now);
    }
  }
  return {kind_, vx_, vy_, vz_, deadline_, sequence_};
}

void GuardEnd::take_wish(Time now) noexcept {
  Cutter cutter(wishes_.latest().data());
  const WishColumns wish = wish_columns(cutter, segment_.robots());
  if (wish.head->owner != owner_ || wish.head->sequence <= sequence_) {
    others_ += wish.head->owner != owner_ ? 1U : 0U;
    ++refused_;
    return;
  }
  ++taken_;
  sequence_ = wish.head->sequence;
  // Within what may be told from `now` without overflow, too.
  issued_ = std::clamp(Time(wish.head->issued_ns), Time(0), std::max(now, Time(0)));
  deadline_ = std::clamp(Time(wish.head->deadline_ns), kPast, now + most_age_);
  for (std::size_t robot = 0; robot < kind_.size(); ++robot) {
    const bool known = wish.kind[robot] <= kLastKind;
    refused_ += known ? 0U : 1U;
    kind_[robot] = known ? static_cast<CommandKind>(wish.kind[robot]) : CommandKind::kNone;
  }
  std::copy(wish.vx.begin(), wish.vx.end(), vx_.begin());
  std::copy(wish.vy.begin(), wish.vy.end(), vy_.begin());
  std::copy(wish.vz.begin(), wish.vz.end(), vz_.begin());
}

void GuardEnd::take_operator() noexcept {
  if (!operators_.collect()) {
    return;
  }
  Cutter cutter(operators_.latest().data());
  const OperatorColumns request = operator_columns(cutter, segment_.robots());
  if (request.head->owner != owner_) {
    ++others_;
    ++refused_;
    return;
  }
  // A level that there is not is taken for the highest: whoever garbles a request to stop wants to stop.
  stop_ = static_cast<StopLevel>(
      std::min(request.head->stop, static_cast<std::uint32_t>(StopLevel::kEmergencyStop)));
  acknowledged_ = request.head->acknowledged;
}

bool GuardEnd::has_one_owner() noexcept {
  const bool heard_another = others_ != others_told_;
  others_told_ = others_;
  return !heard_another && segment_.header().planner.load(std::memory_order_relaxed) == owner_;
}

std::uint64_t GuardEnd::leases_refused() const noexcept {
  return segment_.header().leases_refused.load(std::memory_order_relaxed);
}

// A wish of its own number: whoever has taken the last one need not look at its deadline again.
void GuardEnd::planner_gone() noexcept {
  planner_gone_ = true;
  ++sequence_;
  deadline_ = kPast;
  std::fill(kind_.begin(), kind_.end(), CommandKind::kNone);
}

CommandColumns GuardEnd::hold(Time now) noexcept {
  planner_gone();
  deadline_ = now + most_age_;
  std::fill(kind_.begin(), kind_.end(), CommandKind::kHold);
  for (std::vector<float>* column : {&vx_, &vy_, &vz_}) {
    std::fill(column->begin(), column->end(), 0.0F);
  }
  return {kind_, vx_, vy_, vz_, deadline_, sequence_};
}

Want GuardEnd::want() const noexcept {
  const Word want = segment_.header().want.load(std::memory_order_acquire);
  return want > static_cast<Word>(Want::kEnd) ? Want::kEnd : static_cast<Want>(want);
}

void GuardEnd::show() noexcept {
  view_.head->wish = sequence_;
  view_.head->taken = taken_;
  view_.head->refused = refused_;
  views_.publish(view_block_);
  segment_.header().guard_beat.store(++beat_, std::memory_order_release);
}

void GuardEnd::tell(const Event& event) noexcept {
  events_.publish(std::as_bytes(std::span(&event, 1)));
}

void GuardEnd::set_phase(Phase phase) noexcept {
  segment_.header().phase.store(static_cast<Word>(phase), std::memory_order_release);
}

}  // namespace mayfly::link
