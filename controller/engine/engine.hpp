// What turns positions into preferred velocities. Two engines run the same kernels: native C++ on threads,
// and OpenCL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "kernels/field.h"
#include "kernels/forces.h"

namespace mayfly {

struct PositionColumns {
  std::span<const float> x, y, z;  // m
};

// The swarm at a tick. An agent whose place is not a number is not there: it gets no velocity, and nobody
// minds it. `v` is what it was last told, m/s: the place moves like that, whatever the robot behind it does.
struct AgentColumns {
  std::span<const float> x, y, z;           // m
  std::span<const float> vx{}, vy{}, vz{};  // m/s; may be empty where no model needs them
};

// What moves a swarm: V(x) of fields, or one of the models that integrate forces.
enum class Motor { kField, kForces, kBoids, kBrownian };

// One swarm as an engine sees it: a range of agents and what they fly by.
struct SwarmModel {
  std::size_t first = 0;
  std::size_t count = 0;
  Motor motor = Motor::kField;
  kernels::MfForces forces{};        // kForces
  kernels::MfBoids boids{};          // kBoids
  kernels::MfBrownian brownian{};    // kBrownian
  float far_error = 0.0F;            // kForces: of attraction, how far off the mean may be; 0: exact
  kernels::MfAvoidance avoidance{};  // after whichever motor
  kernels::MfField field{};          // noise, walls and bounds of any motor; the guide of kField
  std::span<const float> walls;      // spline coefficients of φ on field.grid, m (fields/spline.hpp)
  std::span<const float> guide;      // 4 floats a cell
  PositionColumns rest;              // one an agent of this swarm: its place in the goal
  float separation = 0.0F;           // m; two agents keep half the sum of theirs
  int mde_sweeps = 0;                // at most; 0 for none
};

struct VelocityColumns {
  std::span<float> x, y, z;  // m/s
};

// A control tick: noise that varies reads its time, random choices its number.
struct TickTime {
  std::uint64_t number = 0;
  double time_s = 0.0;     // since the flight began
  float period_s = 0.01F;  // until the next tick
};

// What may be replaced in flight, of one swarm. A table that is empty stays as it is.
struct SwarmFields {
  std::span<const float> walls, guide;  // as in SwarmModel, of the same sizes
  glm::vec3 goal_offset{0.0F};          // m: how far the goal is from where the rest places were laid
  glm::vec3 goal_velocity{0.0F};        // m/s
};

// What a tick came to, in agents.
struct TickCounts {
  std::size_t moved = 0;       // by MDE
  std::size_t infeasible = 0;  // no velocity kept them clear of everybody: they got the least violation
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual std::string_view name() const noexcept = 0;
  // Takes in the swarms and allocates; `agents` in all. The spans must outlive the engine.
  virtual Result<void> prepare(std::span<const SwarmModel> swarms, std::size_t agents) = 0;
  // The velocity of every agent: preferred, then clear of others where the swarm avoids collisions, then
  // with minimum distance enforced on where they will be after the tick's period.
  virtual TickCounts compute(const AgentColumns& at, const TickTime& tick,
                             const VelocityColumns& out) noexcept = 0;
  // Where stimuli are from the next compute() on; as many as the swarm was prepared with.
  virtual void move_stimuli(std::size_t swarm, std::span<const glm::vec3> places) noexcept = 0;
  // The swarm flies by `fields` from the next compute() on. Not during one. The spans must outlive their use.
  virtual void replace_fields(std::size_t swarm, const SwarmFields& fields) noexcept = 0;
  // What went wrong in the last compute(), which then gave zero velocities; empty if nothing did.
  virtual std::string_view fault() const noexcept { return {}; }
};

// What both engines do with a swarm's new fields.
void replace(SwarmModel& swarm, const SwarmFields& fields) noexcept;
// And with where its stimuli are.
void place_stimuli(SwarmModel& swarm, std::span<const glm::vec3> places) noexcept;

std::unique_ptr<Engine> make_native_engine(int threads);
// Fails where there is no OpenCL device or the kernels do not build.
Result<std::unique_ptr<Engine>> make_opencl_engine();

}  // namespace mayfly
