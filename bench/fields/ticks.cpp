#include "bench/fields/ticks.hpp"

#include <algorithm>
#include <chrono>

namespace mayfly::bench {
namespace {

struct Columns {
  std::vector<float> x, y, z;
};

void move_on(std::vector<float>& position, const std::vector<float>& velocity, float period_s) {
  for (std::size_t a = 0; a < position.size(); ++a) {
    position[a] += period_s * velocity[a];
  }
}

}  // namespace

Result<Ticks> time_ticks(Engine& engine, const Village& village, int ticks) {
  const Prepared& ready = *village.ready;
  if (auto prepared = engine.prepare(ready.models.swarms, ready.models.agents()); !prepared) {
    return fail(std::move(prepared.error()));
  }
  Columns at;
  for (const glm::vec3 place : ready.places) {
    at.x.push_back(place.x);
    at.y.push_back(place.y);
    at.z.push_back(place.z);
  }
  Columns v{at.x, at.y, at.z};
  const float period_s = 1.0F / village.scenario.control.rate;
  std::vector<double> seconds;
  std::size_t moved = 0;
  constexpr int kWarmUp = 3;
  for (int tick = 0; tick < ticks + kWarmUp; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    const TickTime time{static_cast<std::uint64_t>(tick), tick * static_cast<double>(period_s), period_s};
    moved += engine.compute({at.x, at.y, at.z}, time, {v.x, v.y, v.z}).moved;
    move_on(at.x, v.x, period_s);
    move_on(at.y, v.y, period_s);
    move_on(at.z, v.z, period_s);
    if (tick >= kWarmUp) {
      seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  }
  if (!engine.fault().empty()) {
    return fail(Cause::kEnvironment, std::string(engine.fault()));
  }
  std::nth_element(seconds.begin(), seconds.begin() + ticks / 4, seconds.end());
  return Ticks{seconds[static_cast<std::size_t>(ticks / 4)],
               static_cast<double>(moved) / static_cast<double>(at.x.size()) / (ticks + kWarmUp)};
}

}  // namespace mayfly::bench
