#include "controller/clock/realtime_clock.hpp"

#include <cerrno>
#include <ctime>

namespace mayfly {
namespace {

Time monotonic_now() noexcept {
  timespec spec{};
  clock_gettime(CLOCK_MONOTONIC, &spec);
  return std::chrono::seconds(spec.tv_sec) + Time(spec.tv_nsec);
}

timespec to_timespec(Time time) noexcept {
  const auto whole = std::chrono::floor<std::chrono::seconds>(time);
  timespec spec{};
  spec.tv_sec = static_cast<time_t>(whole.count());
  spec.tv_nsec = static_cast<long>((time - whole).count());
  return spec;
}

}  // namespace

RealtimeClock::RealtimeClock() noexcept : start_(monotonic_now()) {}

Time RealtimeClock::now() const noexcept {
  return monotonic_now() - start_;
}

void RealtimeClock::sleep_until(Time deadline) noexcept {
  if (deadline <= now()) {
    return;  // also spares the kernel a time before its own start
  }
  const timespec wake = to_timespec(start_ + deadline);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
  }
}

}  // namespace mayfly
