#include "controller/engine/faster_engine.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

namespace mayfly {
namespace {

// The first ticks sort the agents and wake the threads.
constexpr int kWarmUp = 2;
constexpr int kTimed = 5;
constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

double trial_tick(Engine& engine, const PositionColumns& at, float period_s) {
  std::vector<float> x(at.x.size());
  std::vector<float> y(at.x.size());
  std::vector<float> z(at.x.size());
  double least = kNever;
  for (int tick = 0; tick < kWarmUp + kTimed; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    engine.compute({at.x, at.y, at.z, x, y, z}, {0, 0.0, period_s}, {x, y, z});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (!engine.fault().empty()) {
      return kNever;
    }
    least = tick < kWarmUp ? least : std::min(least, took.count());
  }
  return least;
}

Result<std::unique_ptr<Engine>> faster_engine(std::vector<std::unique_ptr<Engine>> engines,
                                              std::span<const SwarmModel> swarms, const PositionColumns& at,
                                              float period_s) {
  std::unique_ptr<Engine> fastest;
  std::optional<Error> first_error;
  double least = kNever;
  for (std::unique_ptr<Engine>& engine : engines) {
    if (auto prepared = engine->prepare(swarms, at.x.size()); !prepared) {
      first_error = first_error ? first_error : std::move(prepared.error());
      continue;
    }
    if (const double took = trial_tick(*engine, at, period_s); took < least) {
      least = took;
      fastest = std::move(engine);
    }
  }
  if (!fastest) {
    return fail(first_error.value_or(Error{Cause::kEnvironment, "no engine can fly this swarm"}));
  }
  return fastest;
}

}  // namespace mayfly
