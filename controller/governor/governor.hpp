// The last stage before the HAL: whatever is desired, what is commanded keeps the promise
// (docs/explanation/safety.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>

#include "controller/governor/fence.hpp"
#include "controller/governor/fleet.hpp"
#include "controller/governor/governor_columns.hpp"
#include "controller/governor/governor_config.hpp"
#include "core/clock.hpp"

namespace mayfly {

// Who is where the promise cannot begin.
struct NotAdmitted {
  std::size_t agent = 0;  // the first
  Error error;
};
using AgentName = std::function<std::string(std::size_t)>;

// For ANY desired velocities, every enabled agent that starts inside the safe set keeps |v| ≤ speed, |Δv| ≤
// acceleration·T, its body inside the fence, out of obstacles and off all other enabled agents' bodies, also
// between ticks, as long as its true place differs from its reference by no more than the tube. The limits
// hold up to the rounding of commands to floats. One that starts faster than its limit brakes until it is
// legal; one that starts outside the fence or too near to an obstacle or to another may only come back.
//
// Each tick it tries commands between braking and the desired one, and takes the first whose reservation is
// free. Braking needs no test: it never leaves what was reserved before. So there is always an answer.
//
// Not promised: progress, agents outside the model, places that differ from the truth by more than the tube.
class Governor {
 public:
  // Allocates. Fails as check(config) does.
  static Result<Governor> make(GovernorConfig config);

  // Whether the promise may begin here: names the first robot whose place is not known or not free, or the
  // first two that are too near to each other, with the inequality. Changes nothing; allocates. `name`:
  // what the error calls an agent; "robot 3" where there is none.
  tl::expected<void, NotAdmitted> admit(const GovernorState& state, const AgentName& name = {}) const;

  // One tick, early or late: `now` tells for how long robots have flown with their last commands. Neither
  // allocates nor throws; columns that are too short are refused, and every robot is told to hold.
  void govern(Time now, const GovernorState& state, const DesiredColumns& desired,
              const GovernedColumns& out) noexcept;

  std::size_t agents() const noexcept { return fleet_.size(); }
  const GovernorCounters& counters() const noexcept { return counters_; }
  GovernorReference reference(std::size_t agent) const noexcept;

 private:
  // What is decided for one agent in a tick.
  struct Decision {
    glm::dvec3 command{0.0};
    CommandKind kind = CommandKind::kVelocity;
    Nearness nearness = Nearness::kApart;  // of what is reserved now
    std::uint32_t reasons = 0;             // bits by GovernorReason

    void add(GovernorReason reason) { reasons |= bit(reason); }
    bool has(GovernorReason reason) const { return (reasons & bit(reason)) != 0; }
    static std::uint32_t bit(GovernorReason reason) { return 1U << static_cast<unsigned>(reason); }
  };
  // A command that is tried.
  struct Trial {
    Hull hull;
    Claim claim;
    double speed = 0.0;  // m/s
  };

  explicit Governor(GovernorConfig config);
  double time_since_last(Time now) noexcept;

  Decision decide(std::size_t i, glm::vec3 desired) noexcept;
  bool may_move(std::size_t i, glm::vec3 desired, Decision& decision) const noexcept;
  glm::dvec3 limit(std::size_t i, glm::dvec3 desired, Decision& decision) const noexcept;
  bool reserve_free(std::size_t i, glm::dvec3 wanted, Decision& decision) noexcept;
  bool admissible(std::size_t i, const Trial& trial, Decision& decision, GovernorReason& cause) noexcept;
  bool clear_of_all(std::size_t i, const Trial& trial) const noexcept;
  bool clear_of_kept(std::size_t i, const Trial& trial) const noexcept;

  void nudge(std::size_t i) noexcept;
  Symptoms symptoms_of(std::size_t i, const Decision& decision) const noexcept;
  void tell(std::size_t i, const Decision& decision, const GovernedColumns& out) noexcept;

  Result<void> admit_robot(std::size_t i, const AgentName& name);
  Result<void> admit_pairs(std::size_t i, const AgentName& name);

  GovernorConfig config_;
  Fence fence_;
  Fleet fleet_;
  GovernorCounters counters_;
  Time last_{Time::min()};
  std::span<const KeptClear> kept_clear_;  // of this call
};

}  // namespace mayfly
