// What is to be made of one source's poses, robot by robot: take, refuse, or begin anew.
#pragma once

#include <cstddef>
#include <vector>

#include "controller/estimator/estimator_config.hpp"
#include "controller/estimator/pose_gate.hpp"
#include "controller/estimator/track.hpp"

namespace mayfly::estimator {

struct Sample {
  Time stamp{0};
  Measurement value;
};

// A robot whose poses jumped: the refused ones may be nonsense, or the truth.
struct Suspect {
  int jumps = 0;     // refused, in a row
  int agreeing = 0;  // the last of them, each of which follows the one before
  int still = 0;     // the last of those, which stand on one place
  Sample last;
  Place rest = Place::Zero();  // where it began to stand
  Time gap{0};                 // between the last pose taken and the first refused
  bool swapped = false;        // its poses go on where another robot's ended …
  std::size_t owner = 0;       // … and this robot's poses where its own did
  // m, where its commands had taken it when it jumped first.
  Eigen::RowVector3d told = Eigen::RowVector3d::Zero();
};

class SourceJudge {
 public:
  SourceJudge(const EstimatorConfig& config, const EstimatorSource& source);

  // kTaken, kJumped or kFrozen, for a pose that comes after `last`. `told` is where the robot's commands have
  // taken it so far.
  SampleFate judge(std::size_t robot, const Sample& sample, const Step& last,
                   const Eigen::RowVector3d& told) noexcept;
  // Whether a refused pose may be where the robot is after all: at least the fourth in a row that agrees. The
  // three before were told, for a source has no more than one pose a tick. Not where an exchange is
  // suspected.
  bool may_begin_anew(std::size_t robot) const noexcept;
  // The robot's next pose is judged as if there had been none before.
  void forget(std::size_t robot) noexcept;
  // A pose that was taken unjudged, as the first.
  void remember(std::size_t robot, const Sample& sample, const Eigen::RowVector3d& told) noexcept {
    freezes(repeats_[robot], sample, told);
  }

  PoseGate gate(std::size_t robot) const noexcept;
  // Whether anybody's poses jump.
  bool any_suspect() const noexcept { return active_ > 0; }
  Suspect& suspect(std::size_t robot) noexcept { return suspects_[robot]; }
  const Suspect& suspect(std::size_t robot) const noexcept { return suspects_[robot]; }
  bool is_frozen(std::size_t robot) const noexcept { return repeats_[robot].frozen; }

 private:
  // Poses that are the same, bit for bit.
  struct Repeat {
    int equal = 0;  // while told to move
    Time stamp = Time::min();
    Place place = Place::Zero();
    Eigen::RowVector3d first_told = Eigen::RowVector3d::Zero();  // m, when the first of them came
    Eigen::RowVector3d told = Eigen::RowVector3d::Zero();        // m, when the last did
    bool refused = false;                                        // by then it cannot be where it was
    bool frozen = false;
  };
  bool freezes(Repeat& repeat, const Sample& sample, const Eigen::RowVector3d& told) const noexcept;
  void acquit(std::size_t robot) noexcept;
  void suspect_of(std::size_t robot, const Sample& sample, Time gap, const Eigen::RowVector3d& told) noexcept;

  std::vector<EstimatorLimits> limits_;
  double resolution_;
  int frozen_samples_;
  Time most_age_;
  std::vector<Suspect> suspects_;
  std::size_t active_ = 0;  // those with jumps
  std::vector<Repeat> repeats_;
};

}  // namespace mayfly::estimator
