#include "controller/estimator/estimator.hpp"

#include <cmath>
#include <utility>

#include "controller/estimator/fusion.hpp"

namespace mayfly {

Result<Estimator> Estimator::create(EstimatorConfig config) {
  if (auto good = check_and_fill(config); !good) {
    return fail(std::move(good.error()));
  }
  return Estimator(std::make_unique<Work>(std::move(config)));
}

Estimator::Estimator(std::unique_ptr<Work> work) : work_(std::move(work)) {}
Estimator::Estimator(Estimator&&) noexcept = default;
Estimator& Estimator::operator=(Estimator&&) noexcept = default;
Estimator::~Estimator() = default;

std::size_t Estimator::robots() const noexcept {
  return work_->tracks.size();
}

StateColumns Estimator::inbox(std::size_t source) noexcept {
  return work_->sources[source].inbox.columns();
}

void Estimator::update(Time now) noexcept {
  work_->update(now);
}

void Estimator::sent(Time now, const CommandColumns& commands) noexcept {
  work_->told.told(now, commands);
}

EstimateColumns Estimator::estimate() const noexcept {
  return work_->estimate();
}

std::span<const Telemetry> Estimator::telemetry(std::size_t source) const noexcept {
  return work_->sources[source].inbox.telemetry();
}

Uncertainty Estimator::uncertainty(std::size_t robot) const noexcept {
  const estimator::Track& track = work_->tracks[robot];
  if (!track.has_begun()) {
    return {};
  }
  const Eigen::Matrix2d& p = track.newest().belief.covariance;
  return {std::sqrt(p(0, 0)), std::sqrt(p(1, 1)), p(0, 1)};
}

const EstimatorCounters& Estimator::counters() const noexcept {
  return work_->counters;
}

const EstimatorConfig& Estimator::config() const noexcept {
  return work_->config;
}

}  // namespace mayfly
