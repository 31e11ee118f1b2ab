// Whether what is promised of a flight holds, seen from outside: of the robots' true places at every plant
// step and of what reaches their HAL. It knows nothing of the guard.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "controller/scenario/scenario.hpp"
#include "core/grid.hpp"
#include "sim_hal/config.hpp"

namespace mayfly::simulate {

enum class Breach : std::uint8_t { kSeparation, kFence, kSpeed, kAcceleration, kCount };
inline constexpr std::size_t kBreaches = static_cast<std::size_t>(Breach::kCount);
using BreachCounts =
    std::array<std::uint64_t, kBreaches>;  // robot-steps (pairs, of kSeparation) and commands

// One of those that are counted.
struct Incident {
  Time at{0};
  Breach breach = Breach::kCount;
  std::uint32_t first = 0, second = 0;  // robots; the same where there was but one
};

struct PromisedLimits {       // of a robot
  float radius = 0.05F;       // m
  float speed = 2.0F;         // m/s
  float acceleration = 4.0F;  // m/s²
  bool governed = true;       // false: nothing is promised of it
};

struct Promise {
  std::vector<PromisedLimits> robots;
  Box fence;                      // m
  std::vector<PlaneSpec> planes;  // besides
};

// What the guard of a scenario promises.
Promise promise_of(const Scenario& scenario);

// Of one HAL in lock step. Two that touch at the start may, until they are apart, but come no nearer; one
// that is outside at the start may be, until it is inside, but go no farther out.
class BreachWatch final : public sim_hal::StepWatcher {
 public:
  explicit BreachWatch(Promise promise);

  void on_step(const sim_hal::PoseView& truth) noexcept override;
  void on_command(Time now, const CommandColumns& commands) noexcept override;

  const BreachCounts& breaches() const noexcept { return breaches_; }
  const std::vector<Incident>& incidents() const noexcept { return incidents_; }
  // m: the least distance of two bodies' surfaces, but for those that start too near until they are apart;
  // infinite where there were no two.
  double least_gap() const noexcept { return least_gap_; }

 private:
  struct Told {
    std::array<double, 3> velocity{};  // m/s
    bool was_velocity = false;
  };

  void count(Breach breach, Time at, std::size_t first, std::size_t second) noexcept;
  double outside(const sim_hal::PoseView& truth, std::size_t robot) const noexcept;
  void check_pair(const sim_hal::PoseView& truth, std::size_t i, std::size_t j) noexcept;

  Promise promise_;
  BreachCounts breaches_{};
  std::vector<Incident> incidents_;
  double least_gap_ = std::numeric_limits<double>::infinity();
  bool has_begun_ = false;
  std::vector<double> may_be_out_;     // m, a robot
  std::vector<double> may_be_nearer_;  // m, a pair: how far two may overlap; i · robots + j
  std::optional<Time> last_;
  std::vector<Told> told_;  // last
};

}  // namespace mayfly::simulate
