#include "app/wiring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/virtual_clock.hpp"
#include "controller/engine/faster_engine.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly::app {
namespace {

// Fewer than this many agents are not worth waking another thread for.
constexpr std::size_t kAgentsAThread = 2000;

}  // namespace

Result<void> choose_hal(Scenario& scenario, const std::string& name) {
  std::vector<std::string> names;
  for (const HalSpec& hal : scenario.hals) {
    names.push_back(hal.name);
  }
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return fail({.message = fmt::format("--hal: '{}' has no HAL of that name", scenario.name),
                 .found = fmt::format("'{}'", name),
                 .wanted = list_names(names),
                 .suggestion = nearest_name(name, names)});
  }
  for (SwarmSpec& swarm : scenario.swarms) {
    swarm.robots = name;
  }
  return {};
}

std::unique_ptr<Clock> make_clock(bool fast) {
  if (fast) {
    return std::make_unique<VirtualClock>();
  }
  return std::make_unique<RealtimeClock>();
}

Result<std::unique_ptr<Engine>> make_engine(EngineChoice choice, int threads, const Prepared& ready,
                                            float period_s) {
  const std::size_t agents = ready.models.agents();
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const auto worth_it = static_cast<int>(std::clamp<std::size_t>(agents / kAgentsAThread, 1, cores));
  std::vector<std::unique_ptr<Engine>> engines;
  if (choice != EngineChoice::kOpenCl) {
    engines.push_back(make_native_engine(threads > 0 ? threads : worth_it));
  }
  if (choice != EngineChoice::kNative) {
    auto opencl = make_opencl_engine();
    if (!opencl && choice == EngineChoice::kOpenCl) {
      return opencl;
    }
    if (opencl) {
      engines.push_back(std::move(*opencl));
    }
  }
  if (engines.size() == 1) {
    if (auto prepared = engines.front()->prepare(ready.models.swarms, agents); !prepared) {
      return fail(std::move(prepared.error()));
    }
    return std::move(engines.front());
  }
  std::vector<float> x(agents);
  std::vector<float> y(agents);
  std::vector<float> z(agents);
  for (std::size_t a = 0; a < agents; ++a) {
    x[a] = ready.places[a].x;
    y[a] = ready.places[a].y;
    z[a] = ready.places[a].z;
  }
  return faster_engine(std::move(engines), ready.models.swarms, {x, y, z}, period_s);
}

}  // namespace mayfly::app
