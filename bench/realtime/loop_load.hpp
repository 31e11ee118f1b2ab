// What the loop does each tick besides the model: governor and metrics, over agents that wander about.
#pragma once

#include <random>
#include <vector>

#include "controller/governor/governor.hpp"
#include "controller/metrics/metrics.hpp"

namespace mayfly::bench {

class LoopLoad {
 public:
  LoopLoad(std::size_t agents, float box, Time period)
      : governor_(*Governor::make(governor_config(agents, box, period))),
        metrics_(metrics_config(agents, period)) {
    for (auto* column : {&x_, &y_, &z_, &vx_, &vy_, &vz_, &wx_, &wy_, &wz_, &ox_, &oy_, &oz_}) {
      column->assign(agents, 0.0F);
    }
    valid_.assign(agents, 1);
    kind_.assign(agents, CommandKind::kNone);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(1.0F, box - 1.0F);
    std::uniform_real_distribution<float> speed(-1.0F, 1.0F);
    for (std::size_t i = 0; i < agents; ++i) {
      x_[i] = place(random), y_[i] = place(random), z_[i] = place(random);
      wx_[i] = speed(random), wy_[i] = speed(random), wz_[i] = speed(random);
    }
  }

  void govern(Time now) noexcept {
    governor_.govern(now, {x_, y_, z_, vx_, vy_, vz_, valid_}, {wx_, wy_, wz_}, {kind_, ox_, oy_, oz_});
  }
  void measure() noexcept { metrics_.observe({x_, y_, z_, ox_, oy_, oz_}); }
  void move(float seconds) noexcept {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      x_[i] += seconds * ox_[i], y_[i] += seconds * oy_[i], z_[i] += seconds * oz_[i];
    }
  }

 private:
  static GovernorConfig governor_config(std::size_t agents, float box, Time period) {
    GovernorConfig config;
    config.period = period;
    config.fence = {glm::vec3(0.0F), glm::vec3(box)};
    config.groups = {{0, agents, GovernorLimits{}, true}};
    return config;
  }
  static MetricsConfig metrics_config(std::size_t agents, Time period) {
    MetricsConfig config;
    config.period = period;
    config.radii.assign(agents, 0.05F);
    config.swarms = {{0, agents}};
    return config;
  }

  Governor governor_;
  Metrics metrics_;
  std::vector<float> x_, y_, z_, vx_, vy_, vz_, wx_, wy_, wz_, ox_, oy_, oz_;
  std::vector<std::uint8_t> valid_;
  std::vector<CommandKind> kind_;
};

}  // namespace mayfly::bench
