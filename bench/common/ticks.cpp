#include "bench/common/ticks.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace mayfly::bench {
namespace {

struct Columns {
  explicit Columns(std::size_t agents) : x(agents), y(agents), z(agents) {}

  std::vector<float> x, y, z;
};

void fill(Columns& columns, std::span<const glm::vec3> values) {
  for (std::size_t a = 0; a < values.size(); ++a) {
    columns.x[a] = values[a].x;
    columns.y[a] = values[a].y;
    columns.z[a] = values[a].z;
  }
}

// A flock on its way: where it is, and what it was told last.
class Flying {
 public:
  explicit Flying(const Flock& flock)
      : period_s_(flock.period_s), at_(flock.places.size()), told_(at_), next_(at_) {
    fill(at_, flock.places);
    fill(told_, flock.velocities);
  }

  TickCounts tick(Engine& engine, int number) {
    const TickTime time{static_cast<std::uint64_t>(number), number * static_cast<double>(period_s_),
                        period_s_};
    const TickCounts counts =
        engine.compute({at_.x, at_.y, at_.z, told_.x, told_.y, told_.z}, time, {next_.x, next_.y, next_.z});
    move_on(at_.x, next_.x);
    move_on(at_.y, next_.y);
    move_on(at_.z, next_.z);
    std::swap(told_, next_);
    return counts;
  }

  std::vector<glm::vec3> told() const {
    std::vector<glm::vec3> velocities;
    for (std::size_t a = 0; a < told_.x.size(); ++a) {
      velocities.emplace_back(told_.x[a], told_.y[a], told_.z[a]);
    }
    return velocities;
  }

 private:
  void move_on(std::vector<float>& position, const std::vector<float>& velocity) const {
    for (std::size_t a = 0; a < position.size(); ++a) {
      position[a] += period_s_ * velocity[a];
    }
  }

  float period_s_;
  Columns at_, told_, next_;
};

Result<void> whether_well(const Engine& engine) {
  if (!engine.fault().empty()) {
    return fail(Cause::kEnvironment, std::string(engine.fault()));
  }
  return {};
}

}  // namespace

Result<Ticks> time_ticks(Engine& engine, const Flock& flock, int ticks) {
  if (auto prepared = engine.prepare(flock.swarms, flock.places.size()); !prepared) {
    return fail(std::move(prepared.error()));
  }
  Flying flying(flock);
  std::vector<double> seconds;
  TickCounts sum;
  constexpr int kWarmUp = 3;
  for (int tick = 0; tick < ticks + kWarmUp; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    const TickCounts counts = flying.tick(engine, tick);
    const auto took = std::chrono::steady_clock::now() - start;
    sum.moved += counts.moved;
    sum.infeasible += counts.infeasible;
    if (tick >= kWarmUp) {
      seconds.push_back(std::chrono::duration<double>(took).count());
    }
  }
  const double agent_ticks = static_cast<double>(flock.places.size()) * (ticks + kWarmUp);
  std::nth_element(seconds.begin(), seconds.begin() + ticks / 4, seconds.end());
  return whether_well(engine).transform([&] {
    return Ticks{seconds[static_cast<std::size_t>(ticks / 4)], static_cast<double>(sum.moved) / agent_ticks,
                 static_cast<double>(sum.infeasible) / agent_ticks};
  });
}

Result<void> fly(Engine& engine, const Flock& flock, int ticks,
                 const std::function<void(const std::vector<glm::vec3>& velocities)>& told) {
  if (auto prepared = engine.prepare(flock.swarms, flock.places.size()); !prepared) {
    return prepared;
  }
  Flying flying(flock);
  for (int tick = 0; tick < ticks; ++tick) {
    flying.tick(engine, tick);
    told(flying.told());
  }
  return whether_well(engine);
}

Result<std::vector<glm::vec3>> first_velocities(Engine& engine, const Flock& flock) {
  std::vector<glm::vec3> first;
  return fly(engine, flock, 1, [&](const std::vector<glm::vec3>& velocities) { first = velocities; })
      .transform([&] { return first; });
}

}  // namespace mayfly::bench
