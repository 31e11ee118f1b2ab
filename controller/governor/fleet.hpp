// Where every robot is by our own account, and what it has reserved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "controller/governor/claims.hpp"
#include "controller/governor/governor_columns.hpp"
#include "controller/governor/group_model.hpp"
#include "controller/governor/neighbour_cells.hpp"
#include "controller/governor/reference.hpp"

namespace mayfly {

struct FleetRobot {
  FleetRobot(int latency, std::uint32_t the_group) : reference(latency), group(the_group) {}

  Reference reference;
  std::uint32_t group;
  Authority authority = Authority::kAbsent;
  glm::vec3 sent{0.0F};      // the last command, exactly
  glm::dvec3 estimate{0.0};  // where it was measured, if `estimated`
  bool estimated = false;
  glm::vec3 velocity{0.0F};  // m/s, as it was measured, if `estimated`
  glm::dvec3 off{0.0};     // m, from the reference to where it was measured last; 0 of one that is not flown
  glm::dvec3 beyond{0.0};  // m, what of it is beyond the tube: it may be at either place
  // m, by which the reference was moved to where it was measured, forgotten within a quarter of a second: a
  // drift is seen even where the reference follows it.
  glm::dvec3 slipped{0.0};
  bool strays = false;    // both together are beyond the tube: it does not go where it is told
  bool torn = false;      // it was measured elsewhere at once: nobody knows which place is right
  bool descends = false;  // it was told to land
  Hull braking;           // what it has reserved, if its reference is known: braking keeps it in
  // It brakes by itself, somewhere in what it had reserved, and is at rest in `rests_in` s.
  bool coasts = false;
  double rests_in = 0.0;
  bool is_late = false;  // this tick came too late for it to brake as we would tell it
};

class Fleet {
 public:
  explicit Fleet(const GovernorConfig& config);

  // Moves every reference by what was sent `passed` s ago, and reserves what braking needs.
  void settle(const GovernorState& state, double passed) noexcept;
  // Everybody's reference is taken anew from the next estimate.
  void forget() noexcept;

  std::size_t size() const noexcept { return robots_.size(); }
  FleetRobot& robot(std::size_t i) noexcept { return robots_[i]; }
  const FleetRobot& robot(std::size_t i) const noexcept { return robots_[i]; }
  const GroupModel& group_of(std::size_t i) const noexcept { return groups_[robots_[i].group]; }
  // What one tick of braking makes of its velocity, m/s, as it was sent: less where the last tick was short.
  glm::dvec3 braked(std::size_t i) const noexcept;
  // m/s: by how much it may be changed.
  double most_change(std::size_t i) const noexcept;
  const Claim& claim(std::size_t i) const noexcept { return claims_[i]; }

  // What a command needs from where the robot is, and as a claim.
  Hull hull_of(std::size_t i, glm::dvec3 command) const noexcept;
  Claim claim_of(std::size_t i, const Hull& hull) const noexcept;
  void reserve(std::size_t i, const Claim& claim) noexcept { claims_[i] = claim; }
  // Of a wish of robot i beside what all others have reserved. `speed`: m/s, as it would be commanded.
  Nearness nearness_of(std::size_t i, const Hull& hull, const Claim& claim, double speed) noexcept;
  // Of one that is to land: whether it may be told so. From then on it goes its own way down.
  bool may_descend(std::size_t i, Nearness nearness) noexcept;
  // Whether a wish keeps clear of where another robot stands, or goes no nearer than braking would.
  bool keeps_clear(std::size_t i, const Hull& hull, const Claim& claim, double speed,
                   const KeptClear& place) const noexcept;
  // From now on what is reserved is all that is known of it: it brakes by itself.
  void coast(std::size_t i) noexcept;
  // Moves the reference; what braking needs moves with it.
  void shift(std::size_t i, glm::dvec3 way) noexcept;

  std::span<const std::uint32_t> near(std::size_t i) noexcept { return cells_.near(i, balls_); }

 private:
  void settle_robot(std::size_t i, Authority authority, glm::vec3 velocity) noexcept;
  void settle_ours(std::size_t i, bool was_ours, glm::vec3 velocity) noexcept;
  void settle_coasting(std::size_t i) noexcept;
  void measure(std::size_t i, bool measured, bool anew) noexcept;
  void settle_foreign(std::size_t i, glm::vec3 velocity) noexcept;
  void reserve_braking(std::size_t i) noexcept;
  Hull tail_of(std::size_t i) const noexcept;
  NeighbourCells::Ball ball_of(std::size_t i) const noexcept;

  std::vector<GroupModel> groups_;
  double ground_ = 0.0;        // m, the height where whoever lands comes to rest, or lower
  double passed_ = 0.0;        // s since the tick before
  double tallest_ = 1.0;       // the largest `downwash`
  double longest_rest_ = 0.0;  // s, of anybody
  std::vector<FleetRobot> robots_;
  std::vector<Claim> claims_;
  std::vector<NeighbourCells::Ball> balls_;
  NeighbourCells cells_;
};

}  // namespace mayfly
