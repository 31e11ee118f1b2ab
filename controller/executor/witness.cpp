#include "controller/executor/witness.hpp"

#include <algorithm>
#include <system_error>

#include "controller/clock/realtime_rights.hpp"

namespace mayfly {
namespace {

constexpr Time kShortestPeriod = std::chrono::milliseconds(1);
// Longer sleeps would have the end of a run wait for the witness.
constexpr Time kLongestPeriod = std::chrono::milliseconds(100);

}  // namespace

Result<void> Witness::start(Clock& clock, Time start, Time period, const Place& place) try {
  ending_ = false;
  const Time bounded = std::clamp(period, kShortestPeriod, kLongestPeriod);
  thread_ = std::thread([this, &clock, start, bounded, place] {
    if (place.cpu >= 0) {
      pin_thread(place.cpu);
    }
    if (place.priority > 0) {
      request_priority(place.priority);
    }
    sharpen_timers();
    while (!ending_.load(std::memory_order_relaxed)) {
      look(clock, start, bounded);
    }
  });
  return {};
} catch (const std::system_error& error) {
  return fail(Cause::kEnvironment, std::string("no thread for the witness of lateness: ") + error.what());
}

void Witness::stop() noexcept {
  ending_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void Witness::look(Clock& clock, Time start, Time period) noexcept {
  const Time half = period / 2;
  const Time elapsed = std::max(clock.now() - start - half, Time{0});
  const Time due = start + half + period * (elapsed / period + 1);
  clock.sleep_until(due);
  const Time woken = clock.now();
  if (control_.covers(due)) {
    ++set_aside_;
  } else {
    oversleep_.record(woken - due);
  }
}

}  // namespace mayfly
