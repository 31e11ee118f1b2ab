// The guard's end of the link: believes nothing that it reads there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/link/segment.hpp"

namespace mayfly::link {

// One thread. Allocates at construction only.
class GuardEnd {
 public:
  // Takes the guard's lease; fails where there is a guard on the segment already, or no planner yet. A wish
  // is good for `most_age` from when it was seen first, whatever deadline it claims.
  static Result<GuardEnd> make(Segment segment, Time most_age);

  // The newest wish that made sense, with the deadline that it may have. Before the first, and once the
  // planner is gone(), nothing is wished of anybody and the deadline has passed. Refused and counted: another
  // owner than the lease's, a sequence that does not rise, kinds that there are not. What is not finite
  // passes: the guard judges it for each robot.
  CommandColumns wish(Time now) noexcept;
  // When the planner says that it wished so; never later than when it was seen.
  Time issued() const noexcept { return issued_; }
  // The planner's process has ended: its last wish is void, and nothing more is taken from it.
  void planner_gone() noexcept;
  // In place of the planner's, now and from now on: that everybody holds.
  CommandColumns hold(Time now) noexcept;

  // As of the last wish(): levels, none of which falls to nothing when the planner dies.
  StopLevel stop() const noexcept { return stop_; }
  std::uint32_t acknowledged() const noexcept { return acknowledged_; }

  Want want() const noexcept;
  // Changes as long as the planner lives; its value means nothing.
  Word planner_beat() const noexcept {
    return segment_.header().planner_beat.load(std::memory_order_relaxed);
  }
  std::uint64_t taken() const noexcept { return taken_; }
  std::uint64_t refused() const noexcept { return refused_; }
  // False where somebody else than the lease's owner has the lease, or has wished or asked for anything since
  // the last call (I16 of docs/explanation/guard.md).
  bool has_one_owner() noexcept;
  // How many planners and guards came second, and were refused.
  std::uint64_t leases_refused() const noexcept;

  // Fill all of it, then show it: that is a heartbeat, too. taken, refused and wish are filled in here.
  ViewColumns& view() noexcept { return view_; }
  void show() noexcept;
  void tell(const Event& event) noexcept;
  void set_phase(Phase phase) noexcept;

 private:
  GuardEnd(Segment segment, Word owner, Time most_age);
  void take_wish(Time now) noexcept;
  void take_operator() noexcept;

  Segment segment_;
  Time most_age_;
  RingReader wishes_, operators_;
  RingWriter views_, events_;
  std::vector<std::byte> view_block_;
  ViewColumns view_;
  std::vector<CommandKind> kind_;
  std::vector<float> vx_, vy_, vz_;
  Word owner_;
  Word sequence_ = 0;
  Time issued_{0};
  Time deadline_{-1};
  bool planner_gone_ = false;
  StopLevel stop_ = StopLevel::kNone;
  std::uint32_t acknowledged_ = 0;
  Word beat_ = 0;
  std::uint64_t taken_ = 0;
  std::uint64_t refused_ = 0;
  std::uint64_t others_ = 0, others_told_ = 0;  // wishes and requests of another owner
};

}  // namespace mayfly::link
