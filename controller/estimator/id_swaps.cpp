#include "controller/estimator/id_swaps.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mayfly::estimator {
namespace {

constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

}  // namespace

IdSwaps::IdSwaps(std::size_t robots) : columns_(robots), begun_(robots) {
  std::iota(columns_.begin(), columns_.end(), std::size_t{0});
}

bool IdSwaps::find(Time now, Time window, SourceJudge& judge, std::span<const Track> tracks) noexcept {
  gather(now, window, judge);
  for (std::size_t i = 0; i < jumped_count_; ++i) {
    owners_[i] = owner_of(i, judge, tracks[jumped_[i]]);
  }
  bool found = false;
  for (std::size_t i = 0; i < jumped_count_; ++i) {
    found = (!judge.suspect(jumped_[i]).swapped && mark_ring(i, judge)) || found;
  }
  return found;
}

void IdSwaps::gather(Time now, Time window, const SourceJudge& judge) noexcept {
  jumped_count_ = 0;
  for (std::size_t r = 0; r < columns_.size(); ++r) {
    const Suspect& suspect = judge.suspect(r);
    if (suspect.jumps == 0 || suspect.swapped || now - suspect.last.stamp > window) {
      continue;
    }
    if (jumped_count_ == kMostAtOnce) {
      jumped_count_ = 0;
      return;
    }
    jumped_[jumped_count_++] = r;
  }
}

// Whose refused pose is nearest to where this robot is expected, of those that it can have got to.
std::size_t IdSwaps::owner_of(std::size_t robot, const SourceJudge& judge,
                              const Track& track) const noexcept {
  const Step& last = track.newest();
  std::size_t owner = kNobody;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < jumped_count_; ++k) {
    const Sample& sample = judge.suspect(jumped_[k]).last;
    const double seconds = std::max(to_seconds(sample.stamp - last.stamp), 0.0);
    const double distance = (sample.value.position - last.belief.place_after(seconds)).norm();
    if (k != robot && distance < nearest &&
        judge.gate(jumped_[robot]).fits(last.belief, seconds, sample.value)) {
      owner = k;
      nearest = distance;
    }
  }
  return owner;
}

// From owner to owner, back to where it began: a ring of two or more.
bool IdSwaps::mark_ring(std::size_t start, SourceJudge& judge) noexcept {
  std::size_t at = start;
  std::size_t steps = 0;
  do {
    at = owners_[at];
    ++steps;
  } while (at != kNobody && at != start && steps <= jumped_count_);
  if (at != start) {
    return false;
  }
  do {
    Suspect& suspect = judge.suspect(jumped_[at]);
    suspect.swapped = true;
    suspect.owner = jumped_[owners_[at]];
    at = owners_[at];
  } while (at != start);
  return true;
}

bool IdSwaps::any(const SourceJudge& judge) const noexcept {
  for (std::size_t r = 0; r < columns_.size(); ++r) {
    if (judge.suspect(r).swapped) {
      return true;
    }
  }
  return false;
}

// Where one of a ring was given back its name, the others have merely jumped.
void IdSwaps::drop_broken_rings(SourceJudge& judge) const noexcept {
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t r = 0; r < columns_.size(); ++r) {
      Suspect& suspect = judge.suspect(r);
      if (suspect.swapped && !judge.suspect(suspect.owner).swapped) {
        suspect.swapped = false;
        changed = true;
      }
    }
  }
}

bool IdSwaps::settle(int samples, SourceJudge& judge, const ToldMotion& told) noexcept {
  drop_broken_rings(judge);
  begun_count_ = 0;
  for (std::size_t r = 0; r < columns_.size(); ++r) {
    const Suspect& suspect = judge.suspect(r);
    if (!suspect.swapped) {
      continue;
    }
    const Suspect& owner = judge.suspect(suspect.owner);
    if (owner.still < samples || !told.stands(r)) {
      begun_count_ = 0;
      return false;
    }
    begun_[begun_count_++] = {r, columns_[suspect.owner], owner.last};
  }
  // Each column was read before any is written.
  for (const Begun& begun : this->begun()) {
    columns_[begun.robot] = begun.column;
  }
  return begun_count_ > 0;
}

}  // namespace mayfly::estimator
