// Where a loop's times go: a histogram of fixed size that knows its percentiles to 1 %.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/clock.hpp"

namespace mayfly {

struct Percentiles {  // µs
  double p50 = 0.0;
  double p99 = 0.0;
  double p999 = 0.0;
  double max = 0.0;
};

// Log-linear buckets: 128 to each power of two, so that a percentile is at most 1/128 above its true value,
// from 1 ns to 137 s; longer times share the last bucket. The maximum is exact. 31 KiB; record() is O(1) and
// touches one of them.
class LatencyHistogram {
 public:
  // A negative duration counts as 0.
  void record(Time duration) noexcept {
    const std::int64_t ns = duration.count() > 0 ? duration.count() : 0;
    ++counts_[index_of(static_cast<std::uint64_t>(ns))];
    ++count_;
    max_ = ns > max_ ? ns : max_;
  }

  std::uint64_t count() const noexcept { return count_; }
  Time max() const noexcept { return Time(max_); }
  // The smallest recorded duration that at least `fraction` of all are not longer than, rounded up to its
  // bucket's end; 0 where nothing was recorded. fraction in [0, 1].
  Time percentile(double fraction) const noexcept;
  // Empty where nothing was recorded.
  std::optional<Percentiles> percentiles() const noexcept;

 private:
  static constexpr int kBucketBits = 7;
  static constexpr std::uint64_t kPerOctave = 1U << kBucketBits;
  static constexpr int kLargestShift = 29;  // 2^(29 + 8) ns = 137 s
  static constexpr std::size_t kBuckets = (kLargestShift + 2) * kPerOctave;

  // Below 2·128 each value has its bucket; above, the leading 8 bits of a value choose it.
  static constexpr std::size_t index_of(std::uint64_t ns) noexcept {
    const int shift = static_cast<int>(std::bit_width(ns | kPerOctave)) - (kBucketBits + 1);
    return shift > kLargestShift ? kBuckets - 1
                                 : static_cast<std::size_t>(shift) * kPerOctave + (ns >> shift);
  }
  // The largest value that falls into a bucket, ns.
  static constexpr std::uint64_t last_value_of(std::size_t index) noexcept {
    const std::size_t shift = index < 2 * kPerOctave ? 0 : index / kPerOctave - 1;
    return ((index - shift * kPerOctave + 1) << shift) - 1;
  }

  std::array<std::uint64_t, kBuckets> counts_{};
  std::uint64_t count_ = 0;
  std::int64_t max_ = 0;
};

}  // namespace mayfly
