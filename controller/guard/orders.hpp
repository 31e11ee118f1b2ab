// What each robot is to do: the planner's wish, or what its state and its severity leave of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "controller/estimator/estimator.hpp"
#include "controller/governor/governor_columns.hpp"
#include "controller/guard/wish_desk.hpp"
#include "controller/life_cycle/life_cycle.hpp"

namespace mayfly {

// How a robot's tick ends once it is governed.
enum class Ending : std::uint8_t {
  kAsGoverned,
  kNone,     // nothing is sent: its motors are off
  kHold,     // at rest
  kTakeOff,  // its firmware's own way up
  kStop,     // motors off, at once
};

class Orders {
 public:
  struct Config {
    std::size_t robots = 0;
    float descent = 0.0F;  // m/s; 0: they land where they are
    float homing = 0.0F;   // m/s, of one that returns
    std::vector<float>
        floor;  // m, one a robot: below this height it has come down as far as it can be brought
  };
  struct Tick {
    const WishDesk& wish;
    LifeCycles& lives;
    std::span<const Severity> severities;
    std::span<const Symptoms> symptoms;
    std::span<const std::uint8_t> present;  // empty: all are there
    EstimateColumns estimate;
  };

  explicit Orders(Config config);

  // Nobody has a place to return to.
  void forget() noexcept;
  // Where a robot that returns goes: to where it was when its motors might turn first, and there it lands; or
  // to a place (m), and there it holds.
  void send_home(std::size_t robot) noexcept;
  void send_to(std::size_t robot, glm::vec3 place) noexcept;

  void give(const Tick& tick) noexcept;
  // After governing: makes of what was governed what is sent.
  void finish(const GovernedColumns& governed) noexcept;

  std::span<const Authority> authority() const noexcept { return authority_; }
  DesiredColumns desired() const noexcept { return {vx_, vy_, vz_}; }
  // 0: the robot is absent, or goes its firmware's way.
  std::span<const std::uint8_t> ours() const noexcept { return ours_; }

 private:
  void order(const Tick& tick, std::size_t robot) noexcept;
  void obey(const Tick& tick, std::size_t robot) noexcept;
  void land(const Tick& tick, std::size_t robot) noexcept;
  void hold(const Tick& tick, std::size_t robot) noexcept;
  glm::vec3 against_drift(const Tick& tick, std::size_t robot) noexcept;
  void note_home(const Tick& tick, std::size_t robot) noexcept;
  void go_back(const Tick& tick, std::size_t robot) noexcept;
  void set(std::size_t robot, Authority authority, Ending ending) noexcept;
  void wish_of(std::size_t robot, float x, float y, float z) noexcept;

  Config config_;
  std::vector<Authority> authority_;
  std::vector<Ending> ending_;
  std::vector<float> vx_, vy_, vz_;
  std::vector<std::uint8_t> ours_;
  std::vector<std::uint8_t> stays_;  // 1: it was given what its wish asked for along the ground
  std::vector<glm::vec3> places_;    // m, where one that drifts is to stay; NaN of the others
  struct Place {
    glm::vec3 at{0.0F};
    bool known = false;
  };
  std::vector<Place> home_, destination_;
  std::vector<std::uint8_t> lands_there_;
};

}  // namespace mayfly
