#include "controller/metrics/swarm_order.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mayfly {
namespace {

using Kind = MotionQuestion::Kind;

// Shorter than this, a vector has no direction: m, m/s.
constexpr double kNoLength = 1e-9;
constexpr std::uint64_t kMoments = 100;

std::size_t most_asked(const std::vector<MotionQuestion>& questions) {
  std::size_t most = 0;
  for (const MotionQuestion& question : questions) {
    most = std::max(most, question.kind == Kind::kNearest ? question.count : 0);
  }
  return most;
}

}  // namespace

std::optional<double> polarisation(const LastSeen& seen, AgentRange range) noexcept {
  glm::dvec3 sum(0.0);
  const std::size_t count = for_each_known(seen, range, [&](std::size_t i) {
    const glm::dvec3 v = seen.velocity(i);
    const double speed = glm::length(v);
    sum += speed < kNoLength ? glm::dvec3(0.0) : v / speed;
  });
  return count > 0 ? std::optional(glm::length(sum) / static_cast<double>(count)) : std::nullopt;
}

std::optional<double> milling(const LastSeen& seen, AgentRange range) noexcept {
  const std::optional<glm::dvec3> centre = centre_of(seen, range);
  if (!centre) {
    return std::nullopt;
  }
  double sum = 0.0;
  const std::size_t count = for_each_known(seen, range, [&](std::size_t i) {
    const glm::dvec3 r = seen.place(i) - *centre;
    const glm::dvec3 v = seen.velocity(i);
    const double size = std::hypot(r.x, r.y) * std::hypot(v.x, v.y);
    sum += size < kNoLength * kNoLength ? 0.0 : (r.x * v.y - r.y * v.x) / size;
  });
  return std::fabs(sum) / static_cast<double>(count);
}

SwarmOrder::SwarmOrder(const std::vector<MotionQuestion>& questions, std::uint64_t ticks)
    : nearest_(most_asked(questions)),
      flight_ticks_(ticks),
      stride_(std::max<std::uint64_t>(1, ticks / 2 / kMoments)) {
  for (const MotionQuestion& question : questions) {
    asked_.push_back({question.kind, question.agents()});
  }
}

void SwarmOrder::observe(const LastSeen& seen) noexcept {
  const std::uint64_t tick = tick_++;
  if (2 * (tick + 1) <= flight_ticks_) {
    return;
  }
  for (Asked& asked : asked_) {
    std::optional<double> value;
    if (asked.kind == Kind::kPolarisation) {
      value = polarisation(seen, asked.range);
    } else if (asked.kind == Kind::kMilling) {
      value = milling(seen, asked.range);
    } else if (asked.kind == Kind::kNearest && tick % stride_ == 0) {
      value = nearest_.mean(seen, asked.range);
    }
    if (value) {
      asked.sum += *value;
      ++asked.ticks;
    }
  }
}

std::vector<std::optional<double>> SwarmOrder::answers() const {
  std::vector<std::optional<double>> result;
  for (const Asked& asked : asked_) {
    result.push_back(asked.ticks > 0 ? std::optional(asked.sum / static_cast<double>(asked.ticks))
                                     : std::nullopt);
  }
  return result;
}

}  // namespace mayfly
