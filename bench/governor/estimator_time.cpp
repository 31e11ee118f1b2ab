#include "bench/governor/estimator_time.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "controller/estimator/estimator.hpp"

namespace mayfly::bench {
namespace {

constexpr Time kPeriod = std::chrono::milliseconds(10);
constexpr double kNoise = 0.003;  // m

// Each flies a circle of 1 m beside the last one's, at 1 m/s.
void measure(const StateColumns& to, Time now, std::mt19937& random) {
  std::normal_distribution<float> noise(0.0F, static_cast<float>(kNoise));
  const double angle = to_seconds(now);
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    to.x[i] = static_cast<float>(3.0 * static_cast<double>(i) + std::cos(angle)) + noise(random);
    to.y[i] = static_cast<float>(std::sin(angle)) + noise(random);
    to.z[i] = 1.0F + noise(random);
    to.stamp[i] = now;
    to.valid[i] = 1;
  }
}

}  // namespace

double estimator_seconds(std::size_t robots, std::uint64_t ticks) {
  EstimatorConfig config;
  config.period = kPeriod;
  config.sources.front().pose_noise = static_cast<float>(kNoise);
  config.sources.front().takes_velocity = false;
  config.robots.resize(robots);
  auto made = Estimator::create(std::move(config));
  if (!made || ticks == 0) {
    return 0.0;
  }
  std::mt19937 random(1);
  const std::vector<CommandKind> kind(robots, CommandKind::kVelocity);
  const std::vector<float> one(robots, 1.0F);
  std::vector<double> times;
  Time now{0};
  for (std::uint64_t tick = 1; tick <= ticks; ++tick) {
    now += kPeriod;
    measure(made->inbox(), now, random);
    const auto start = std::chrono::steady_clock::now();
    made->update(now);
    made->sent(now, {kind, one, one, one, now + 5 * kPeriod, tick});
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  const auto quartile = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 4);
  std::nth_element(times.begin(), quartile, times.end());
  return *quartile;
}

}  // namespace mayfly::bench
