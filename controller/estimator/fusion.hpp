// What an Estimator does: samples in, tracks on, columns out. For estimator.cpp only.
#pragma once

#include <span>
#include <vector>

#include "controller/estimator/estimator.hpp"
#include "controller/estimator/id_swaps.hpp"
#include "controller/estimator/inbox.hpp"
#include "controller/estimator/source_judge.hpp"
#include "controller/estimator/told_motion.hpp"
#include "controller/estimator/track.hpp"

namespace mayfly {

class Estimator::Work {
 public:
  explicit Work(EstimatorConfig config);

  void update(Time now) noexcept;
  EstimateColumns estimate() const noexcept;

  EstimatorConfig config;
  EstimatorCounters counters;
  estimator::ToldMotion told;

  struct Source {
    Source(const EstimatorConfig& all, const EstimatorSource& one);
    EstimatorSource spec;
    estimator::Inbox inbox;
    estimator::SourceJudge judge;
    estimator::IdSwaps swaps;
    std::vector<std::uint8_t> is_nonsense;  // one a robot: its last sample was not a number
  };
  std::vector<Source> sources;
  std::vector<estimator::Step> steps;  // of all tracks
  std::vector<estimator::Track> tracks;

 private:
  struct Pending {
    Source* source = nullptr;
    std::size_t column = 0;
  };

  void hear(std::size_t robot, Time now) noexcept;
  SampleFate take(std::size_t robot, const Pending& pending, Time now) noexcept;
  SampleFate take_pose(std::size_t robot, Source& source, const estimator::Sample& sample) noexcept;
  SampleFate fuse(std::size_t robot, const estimator::Sample& sample) noexcept;
  void begin(std::size_t robot, const estimator::Sample& sample) noexcept;
  // Whether another robot, of which nothing is suspected, is expected there.
  bool is_taken(std::size_t robot, const Source& source, const estimator::Sample& sample) const noexcept;
  estimator::Sample sample_of(const Source& source, std::size_t column) noexcept;
  void look_for_swaps(Time now) noexcept;
  void tell(std::size_t robot, Time now) noexcept;
  void follow_drift(std::size_t robot, const Eigen::RowVector3d& velocity) noexcept;

  std::vector<double> density_;  // m²/s³, one a robot
  std::vector<float> x_, y_, z_, vx_, vy_, vz_;
  std::vector<Time> stamp_;  // of the newest pose taken
  std::vector<std::uint8_t> known_, fresh_, anew_;
  std::vector<float> drift_x_, drift_y_, drift_z_;
  std::vector<Symptoms> symptoms_;
  Symptoms everybody_;
  Time began_{0};
};

}  // namespace mayfly
