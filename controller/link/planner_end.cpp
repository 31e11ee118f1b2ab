#include "controller/link/planner_end.hpp"

#include <cstring>
#include <utility>

namespace mayfly::link {

Result<PlannerEnd> PlannerEnd::make(Segment segment) {
  auto lease = take_lease(segment.header(), segment.header().planner, "planner");
  if (!lease) {
    return fail(std::move(lease.error()));
  }
  return PlannerEnd(std::move(segment), *lease);
}

PlannerEnd::PlannerEnd(Segment segment, Word lease)
    : segment_(std::move(segment)),
      wishes_(segment_.wish(), segment_.layout().wish),
      operators_(segment_.operators(), segment_.layout().operators),
      views_(segment_.view(), segment_.layout().view),
      events_(segment_.events(), segment_.layout().events),
      sent_(segment_.wish(), segment_.layout().wish),
      wish_block_(segment_.layout().wish.bytes),
      operator_block_(segment_.layout().operators.bytes),
      lease_(lease) {
  Cutter wish(wish_block_.data());
  wish_ = wish_columns(wish, segment_.robots());
  wish_.head->owner = lease_;
  Cutter request(operator_block_.data());
  operator_ = operator_columns(request, segment_.robots());
  operator_.head->owner = lease_;
  Cutter view(views_.latest().data());
  view_ = view_columns(view, segment_.robots());
}

void PlannerEnd::send_wish(Time issued, Time deadline) noexcept {
  ++wish_.head->sequence;
  wish_.head->issued_ns = issued.count();
  wish_.head->deadline_ns = deadline.count();
  wishes_.publish(wish_block_);
  beat();
}

void PlannerEnd::beat() noexcept {
  segment_.header().planner_beat.store(++beat_, std::memory_order_relaxed);
}

std::optional<WishColumns> PlannerEnd::sent() noexcept {
  if (!sent_.collect()) {
    return std::nullopt;
  }
  Cutter cutter(sent_.latest().data());
  const WishColumns wish = wish_columns(cutter, segment_.robots());
  const bool is_ours = wish.head->owner == lease_ && wish.head->sequence == wish_.head->sequence;
  return is_ours ? std::optional(wish) : std::nullopt;
}

void PlannerEnd::request_stop(StopLevel level) noexcept {
  if (operator_.head->stop != static_cast<std::uint32_t>(level)) {
    operator_.head->stop = static_cast<std::uint32_t>(level);
    send_request();
  }
}

void PlannerEnd::acknowledge() noexcept {
  ++operator_.head->acknowledged;
  send_request();
}

void PlannerEnd::send_request() noexcept {
  operators_.publish(operator_block_);
}

void PlannerEnd::want(Want want) noexcept {
  segment_.header().want.store(static_cast<Word>(want), std::memory_order_release);
}

bool PlannerEnd::collect() noexcept {
  if (!views_.collect()) {
    return false;
  }
  Cutter cutter(views_.latest().data());
  view_ = view_columns(cutter, segment_.robots());
  return true;
}

std::optional<Event> PlannerEnd::next_event() noexcept {
  if (!events_.collect_next()) {
    return std::nullopt;
  }
  Event event;
  std::memcpy(&event, events_.latest().data(), sizeof(event));
  event.link.back() = '\0';
  event.cause.back() = '\0';
  return event;
}

Phase PlannerEnd::phase() const noexcept {
  const Word phase = segment_.header().phase.load(std::memory_order_acquire);
  return phase > static_cast<Word>(Phase::kEnded) ? Phase::kEnded : static_cast<Phase>(phase);
}

}  // namespace mayfly::link
