// The planner's end of the link: wishes go down, what the guard sees and does comes up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/link/segment.hpp"

namespace mayfly::link {

// One thread. Allocates at construction only.
class PlannerEnd {
 public:
  // Takes the planner's lease; fails where there is a planner on the segment already.
  static Result<PlannerEnd> make(Segment segment);

  const Segment& segment() const noexcept { return segment_; }

  // Fill all of it but its head, then send it: that is a heartbeat, too.
  WishColumns& wish() noexcept { return wish_; }
  void send_wish(Time issued, Time deadline) noexcept;
  void beat() noexcept;
  // What the guard reads of the last wish that was sent; empty where that is not whole.
  std::optional<WishColumns> sent() noexcept;

  // Levels and counts stay until they are asked for otherwise. Nothing crosses where nothing has changed.
  void request_stop(StopLevel level) noexcept;
  void acknowledge() noexcept;
  void want(Want want) noexcept;

  // True where view() is newer than at the last call.
  bool collect() noexcept;
  // Zeros before the first.
  const ViewColumns& view() const noexcept { return view_; }
  // What happened there and was not collected yet; empty where nothing did.
  std::optional<Event> next_event() noexcept;
  std::uint64_t lost_events() const noexcept { return events_.lost(); }
  Word guard_beat() const noexcept { return segment_.header().guard_beat.load(std::memory_order_acquire); }
  Phase phase() const noexcept;

 private:
  PlannerEnd(Segment segment, Word lease);
  void send_request() noexcept;

  Segment segment_;
  RingWriter wishes_, operators_;
  RingReader views_, events_, sent_;
  std::vector<std::byte> wish_block_, operator_block_;
  WishColumns wish_;
  OperatorColumns operator_;
  ViewColumns view_;
  Word lease_;
  Word beat_ = 0;
};

}  // namespace mayfly::link
