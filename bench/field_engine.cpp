// The field core in the locust world: ticks a second and ns an agent against the number of agents, by engine
// and threads. Linear in the agents means: ns an agent stays.
#include <cstdio>
#include <cstdlib>

#include "bench/locust_world.hpp"

namespace {

void row(mayfly::Engine& engine, const char* threads, mayfly::bench::LocustWorld& world, std::size_t agents) {
  const int ticks = agents > 500'000 ? 3 : agents > 100'000 ? 10 : 50;
  const mayfly::bench::TickCost cost = mayfly::bench::time_ticks(engine, world, agents, ticks, 3);
  std::printf(
      "%8zu agents, %-8s %s threads: %9.1f ticks/s %7.1f ns an agent (%.1f of CPU), MDE moves %.2f %%\n",
      agents, engine.name().data(), threads, 1.0 / cost.seconds,
      1e9 * cost.seconds / static_cast<double>(agents), 1e9 * cost.cpu_seconds / static_cast<double>(agents),
      100.0 * cost.moved_share);
}

}  // namespace

// An argument limits the number of agents.
int main(int argc, char** argv) {
  const std::size_t most = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  mayfly::bench::LocustWorld world(2);
  for (const std::size_t agents : {1'000U, 5'000U, 16'000U, 64'000U, 256'000U, 1'000'000U}) {
    if (agents <= most) {
      row(*mayfly::make_native_engine(1), "1", world, agents);
      row(*mayfly::make_native_engine(2), "2", world, agents);
      if (const auto opencl = mayfly::make_opencl_engine()) {
        row(**opencl, "all", world, agents);
      }
    }
  }
}
