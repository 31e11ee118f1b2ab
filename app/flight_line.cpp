#include "app/flight_line.hpp"

#include <fmt/format.h>

#include <chrono>

namespace mayfly::app {
namespace {

constexpr std::chrono::milliseconds kNap{50};
constexpr int kNapsBetweenLines = 5;

std::string flight_text(const FlightGauge& gauge, double duration_s, std::size_t agents, double wall_s) {
  const double flown_s = to_seconds(Time(gauge.flown_ns.load(std::memory_order_relaxed)));
  const auto faults = gauge.faults.load(std::memory_order_relaxed);
  return fmt::format("{:.1f} of {:.1f} s · {:.3g} × real time · {} agents · {} fault{}", flown_s, duration_s,
                     wall_s > 0 ? flown_s / wall_s : 0.0, agents, faults, faults == 1 ? "" : "s");
}

}  // namespace

FlightLine::FlightLine(ProgressLine& line, const FlightGauge& gauge, double duration_s, std::size_t agents) {
  if (!line.wanted()) {
    return;
  }
  thread_ = std::thread([this, &line, &gauge, duration_s, agents] {
    const auto start = std::chrono::steady_clock::now();
    for (int nap = 0; !stop_.load(std::memory_order_relaxed); ++nap) {
      if (nap % kNapsBetweenLines == 0) {
        const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        line.show(flight_text(gauge, duration_s, agents, wall_s));
      }
      // Not the control thread: it only shows, and looks again soon so that the flight's end need not wait
      // for it.
      std::this_thread::sleep_for(kNap);
    }
    line.clear();
  });
}

FlightLine::~FlightLine() {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) {
    thread_.join();
  }
}

}  // namespace mayfly::app
