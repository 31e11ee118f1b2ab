// Where the robots' commands would have taken them, if they obey: who should be moving, and by how much.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "controller/estimator/estimator_config.hpp"
#include "core/hal.hpp"

namespace mayfly::estimator {

// A model robot follows its command within its acceleration limit, and lags where it is said to.
class ToldMotion {
 public:
  explicit ToldMotion(const std::vector<EstimatorLimits>& limits)
      : limits_(limits), wanted_(limits.size(), Velocity::Zero()), models_(limits.size()) {}

  // Lets time pass, at most until the commands' deadline; from then on the models are told to stand.
  void advance(Time now) noexcept;
  // Columns as long as there are robots, or longer; shorter ones are ignored.
  void told(Time now, const CommandColumns& commands) noexcept;

  // m, since the beginning, of the times in which it was told to move.
  const Eigen::RowVector3d& travel(std::size_t robot) const noexcept { return models_[robot].travel; }
  // m/s, as its model has it.
  const Eigen::RowVector3d& velocity(std::size_t robot) const noexcept { return models_[robot].velocity; }
  bool stands(std::size_t robot) const noexcept { return models_[robot].velocity.norm() < kStanding; }

 private:
  static constexpr double kStanding = 0.01;  // m/s
  using Velocity = Eigen::RowVector3d;
  struct Model {
    Velocity velocity = Velocity::Zero();
    Eigen::RowVector3d travel = Eigen::RowVector3d::Zero();
  };
  void pass(double seconds, bool commanded) noexcept;

  std::vector<EstimatorLimits> limits_;
  std::vector<Velocity> wanted_;  // m/s
  std::vector<Model> models_;
  Time at_{0};
  Time deadline_{0};
  bool began_ = false;
};

}  // namespace mayfly::estimator
