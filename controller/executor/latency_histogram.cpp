#include "controller/executor/latency_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

double to_microseconds(Time time) {
  return static_cast<double>(time.count()) * 1e-3;
}

}  // namespace

Time LatencyHistogram::percentile(double fraction) const noexcept {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(fraction * static_cast<double>(count_)));
  const std::uint64_t rank = std::max<std::uint64_t>(wanted, 1);
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i + 1 < kBuckets; ++i) {
    seen += counts_[i];
    if (seen >= rank) {
      return std::min(Time(static_cast<std::int64_t>(last_value_of(i))), max());
    }
  }
  return max();
}

std::optional<Percentiles> LatencyHistogram::percentiles() const noexcept {
  if (count_ == 0) {
    return std::nullopt;
  }
  return Percentiles{to_microseconds(percentile(0.5)), to_microseconds(percentile(0.99)),
                     to_microseconds(percentile(0.999)), to_microseconds(max())};
}

}  // namespace mayfly
