// What a planner wishes, judged: the newest wish that is in order, for as long as it may be flown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/safety/symptoms.hpp"
#include "core/hal.hpp"

namespace mayfly {

struct WishCounters {
  std::uint64_t taken = 0;         // wishes with a new sequence number
  std::uint64_t refused = 0;       // whole wishes: out of sequence, or columns too short
  std::uint64_t not_finite = 0;    // robot-ticks whose velocity was not a number
  std::uint64_t unknown_kind = 0;  // robot-ticks whose kind does not exist
  std::uint64_t absurd = 0;        // new wishes of a robot that are far beyond its speed
  std::uint64_t stalled = 0;       // ticks without a wish that may be flown
};

// A velocity of more than twice what the robot can do is flown as far as the governor lets it, and told: no
// planner that knows its robots wants it.
//
// A wish may be handed over as often as one likes: it is taken once, by its sequence number. One with a lower
// number is refused (replayed, or late), and the one before stays. It may be flown until its own deadline,
// but no longer than `most_age` after it was taken: a planner cannot wish for ever.
class WishDesk {
 public:
  // `limits`: m/s, what each robot can do, one element a robot; empty: nothing is absurd.
  WishDesk(std::size_t robots, Time most_age, std::vector<float> limits = {});

  // Forgets all; sequence numbers begin anew.
  void reset() noexcept;
  void judge(Time now, const CommandColumns& wish) noexcept;

  // Somebody before has refused a whole wish; counted here, and told by the next judge().
  void refuse() noexcept;

  // As of the last judge(). kNone where nothing is wished of a robot, or may not be; velocities are finite
  // where the kind is kVelocity.
  CommandKind kind(std::size_t robot) const noexcept {
    return is_stalled_ ? CommandKind::kNone : kind_[robot];
  }
  std::span<const float> vx() const noexcept { return vx_; }
  std::span<const float> vy() const noexcept { return vy_; }
  std::span<const float> vz() const noexcept { return vz_; }
  std::uint64_t sequence() const noexcept { return sequence_; }
  Time deadline() const noexcept { return deadline_; }

  std::span<const Symptoms> symptoms() const noexcept { return symptoms_; }  // one a robot
  Symptoms everybody() const noexcept { return everybody_; }
  const WishCounters& counters() const noexcept { return counters_; }

 private:
  bool is_in_order(const CommandColumns& wish) const noexcept;
  void take(Time now, const CommandColumns& wish) noexcept;
  void take_robot(std::size_t robot, const CommandColumns& wish) noexcept;

  bool is_absurd(std::size_t robot, const CommandColumns& wish) const noexcept;

  Time most_age_;
  std::vector<float> limits_;
  std::vector<CommandKind> kind_;
  std::vector<float> vx_, vy_, vz_;
  std::vector<Symptoms> symptoms_;
  Symptoms everybody_;
  std::uint64_t sequence_ = 0;
  Time deadline_{0};
  bool is_stalled_ = true;
  bool was_refused_ = false;
  WishCounters counters_;
};

}  // namespace mayfly
