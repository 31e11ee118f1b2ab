#include "controller/metrics/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/finite.hpp"

namespace mayfly {
namespace {

constexpr std::size_t kNoSwarm = std::numeric_limits<std::size_t>::max();

double squared(glm::dvec3 v) {
  return glm::dot(v, v);
}

std::optional<double> fraction(std::size_t part, std::size_t all) {
  return all > 0 ? std::optional(static_cast<double>(part) / static_cast<double>(all)) : std::nullopt;
}

bool asks_anything(const std::vector<MotionQuestion>& questions) {
  return std::any_of(questions.begin(), questions.end(), [](const MotionQuestion& question) {
    return question.kind != MotionQuestion::Kind::kNone;
  });
}

// To the agents that there are.
std::vector<MotionQuestion> clipped(std::vector<MotionQuestion> questions, std::size_t agents) {
  for (MotionQuestion& question : questions) {
    question.first = std::min(question.first, agents);
    question.count = std::min(question.count, agents - question.first);
  }
  return questions;
}

}  // namespace

Metrics::Metrics(MetricsConfig config)
    : config_(std::move(config)),
      pairs_(config_.radii),
      seen_(asks_anything(config_.motions) ? config_.radii.size() : 0),
      motion_(clipped(config_.motions, seen_.agents()), config_.ticks),
      order_(clipped(config_.motions, seen_.agents()), config_.ticks),
      encounters_(clipped(config_.motions, seen_.agents()), config_.ticks) {
  const std::size_t agents = config_.radii.size();
  reached_.assign(agents, 0);
  swarm_of_.assign(agents, kNoSwarm);
  last_velocity_.assign(agents, glm::vec3(0.0F));
  last_known_.assign(agents, 0);
  for (std::size_t swarm = 0; swarm < config_.swarms.size(); ++swarm) {
    const std::size_t first = config_.swarms[swarm].first;
    const std::size_t end = std::min(first + config_.swarms[swarm].count, agents);
    for (std::size_t i = first; i < end && config_.swarms[swarm].has_goal; ++i) {
      swarm_of_[i] = swarm;
    }
  }
}

void Metrics::observe(const MetricsTick& tick) noexcept {
  const std::size_t agents = std::min({config_.radii.size(), tick.x.size(), tick.y.size(), tick.z.size(),
                                       tick.vx.size(), tick.vy.size(), tick.vz.size()});
  ++ticks_;
  pairs_.observe(tick.x, tick.y, tick.z, tick.present);
  seen_.update(tick);
  motion_.observe(seen_);
  order_.observe(seen_);
  encounters_.observe(seen_);
  observe_places(tick, agents);
  observe_speeds(tick, agents);
}

void Metrics::observe_places(const MetricsTick& tick, std::size_t agents) noexcept {
  for (std::size_t i = 0; i < agents; ++i) {
    if (!tick.is_there(i)) {
      continue;
    }
    const glm::vec3 place(tick.x[i], tick.y[i], tick.z[i]);
    if (!finite(place)) {
      ++not_finite_;
      continue;
    }
    if (!config_.obstacles.empty()) {
      observe_obstacles(place);
    }
    if (reached_[i] == 0 && config_.in_goal && swarm_of_[i] != kNoSwarm &&
        config_.in_goal(swarm_of_[i], place)) {
      reached_[i] = 1;
    }
  }
}

// Exact distances are asked for only where they can change what is known.
void Metrics::observe_obstacles(glm::vec3 place) noexcept {
  const glm::dvec3 p(place);
  ObstacleView::Bounds phi = config_.obstacles.bounds(p);
  const bool is_nearer = config_.wall_clearance && phi.low < least_clearance_;
  if (is_nearer || (phi.low <= 0.0 && phi.high >= 0.0)) {
    phi = config_.obstacles.sharpest_bounds(p);
  }
  const double twice = phi.low + phi.high;
  penetrations_ += twice < 0.0 ? 1U : 0U;
  if (is_nearer) {
    least_clearance_ = std::min(least_clearance_, 0.5 * twice);
  }
}

void Metrics::observe_speeds(const MetricsTick& tick, std::size_t agents) noexcept {
  for (std::size_t i = 0; i < agents; ++i) {
    const glm::vec3 velocity(tick.vx[i], tick.vy[i], tick.vz[i]);
    if (!tick.is_there(i)) {
      last_known_[i] = 0;
      continue;
    }
    if (!finite(velocity)) {
      not_finite_ +=
          std::isfinite(tick.x[i]) && std::isfinite(tick.y[i]) && std::isfinite(tick.z[i]) ? 1U : 0U;
      last_known_[i] = 0;
      continue;
    }
    fastest_squared_ = std::max(fastest_squared_, squared(glm::dvec3(velocity)));
    if (last_known_[i] != 0) {
      const glm::dvec3 change = glm::dvec3(velocity) - glm::dvec3(last_velocity_[i]);
      sharpest_squared_ = std::max(sharpest_squared_, squared(change));
    }
    last_velocity_[i] = velocity;
    last_known_[i] = 1;
  }
}

// Each question is answered by one of the three, if by any.
std::vector<std::optional<double>> Metrics::answers() const {
  std::vector<std::optional<double>> all = motion_.answers();
  const auto order = order_.answers();
  const auto encounters = encounters_.answers();
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = all[i] ? all[i] : order[i] ? order[i] : encounters[i];
  }
  return all;
}

MetricsResult Metrics::result() const {
  MetricsResult result;
  result.ticks = ticks_;
  if (std::isfinite(pairs_.min_distance())) {
    result.min_separation_m = pairs_.min_distance();
  }
  result.collisions = pairs_.encounters();
  result.contact_overflows = pairs_.overflows();
  result.penetrations = penetrations_;
  result.not_finite = not_finite_;
  result.motions = answers();
  if (std::isfinite(least_clearance_)) {
    result.wall_clearance_m = least_clearance_;
  }
  const auto reached_in = [&](std::size_t first, std::size_t end) {
    return static_cast<std::size_t>(std::count(reached_.begin() + static_cast<std::ptrdiff_t>(first),
                                               reached_.begin() + static_cast<std::ptrdiff_t>(end), 1));
  };
  const bool measured = config_.in_goal && ticks_ > 0;
  for (const MetricsSwarm& swarm : config_.swarms) {
    const std::size_t first = std::min(swarm.first, reached_.size());
    const std::size_t end = std::min(swarm.first + swarm.count, reached_.size());
    result.reached_fraction_of.push_back(
        measured && swarm.has_goal ? fraction(reached_in(first, end), end - first) : std::nullopt);
  }
  if (measured) {
    const auto without = static_cast<std::size_t>(std::count(swarm_of_.begin(), swarm_of_.end(), kNoSwarm));
    result.reached_fraction = fraction(reached_in(0, reached_.size()), reached_.size() - without);
  }
  if (fastest_squared_ >= 0.0) {
    result.max_speed_mps = std::sqrt(fastest_squared_);
  }
  if (sharpest_squared_ >= 0.0 && config_.period > Time{0}) {
    result.max_acceleration_mps2 = std::sqrt(sharpest_squared_) / to_seconds(config_.period);
  }
  return result;
}

}  // namespace mayfly
