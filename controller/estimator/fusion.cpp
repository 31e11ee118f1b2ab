#include "controller/estimator/fusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace mayfly {

namespace {

using estimator::Sample;
using estimator::Step;
using estimator::Track;

constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
// A velocity may exceed the limit, as a pose may: wind, a limit that was a guess. This far is nonsense.
constexpr double kTooFast = 1.5;
// Corner of the box of 3σ, as for poses.
constexpr double kDeviations = 3.0 * 1.7320508075688772;
// Over which a drift is averaged: longer than a change of velocity takes, shorter than a hold.
constexpr double kDriftSeconds = 0.1;

// Samples a robot. One perfect source has nothing to say of now with what it says of earlier.
std::size_t remembered(const EstimatorConfig& config) {
  constexpr std::size_t kRemembered = 16;
  const EstimatorSource& only = config.sources.front();
  const bool perfect = only.takes_pose && only.takes_velocity && only.pose_noise <= 0.0F &&
                       only.velocity_noise <= 0.0F && only.resolution <= 0.0F;
  return config.sources.size() == 1 && perfect ? 1 : kRemembered;
}

double square(float value) {
  return static_cast<double>(value) * static_cast<double>(value);
}

bool is_place(const Eigen::RowVector3d& place) {
  return place.allFinite() && place.cwiseAbs().maxCoeff() <= estimator::kFarthest;
}

bool is_velocity(const Eigen::RowVector3d& velocity) {
  return velocity.allFinite() && velocity.cwiseAbs().maxCoeff() <= estimator::kFastest;
}

}  // namespace

Estimator::Work::Source::Source(const EstimatorConfig& all, const EstimatorSource& one)
    : spec(one),
      inbox(all.robots.size()),
      judge(all, one),
      swaps(all.robots.size()),
      is_nonsense(all.robots.size()) {}

Estimator::Work::Work(EstimatorConfig all)
    : config(std::move(all)),
      told(config.robots),
      steps(config.robots.size() * remembered(config)),
      x_(config.robots.size(), kNowhere),
      y_(x_),
      z_(x_),
      vx_(config.robots.size()),
      vy_(vx_),
      vz_(vx_),
      stamp_(config.robots.size()),
      known_(config.robots.size()),
      fresh_(config.robots.size()),
      anew_(config.robots.size()),
      drift_x_(config.robots.size()),
      drift_y_(drift_x_),
      drift_z_(drift_x_),
      symptoms_(config.robots.size()) {
  for (const EstimatorSource& source : config.sources) {
    sources.emplace_back(config, source);
  }
  for (std::size_t r = 0; r < config.robots.size(); ++r) {
    tracks.emplace_back(std::span(steps).subspan(r * remembered(config), remembered(config)));
  }
  for (const EstimatorLimits& limits : config.robots) {
    density_.push_back(
        estimator::acceleration_density(static_cast<double>(limits.acceleration), to_seconds(config.period)));
  }
}

void Estimator::Work::update(Time now) noexcept {
  if (counters.updates++ == 0) {
    began_ = now;
  }
  if (config.gates) {
    told.advance(now);
  }
  for (std::size_t r = 0; r < tracks.size(); ++r) {
    fresh_[r] = 0;
    anew_[r] = 0;
    hear(r, now);
  }
  look_for_swaps(now);
  for (std::size_t r = 0; r < tracks.size(); ++r) {
    tell(r, now);
  }
}

// All that is new of a robot, the oldest first.
void Estimator::Work::hear(std::size_t robot, Time now) noexcept {
  std::array<Pending, EstimatorConfig::kMostSources> pending;
  std::size_t count = 0;
  for (Source& source : sources) {
    const std::size_t column = source.swaps.column_of(robot);
    if (!source.inbox.take_new(column)) {
      continue;
    }
    std::size_t at = count++;
    for (; at > 0 && pending[at - 1].source->inbox.stamp(pending[at - 1].column) > source.inbox.stamp(column);
         --at) {
      pending[at] = pending[at - 1];
    }
    pending[at] = {&source, column};
  }
  for (std::size_t i = 0; i < count; ++i) {
    ++counters.samples[static_cast<std::size_t>(take(robot, pending[i], now))];
  }
}

SampleFate Estimator::Work::take(std::size_t robot, const Pending& pending, Time now) noexcept {
  Source& source = *pending.source;
  const Time stamp = source.inbox.stamp(pending.column);
  if (stamp > now + config.most_ahead) {
    return SampleFate::kFuture;
  }
  if (stamp < now - config.most_age) {
    return SampleFate::kTooOld;
  }
  const bool is_sense = (!source.spec.takes_pose || is_place(source.inbox.place(pending.column))) &&
                        (!source.spec.takes_velocity || is_velocity(source.inbox.velocity(pending.column)));
  source.is_nonsense[robot] = is_sense ? 0 : 1;
  if (!is_sense) {
    return SampleFate::kNotFinite;
  }
  Sample sample = sample_of(source, pending.column);
  const double most_speed = kTooFast * static_cast<double>(config.robots[robot].speed) +
                            kDeviations * std::sqrt(sample.value.velocity_variance);
  if (sample.value.has_velocity && sample.value.velocity.norm() > most_speed) {
    if (!sample.value.has_position) {
      return SampleFate::kTooFast;
    }
    ++counters.samples[static_cast<std::size_t>(SampleFate::kTooFast)];
    sample.value.has_velocity = false;
  }
  if (sample.value.has_position) {
    return take_pose(robot, source, sample);
  }
  return tracks[robot].has_begun() ? fuse(robot, sample) : SampleFate::kUnplaced;
}

SampleFate Estimator::Work::take_pose(std::size_t robot, Source& source, const Sample& sample) noexcept {
  Track& track = tracks[robot];
  if (!track.has_begun()) {
    begin(robot, sample);
    source.judge.remember(robot, sample, told.travel(robot));
    return SampleFate::kTaken;
  }
  const Step* last = track.before(sample.stamp);
  if (last == nullptr) {
    return SampleFate::kTooOld;
  }
  const SampleFate fate =
      config.gates ? source.judge.judge(robot, sample, *last, told.travel(robot)) : SampleFate::kTaken;
  if (fate == SampleFate::kJumped && source.judge.may_begin_anew(robot) && !is_taken(robot, source, sample)) {
    begin(robot, sample);
    ++counters.started_anew;
    anew_[robot] = 1;
    return SampleFate::kTaken;
  }
  if (fate != SampleFate::kTaken) {
    return fate;
  }
  stamp_[robot] = std::max(stamp_[robot], sample.stamp);
  fresh_[robot] = 1;
  return fuse(robot, sample);
}

SampleFate Estimator::Work::fuse(std::size_t robot, const Sample& sample) noexcept {
  Track& track = tracks[robot];
  if (track.before(sample.stamp) == nullptr) {
    return SampleFate::kTooOld;
  }
  const bool is_late = sample.stamp < track.newest().stamp;
  track.take(sample.stamp, sample.value, density_[robot]);
  return is_late ? SampleFate::kTakenLate : SampleFate::kTaken;
}

void Estimator::Work::begin(std::size_t robot, const Sample& sample) noexcept {
  tracks[robot].begin(sample.stamp, sample.value, static_cast<double>(config.robots[robot].speed));
  stamp_[robot] = sample.stamp;
  fresh_[robot] = 1;
  for (Source& source : sources) {
    source.judge.forget(robot);
  }
}

bool Estimator::Work::is_taken(std::size_t robot, const Source& source, const Sample& sample) const noexcept {
  for (std::size_t r = 0; r < tracks.size(); ++r) {
    const Time age = sample.stamp - stamp_[r];
    if (r == robot || !tracks[r].has_begun() || age > config.most_age || source.judge.suspect(r).jumps > 0) {
      continue;
    }
    const Step& last = tracks[r].newest();
    const double seconds = std::max(to_seconds(sample.stamp - last.stamp), 0.0);
    if (source.judge.gate(r).fits(last.belief, seconds, sample.value)) {
      return true;
    }
  }
  return false;
}

Sample Estimator::Work::sample_of(const Source& source, std::size_t column) noexcept {
  // A reading is rounded to the resolution, evenly.
  const double rounding = square(source.spec.resolution) / 12.0;
  Sample sample;
  sample.stamp = source.inbox.stamp(column);
  sample.value.has_position = source.spec.takes_pose;
  sample.value.has_velocity = source.spec.takes_velocity;
  sample.value.position_variance = square(source.spec.pose_noise) + rounding;
  sample.value.velocity_variance = square(source.spec.velocity_noise);
  if (source.spec.takes_pose) {
    sample.value.position = source.inbox.place(column);
  }
  if (source.spec.takes_velocity) {
    sample.value.velocity = source.inbox.velocity(column);
  }
  return sample;
}

void Estimator::Work::look_for_swaps(Time now) noexcept {
  everybody_ = {};
  for (Source& source : sources) {
    if (!source.judge.any_suspect()) {
      continue;
    }
    if (source.swaps.find(now, config.most_age, source.judge, tracks)) {
      ++counters.id_swaps;
    }
    // Told once more where it is just being settled: the tick in which robots get other poses is no normal
    // one.
    if (source.swaps.any(source.judge)) {
      everybody_.add(Symptom::kIdSwap);
    }
    if (source.swaps.settle(config.frozen_samples, source.judge, told)) {
      for (const estimator::IdSwaps::Begun& begun : source.swaps.begun()) {
        begin(begun.robot, begun.sample);
      }
    }
  }
}

void Estimator::Work::tell(std::size_t robot, Time now) noexcept {
  const Track& track = tracks[robot];
  Symptoms symptoms;
  for (const Source& source : sources) {
    if (source.is_nonsense[robot] != 0) {
      symptoms.add(Symptom::kPoseNotFinite);
    }
    if (source.judge.is_frozen(robot)) {
      symptoms.add(Symptom::kFrozenPose);
    }
    if (source.judge.suspect(robot).jumps > 0) {
      symptoms.add(Symptom::kPoseJump);
    }
  }
  const bool is_stale = now - (track.has_begun() ? stamp_[robot] : began_) > config.most_age;
  if (is_stale) {
    symptoms.add(Symptom::kStalePose);
  }
  symptoms_[robot] = symptoms;
  known_[robot] = track.has_begun() && !is_stale ? 1 : 0;
  if (known_[robot] == 0) {
    drift_x_[robot] = drift_y_[robot] = drift_z_[robot] = 0.0F;
    return;
  }
  const Step& last = track.newest();
  const Eigen::RowVector3d velocity = last.belief.mean.row(1);
  if (config.gates && fresh_[robot] != 0) {
    follow_drift(robot, velocity);
  }
  // Without a way to go there is nothing to add, and the bits stay.
  const estimator::Place place =
      now == last.stamp ? last.belief.place() : last.belief.place_after(to_seconds(now - last.stamp));
  x_[robot] = static_cast<float>(place[0]);
  y_[robot] = static_cast<float>(place[1]);
  z_[robot] = static_cast<float>(place[2]);
  vx_[robot] = static_cast<float>(velocity[0]);
  vy_[robot] = static_cast<float>(velocity[1]);
  vz_[robot] = static_cast<float>(velocity[2]);
}

// A measured velocity lags behind a told one by the age of its pose; over a change of course that cancels.
void Estimator::Work::follow_drift(std::size_t robot, const Eigen::RowVector3d& velocity) noexcept {
  const double share = std::min(1.0, to_seconds(config.pose_period) / kDriftSeconds);
  const Eigen::RowVector3d off = velocity - told.velocity(robot);
  float* const drift[] = {&drift_x_[robot], &drift_y_[robot], &drift_z_[robot]};
  for (int axis = 0; axis < 3; ++axis) {
    float& along = *drift[axis];
    along = anew_[robot] != 0 ? 0.0F
                              : along + static_cast<float>(share) * (static_cast<float>(off[axis]) - along);
  }
}

EstimateColumns Estimator::Work::estimate() const noexcept {
  return {x_,        y_,         z_,     vx_,   vy_,      vz_,      stamp_,  known_,
          symptoms_, everybody_, fresh_, anew_, drift_x_, drift_y_, drift_z_};
}

}  // namespace mayfly
