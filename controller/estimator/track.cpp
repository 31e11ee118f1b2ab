#include "controller/estimator/track.hpp"

namespace mayfly::estimator {
namespace {

Belief after(const Step& earlier, Time stamp, const Measurement& measurement, double density) {
  if (is_perfect(measurement)) {
    return estimator::begin(measurement, 0.0);  // whatever was believed before
  }
  Belief belief = predict(earlier.belief, to_seconds(stamp - earlier.stamp), density);
  correct(belief, measurement);
  return belief;
}

}  // namespace

void Track::begin(Time stamp, const Measurement& first, double most_speed) noexcept {
  first_ = 0;
  count_ = 1;
  at(0) = {stamp, first, estimator::begin(first, most_speed)};
}

const Step* Track::before(Time stamp) const noexcept {
  for (std::size_t i = count_; i > 0; --i) {
    if (at(i - 1).stamp <= stamp) {
      return &at(i - 1);
    }
  }
  return nullptr;
}

void Track::take(Time stamp, const Measurement& measurement, double density) noexcept {
  std::size_t place = count_;
  while (place > 1 && at(place - 1).stamp > stamp) {
    --place;
  }
  const Step step{stamp, measurement, after(at(place - 1), stamp, measurement, density)};
  if (count_ == steps_.size()) {
    first_ = (first_ + 1) % steps_.size();
    --count_;
    --place;
  }
  for (std::size_t i = count_; i > place; --i) {
    at(i) = at(i - 1);
  }
  at(place) = step;
  ++count_;
  for (std::size_t i = place + 1; i < count_; ++i) {
    at(i).belief = after(at(i - 1), at(i).stamp, at(i).measurement, density);
  }
}

}  // namespace mayfly::estimator
