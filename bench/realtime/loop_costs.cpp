// What governor and metrics cost a tick, beside the one thing that nobody can do without: reading and writing
// the state.
#include <chrono>
#include <cstdio>

#include "bench/realtime/loop_load.hpp"

namespace {

using mayfly::Time;

// The least of several: the machine is shared.
template <class Work>
double least_microseconds(int repeats, Work work) {
  double least = 1e30;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work(i);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    least = took.count() < least ? took.count() : least;
  }
  return least;
}

}  // namespace

int main() {
  using namespace std::chrono_literals;
  std::printf("%8s %12s %12s %12s %18s %18s\n", "agents", "state/us", "governor/us", "metrics/us",
              "governor/state", "metrics/state");
  for (const std::size_t agents : {300U, 3000U, 100000U}) {
    // As dense as 300 agents in a box of 20 m.
    const float box = 20.0F * std::cbrt(static_cast<float>(agents) / 300.0F);
    mayfly::bench::LoopLoad load(agents, box, 10ms);
    const int repeats = agents > 10000 ? 30 : 3000;
    load.govern(0ms);
    for (int i = 0; i < 20; ++i) {
      load.measure();  // the first tick has to find the minimum, and the next ones the best cells
    }
    const double state = least_microseconds(repeats, [&](int) { load.move(1e-4F); });
    const double governor = least_microseconds(repeats, [&](int i) { load.govern(i * Time(10ms)); });
    const double metrics = least_microseconds(repeats, [&](int) { load.measure(); });
    std::printf("%8zu %12.2f %12.2f %12.2f %18.1f %18.1f\n", agents, state, governor, metrics,
                governor / state, metrics / state);
  }
  return 0;
}
