// The last stage before the HAL: whatever is desired, what is commanded keeps the limits (docs: safety, the
// governor).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "controller/governor/governor_config.hpp"
#include "controller/governor/reservation.hpp"
#include "core/clock.hpp"
#include "core/hal.hpp"

namespace mayfly {

// One element an agent; m, m/s, world frame. As StateColumns, to be read.
struct GovernorState {
  std::span<const float> x, y, z;
  std::span<const float> vx, vy, vz;  // measured
  std::span<const Time> stamp;
  std::span<const std::uint8_t> valid;
};
struct DesiredColumns {
  std::span<const float> vx, vy, vz;  // m/s; not finite means "no command"
};
struct GovernedColumns {
  std::span<CommandKind> kind;
  std::span<float> vx, vy, vz;
};

// For ANY desired velocities, and any robots whose velocity follows a command within a tick (at once, or
// linearly, or in between) or lags behind it by the configured response time, every enabled agent that starts
// inside the safe set keeps |v| ≤ speed, |Δv| ≤ acceleration·T, and its body inside the fence and out of
// obstacles, also between ticks. The limits hold up to the rounding of the commands to float. One that starts
// faster than its limit brakes until it is legal; one that starts outside the fence or too near an obstacle
// may only come back.
//
// Each tick it tries commands between braking and the desired one, and takes the first whose reservation
// (reservation.hpp) is free. Braking needs no test: it never leaves what was reserved before. So there is
// always an answer.
//
// Not promised yet: distance between agents (admissible() is its place), progress, states that differ from
// the truth by more than the tube, ticks that were skipped.
class Governor {
 public:
  // Allocates. Fails as check(config) does.
  static Result<Governor> make(GovernorConfig config);

  // One tick. `now` is compared with the stamps. A robot without a valid state brakes, then holds.
  void govern(Time now, const GovernorState& state, const DesiredColumns& desired,
              const GovernedColumns& out) noexcept;

  std::size_t agents() const noexcept { return reference_.size(); }
  const GovernorCounters& counters() const noexcept { return counters_; }

 private:
  // What is known of one agent's robot, and what is decided for it, in a tick.
  struct Decision {
    glm::dvec3 command{0.0};
    bool hold = false;
    std::uint32_t reasons = 0;  // bits by GovernorReason

    void add(GovernorReason reason) { reasons |= 1U << static_cast<unsigned>(reason); }
  };
  struct Group {
    GovernorGroup spec;
    double brake_step = 0.0;    // m/s a tick
    double change_limit = 0.0;  // m/s a tick
    glm::dvec3 fence_low{0.0};
    glm::dvec3 fence_high{0.0};
    Clearance clearance;
  };
  // The velocity that was commanded last, exactly as it was sent.
  struct Reference {
    glm::vec3 velocity{0.0F};
    bool known = false;  // false until the first valid state: then the measured velocity is taken
  };

  explicit Governor(GovernorConfig config);
  bool fits(const GovernorState& state, const DesiredColumns& desired,
            const GovernedColumns& out) const noexcept;
  Decision decide(const Group& group, std::size_t agent, Time now, const GovernorState& state,
                  glm::vec3 desired) noexcept;
  bool check_state(std::size_t agent, Time now, const GovernorState& state,
                   Decision& decision) const noexcept;
  glm::dvec3 limit(const Group& group, glm::dvec3 reference, glm::dvec3 desired,
                   Decision& decision) const noexcept;
  glm::dvec3 reserve_free(const Group& group, glm::dvec3 position, glm::dvec3 reference, glm::dvec3 wanted,
                          Decision& decision) const noexcept;
  bool admissible(const Group& group, const Reservation& reservation,
                  GovernorReason& obstacle) const noexcept;
  void count(const Decision& decision) noexcept;

  GovernorConfig config_;
  double period_ = 0.0;  // s
  std::vector<Group> groups_;
  std::vector<Reference> reference_;
  GovernorCounters counters_;
};

}  // namespace mayfly
