// The progress line of a flight.
#pragma once

#include <atomic>
#include <thread>

#include "app/progress_line.hpp"
#include "controller/flight/flight.hpp"

namespace mayfly::app {

// Looks at the gauge a few times a second, from a thread of its own: "12.4 of 90.0 s · 31 × real time · 300
// agents · 0 faults".
class FlightLine {
 public:
  FlightLine(ProgressLine& line, const FlightGauge& gauge, double duration_s, std::size_t agents);
  FlightLine(const FlightLine&) = delete;
  FlightLine& operator=(const FlightLine&) = delete;
  ~FlightLine();

 private:
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace mayfly::app
