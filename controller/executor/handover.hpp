// A value that crosses from one task to another, and its age: what is too old is as good as none.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "controller/executor/latency_histogram.hpp"
#include "core/clock.hpp"
#include "core/mailbox.hpp"

namespace mayfly {

// A value and the time that it is true of, on the run's clock: for a plan that is when the state it was made
// from was sensed, not when it was finished.
template <class T>
struct Aged {
  T value;
  Time stamp = Time::min();  // min(): there never was one

  bool exists() const noexcept { return stamp != Time::min(); }
  Time age(Time now) const noexcept { return exists() ? now - stamp : Time::max(); }
};

struct AgeStats {
  std::string name;             // "estimate to curl_noise"
  Time limit{0};                // older is none
  std::uint64_t read = 0;       // times the consumer looked
  std::uint64_t expired = 0;    // of these, what was there was older than the limit
  std::uint64_t missing = 0;    // and there was nothing yet
  Time p50{0}, p99{0}, max{0};  // of what there was, expired or not; 0 where there was nothing
};

// A mailbox (core/mailbox.hpp: one producer, one consumer, newest wins, wait-free, allocates nothing) whose
// consumer holds every value's age against a limit.
template <class T>
class Handover {
 public:
  // `initial` has its final size; it is never handed out.
  Handover(std::string name, Time limit, const T& initial)
      : name_(std::move(name)), limit_(limit), box_(Aged<T>{initial}) {}

  // Producer only. The draft holds an old value: fill all of it.
  T& draft() noexcept { return box_.draft().value; }
  void publish(Time stamp) noexcept {
    box_.draft().stamp = stamp;
    box_.publish();
  }

  // Consumer only. The newest value with its stamp, or null: nothing came yet, or it is older than the limit.
  // Looks once a call and counts what it saw.
  const Aged<T>* read(Time now) noexcept {
    box_.collect();
    ++read_;
    const Aged<T>& newest = box_.latest();
    if (!newest.exists()) {
      ++missing_;
      return nullptr;
    }
    const Time age = std::max(newest.age(now), Time{0});
    ages_.record(age);
    if (age > limit_) {
      ++expired_;
      return nullptr;
    }
    return &newest;
  }
  // How old what was read last is; max() where there is nothing.
  Time age(Time now) const noexcept { return box_.latest().age(now); }
  Time limit() const noexcept { return limit_; }

  // Not while the consumer reads.
  AgeStats stats() const {
    return {name_,      limit_, read_, expired_, missing_, ages_.percentile(0.5), ages_.percentile(0.99),
            ages_.max()};
  }

 private:
  std::string name_;
  Time limit_;
  Mailbox<Aged<T>> box_;
  LatencyHistogram ages_;
  std::uint64_t read_ = 0;
  std::uint64_t expired_ = 0;
  std::uint64_t missing_ = 0;
};

}  // namespace mayfly
