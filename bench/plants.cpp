// What simulated robots cost a control tick of 10 ms (two plant steps), native against OpenCL in the same
// run, and what it takes to build the plants' program without and with a cache. Prints minimum and median;
// run it on a quiet machine.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "compute/program.hpp"
#include "sim_hal/plant_stepper.hpp"

namespace {

using Watch = std::chrono::steady_clock;
using mayfly::sim_hal::PlantStepper;

double microseconds_since(Watch::time_point start) {
  return std::chrono::duration<double, std::micro>(Watch::now() - start).count();
}

struct Cost {
  double least, median;  // µs
};

Cost cost_of(PlantStepper& stepper, int ticks) {
  std::vector<double> times;
  for (int tick = 0; tick < ticks; ++tick) {
    const auto start = Watch::now();
    if (const std::string_view failure = stepper.step(2); !failure.empty()) {
      std::fprintf(stderr, "%s\n", std::string(failure).c_str());
      return {};
    }
    times.push_back(microseconds_since(start));
  }
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2]};
}

void compare(std::size_t robots, int ticks) {
  const mayfly::sim_hal::PlantParameters parameters{mayfly::sim_hal::Plant::kVelocityLag, 0.1F, 200.0};
  auto native = mayfly::sim_hal::make_native_stepper(robots, parameters);
  const Cost a = cost_of(*native, ticks);
  std::printf("%7zu robots  native %8.1f (median %8.1f) us a tick", robots, a.least, a.median);
  auto opencl = mayfly::sim_hal::make_opencl_stepper(robots, parameters);
  if (!opencl) {
    std::printf("   %s\n", mayfly::to_string(opencl.error()).c_str());
    return;
  }
  const Cost b = cost_of(**opencl, ticks);
  std::printf("   opencl %8.1f (median %8.1f)   opencl/native %.2f\n", b.least, b.median,
              b.median / a.median);
}

// Building, and the first launch, in which a runtime may compile once more.
void build(const char* what) {
  const auto start = Watch::now();
  const auto stepper = mayfly::sim_hal::make_opencl_stepper(300, {});
  std::printf("%-20s plants ready to fly in %.0f ms%s\n", what, microseconds_since(start) / 1e3,
              stepper ? "" : " (failed)");
}

}  // namespace

int main() {
  const auto folder = std::filesystem::temp_directory_path() / "mayfly_bench_plants";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "runtime");
  // No other thread runs yet. NOLINTBEGIN(concurrency-mt-unsafe)
  setenv("MAYFLY_CACHE_DIR", folder.c_str(), 1);
  setenv("POCL_CACHE_DIR", (folder / "runtime").c_str(), 1);
  // NOLINTEND(concurrency-mt-unsafe)
  if (const auto device = mayfly::compute::Device::open(); !device) {
    std::fprintf(stderr, "%s\n", mayfly::to_string(device.error()).c_str());
    return 1;
  }
  build("cold");
  build("cached");
  std::filesystem::remove_all(folder / "runtime");  // as on a machine whose runtime keeps no cache of its own
  std::filesystem::create_directories(folder / "runtime");
  build("cached, by us alone");
  compare(300, 3000);
  compare(100'000, 300);
  std::filesystem::remove_all(folder);
  return 0;
}
