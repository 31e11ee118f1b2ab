#include "controller/estimator/source_judge.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly::estimator {
namespace {

// After this many jumps in a row the next is believed.
constexpr int kBelieved = 3;
// m: who was told to go less far may well be where it was. Motors have a dead band.
constexpr double kLeastTravel = 1e-3;
constexpr double kPlaceRounding = 0x1p-20;
// Samples at one place, of one that was told to move between them.
constexpr int kEqualByChance = 2;
constexpr double kCellDiagonal = 1.7320508075688772;
// m: who stays within it stands.
constexpr double kStill = 5e-3;

}  // namespace

SourceJudge::SourceJudge(const EstimatorConfig& config, const EstimatorSource& source)
    : limits_(config.robots),
      resolution_(static_cast<double>(source.resolution)),
      frozen_samples_(config.frozen_samples),
      most_age_(config.most_age),
      suspects_(config.robots.size()),
      repeats_(config.robots.size()) {}

PoseGate SourceJudge::gate(std::size_t robot) const noexcept {
  return {static_cast<double>(limits_[robot].speed), resolution_};
}

SampleFate SourceJudge::judge(std::size_t robot, const Sample& sample, const Step& last,
                              const Eigen::RowVector3d& told) noexcept {
  if (freezes(repeats_[robot], sample, told)) {
    return SampleFate::kFrozen;
  }
  Suspect& suspect = suspects_[robot];
  const Time gap = sample.stamp - last.stamp;
  // With time every place comes within reach. Nonsense must not be taken only because it lasted: who is a
  // suspect has no longer than the age limit, unless it was away for longer than that anyhow. A robot taken
  // for another one comes back to where it really is.
  const bool waits = suspect.jumps > 0 && !suspect.swapped;
  const double seconds = to_seconds(waits ? std::min(gap, std::max(suspect.gap, most_age_)) : gap);
  const PoseGate gate = this->gate(robot);
  const Place& place = sample.value.position;
  // Nor because the real robot, or the belief, drifts towards it: one that was taken for another has been
  // told to stop since, and a belief that flies on may pass through where that other stands.
  const Place expected = suspect.swapped
                             ? Place(last.belief.place_after(to_seconds(suspect.gap)) + (told - suspect.told))
                             : last.belief.place_after(seconds);
  const Sample& other = suspect.last;  // a late sample comes before it
  const double between = std::abs(to_seconds(sample.stamp - other.stamp));
  const bool goes_on = suspect.jumps > 0 && gate.follows(other.value.position, between, sample.value) &&
                       (place - other.value.position).norm() < (place - expected).norm();
  if (!goes_on && gate.fits(last.belief, seconds, sample.value)) {
    acquit(robot);
    return SampleFate::kTaken;
  }
  suspect.agreeing = goes_on ? suspect.agreeing : 0;
  suspect_of(robot, sample, gap, told);
  return SampleFate::kJumped;
}

bool SourceJudge::may_begin_anew(std::size_t robot) const noexcept {
  const Suspect& suspect = suspects_[robot];
  return !suspect.swapped && suspect.agreeing > kBelieved;
}

void SourceJudge::forget(std::size_t robot) noexcept {
  acquit(robot);
  repeats_[robot] = {};
}

void SourceJudge::acquit(std::size_t robot) noexcept {
  if (suspects_[robot].jumps > 0) {
    suspects_[robot] = {};
    --active_;
  }
}

bool SourceJudge::freezes(Repeat& repeat, const Sample& sample,
                          const Eigen::RowVector3d& told) const noexcept {
  if (sample.stamp <= repeat.stamp) {
    return repeat.refused;  // not a fresh stamp: says nothing
  }
  const Place& place = sample.value.position;
  repeat.stamp = sample.stamp;
  if (repeat.equal == 0 || repeat.place != place) {
    repeat = {1, sample.stamp, place, told, told};
    return false;
  }
  // Only those count before which it was told to move.
  repeat.equal += told == repeat.told ? 0 : 1;
  repeat.told = told;
  // A place is the same anywhere in a cell of the resolution: as far as from corner to corner.
  const double least =
      kLeastTravel + kCellDiagonal * resolution_ + kPlaceRounding * place.cwiseAbs().maxCoeff();
  // It is refused before it is called frozen: who believes it until then believes that the robot stands.
  // Only who stops a sample before its model shows one that is equal, and no more.
  repeat.refused =
      repeat.refused || (repeat.equal > kEqualByChance && (told - repeat.first_told).norm() > least);
  repeat.frozen = repeat.frozen || (repeat.equal >= frozen_samples_ && repeat.refused);
  return repeat.refused;
}

void SourceJudge::suspect_of(std::size_t robot, const Sample& sample, Time gap,
                             const Eigen::RowVector3d& told) noexcept {
  Suspect& suspect = suspects_[robot];
  if (suspect.jumps == 0) {
    suspect.gap = gap;
    suspect.told = told;
    ++active_;
  }
  ++suspect.jumps;
  ++suspect.agreeing;
  const double reach =
      kStill + gate(robot).radius(0.0, 2.0 * sample.value.position_variance, sample.value.position);
  const bool stands =
      suspect.still > 0 && suspect.agreeing > 1 && (sample.value.position - suspect.rest).norm() <= reach;
  if (!stands) {
    suspect.rest = sample.value.position;
  }
  suspect.still = stands ? suspect.still + 1 : 1;
  suspect.last = sample;
}

}  // namespace mayfly::estimator
