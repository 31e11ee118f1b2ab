// `mayfly bench governor`: what the governor promises, attacked; what it costs in progress and in time.
#pragma once

#include <string_view>

#include "bench/common/report.hpp"
#include "core/progress.hpp"

namespace mayfly::bench {

struct GovernorPlan {
  double attack_s = 2000.0;  // flown by 50 robots at 100 Hz: 1e7 agent-ticks
  double goals_s = 200.0;    // each of the flights with collision avoidance
  Progress progress{};

  void tell(std::string_view stage, double fraction) const {
    if (progress) {
      progress(stage, fraction);
    }
  }
};

Result<Report> measure_governor(const GovernorPlan& plan);

}  // namespace mayfly::bench
