#include "controller/executor/releases.hpp"

#include <cmath>
#include <utility>

namespace mayfly {
namespace {

constexpr double kLowestRate = 1e-3;  // Hz
constexpr double kHighestRate = 1e5;  // Hz

}  // namespace

Time real_now() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch();
}

Result<Releases> Releases::make(std::string name, double rate_hz) {
  if (!(rate_hz >= kLowestRate && rate_hz <= kHighestRate)) {
    return fail({.message = "a task '" + name + "' cannot run at this rate",
                 .found = std::to_string(rate_hz) + " Hz",
                 .wanted = "0.001 to 100000 Hz"});
  }
  return Releases(std::move(name), rate_hz);
}

Releases::Releases(std::string name, double rate_hz)
    : name_(std::move(name)), rate_hz_(rate_hz), period_(std::llround(1e9 / rate_hz)) {}

void Releases::restart() noexcept {
  next_ = 0;
  skipped_before_next_ = 0;
}

// A release is lost once its deadline has passed before it could start. It is the machine's where we had gone
// to sleep before the release and were not woken until after the deadline; else other work of ours stood in
// the way.
void Releases::skip_expired(Time now, Time duration, const Sleep& sleep) noexcept {
  while (scheduled() < duration && deadline() <= now) {
    const bool overslept = scheduled() >= sleep.began && deadline() <= sleep.ended;
    ++missed_;
    ++skipped_;
    missed_by_machine_ += overslept ? 1U : 0U;
    ++skipped_before_next_;
    ++next_;
  }
}

TickInfo Releases::begin(Time start, Time now) const noexcept {
  return {next_, skipped_before_next_, start + scheduled(), start + now, period_};
}

void Releases::end(Time began, Time ended, Time worked, const Sleep& sleep) noexcept {
  run_.record(worked);
  jitter_.record(began - scheduled());
  ++ticks_;
  count_if_late(ended, sleep);
  skipped_before_next_ = 0;
  ++next_;
}

// Work that ended after its deadline would have been in time, had the thread been woken when it asked to be:
// then the miss is the machine's.
void Releases::count_if_late(Time ended, const Sleep& sleep) noexcept {
  if (ended <= deadline()) {
    return;
  }
  const bool slept_in_time = scheduled() >= sleep.began && scheduled() <= sleep.ended;
  const Time overslept = slept_in_time ? sleep.ended - scheduled() : Time{0};
  ++missed_;
  missed_by_machine_ += ended - overslept <= deadline() ? 1U : 0U;
}

TaskStats Releases::stats() const {
  return {name_,
          false,
          rate_hz_,
          ticks_,
          missed_,
          missed_by_machine_,
          skipped_,
          jitter_.percentiles(),
          run_.percentiles()};
}

}  // namespace mayfly
