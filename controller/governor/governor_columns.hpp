// What the governor is told and tells, one element a robot; m, m/s, world frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "controller/safety/symptoms.hpp"
#include "core/hal.hpp"

namespace mayfly {

// On whose word a robot moves.
enum class Authority : std::uint8_t {
  kGoverned,  // the planner's, as far as the governor lets it
  kBraking,   // ours: it brakes, then holds
  kAtRest,    // nobody's: it stands with its motors off, wherever its estimate says
  // Ours, and then its firmware's: it brakes, and lands from where it rests. What is below it is its own from
  // then on, and it is told to land once nobody else has a claim there.
  kLanding,
  // Its link is dead: what it may still do alone is what was reserved for it, and that stays so until it is
  // heard again. It is told to brake all the same.
  kSilent,
  kForeign,  // not ours: it is told nothing, and may go wherever its limits allow
  kAbsent,   // not there at all
};

// Whether it is in the air on our commands.
constexpr bool is_flown(Authority authority) {
  return authority == Authority::kGoverned || authority == Authority::kBraking ||
         authority == Authority::kLanding;
}

// Where a robot stands that was taken out of the run, and where it comes to rest: all keep clear of it but
// the one that flies in its stead. m, world frame.
struct KeptClear {
  glm::vec3 from{0.0F}, to{0.0F};
  std::uint32_t robot = 0;  // whose it is
};

struct GovernorState {
  std::span<const float> x, y, z;
  std::span<const float> vx, vy, vz;       // estimated
  std::span<const std::uint8_t> known;     // 0: the rest of the row may not be relied on
  std::span<const Authority> authority{};  // empty: all are governed
  // 1: `known` by a pose that came in this tick. A place that is only predicted says nothing of how far the
  // robot is off its reference, which knows what it was told since. Empty: as `known`.
  std::span<const std::uint8_t> measured{};
  // 1: from now on it is measured elsewhere, because of poses that agree with each other, and not with those
  // before. Empty: nobody is.
  std::span<const std::uint8_t> anew{};
  std::span<const KeptClear> kept_clear{};  // as long as the call
};

inline bool columns_fit(std::size_t agents, const GovernorState& state) noexcept {
  const std::size_t least = std::min({state.x.size(), state.y.size(), state.z.size(), state.vx.size(),
                                      state.vy.size(), state.vz.size(), state.known.size()});
  return least >= agents && (state.authority.empty() || state.authority.size() >= agents) &&
         (state.measured.empty() || state.measured.size() >= agents) &&
         (state.anew.empty() || state.anew.size() >= agents);
}

struct DesiredColumns {
  std::span<const float> vx, vy, vz;  // m/s; not finite means "no command"
};

struct GovernedColumns {
  std::span<CommandKind> kind;  // kVelocity; kHold; kLand; kNone of a robot that is not ours
  std::span<float> vx, vy, vz;
  // Of each robot, fresh: kTrackingError, kOutOfFence, kTooNear, kCommandNotFinite. May be empty: not told.
  std::span<Symptoms> symptoms{};
};

// Where the governor takes a robot to be, before the tick's command: what `tube` is measured from.
struct GovernorReference {
  glm::dvec3 body{0.0};
  glm::vec3 velocity{0.0F};  // as it was commanded last, or on the way to it
  bool known = false;        // false: no estimate yet
};

}  // namespace mayfly
