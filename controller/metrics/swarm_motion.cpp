#include "controller/metrics/swarm_motion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <utility>

namespace mayfly {
namespace {

using Kind = MotionQuestion::Kind;

// Nearer to the axis than this, an agent's angle is rounding.
constexpr double kOnAxis = 1e-9;  // m

}  // namespace

SwarmMotion::SwarmMotion(std::vector<MotionQuestion> questions, std::size_t agents, std::uint64_t ticks)
    : flight_ticks_(ticks) {
  bool any = false;
  for (MotionQuestion& question : questions) {
    question.first = std::min(question.first, agents);
    question.count = std::min(question.count, agents - question.first);
    any = any || question.kind != Kind::kNone;
    Asked asked{std::move(question), {}, {}, {}};
    if (asked.question.kind == Kind::kTurns) {
      asked.heading.assign(asked.question.count, glm::dvec2(0.0));
      asked.angle.assign(asked.question.count, 0.0);
    }
    asked_.push_back(std::move(asked));
  }
  place_.assign(any ? agents : 0, glm::vec3(0.0F));
  known_.assign(place_.size(), 0);
}

void SwarmMotion::observe(std::span<const float> x, std::span<const float> y,
                          std::span<const float> z) noexcept {
  remember(x, y, z);
  for (Asked& asked : asked_) {
    observe_one(asked);
  }
  ++tick_;
}

void SwarmMotion::remember(std::span<const float> x, std::span<const float> y,
                           std::span<const float> z) noexcept {
  const std::size_t agents = std::min({place_.size(), x.size(), y.size(), z.size()});
  for (std::size_t i = 0; i < agents; ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i]) && std::isfinite(z[i])) {
      place_[i] = {x[i], y[i], z[i]};
      known_[i] = 1;
    }
  }
}

void SwarmMotion::observe_one(Asked& asked) noexcept {
  const MotionQuestion& question = asked.question;
  std::optional<double> value;
  if (question.kind == Kind::kTurns) {
    turn(asked);
  } else if (question.kind == Kind::kDistance && 2 * (tick_ + 1) > flight_ticks_ && question.place) {
    value = mean_distance(question, question.place());
  } else if (question.kind == Kind::kSpread && 10 * (tick_ + 1) > 9 * flight_ticks_) {
    const auto middle = centre(question);
    value = middle ? mean_square(question, *middle) : std::nullopt;
    value = value ? std::optional(std::sqrt(*value)) : std::nullopt;
  } else if (question.kind == Kind::kCentreDrift) {
    const auto middle = centre(question);
    asked.start = asked.start ? asked.start : middle;
    asked.sum = middle ? std::max(asked.sum, glm::distance(*middle, *asked.start)) : asked.sum;
  }
  if (value) {
    asked.sum += *value;
    ++asked.ticks;
  }
}

void SwarmMotion::turn(Asked& asked) noexcept {
  const MotionQuestion& question = asked.question;
  const glm::dvec3 axis = question.place ? question.place() : glm::dvec3(0.0);
  for (std::size_t i = 0; i < question.count; ++i) {
    const glm::dvec3 from = glm::dvec3(place_[question.first + i]) - axis;
    const glm::dvec2 now(from.x, from.y);
    if (known_[question.first + i] == 0 || glm::dot(now, now) < kOnAxis * kOnAxis) {
      continue;
    }
    const glm::dvec2 before = asked.heading[i];
    const bool had_angle = before.x != 0.0 || before.y != 0.0;
    asked.angle[i] +=
        had_angle ? std::atan2(before.x * now.y - before.y * now.x, glm::dot(before, now)) : 0.0;
    asked.heading[i] = now;
  }
}

std::optional<glm::dvec3> SwarmMotion::centre(const MotionQuestion& question) const noexcept {
  glm::dvec3 sum(0.0);
  std::size_t seen = 0;
  for (std::size_t i = question.first; i < question.first + question.count; ++i) {
    sum += known_[i] != 0 ? glm::dvec3(place_[i]) : glm::dvec3(0.0);
    seen += known_[i];
  }
  return seen > 0 ? std::optional(sum / static_cast<double>(seen)) : std::nullopt;
}

std::optional<double> SwarmMotion::mean_square(const MotionQuestion& question,
                                               glm::dvec3 from) const noexcept {
  double sum = 0.0;
  std::size_t seen = 0;
  for (std::size_t i = question.first; i < question.first + question.count; ++i) {
    const glm::dvec3 way = glm::dvec3(place_[i]) - from;
    sum += known_[i] != 0 ? glm::dot(way, way) : 0.0;
    seen += known_[i];
  }
  return seen > 0 ? std::optional(sum / static_cast<double>(seen)) : std::nullopt;
}

std::optional<double> SwarmMotion::mean_distance(const MotionQuestion& question,
                                                 glm::dvec3 from) const noexcept {
  double sum = 0.0;
  std::size_t seen = 0;
  for (std::size_t i = question.first; i < question.first + question.count; ++i) {
    sum += known_[i] != 0 ? glm::distance(glm::dvec3(place_[i]), from) : 0.0;
    seen += known_[i];
  }
  return seen > 0 ? std::optional(sum / static_cast<double>(seen)) : std::nullopt;
}

std::optional<double> SwarmMotion::turns(const Asked& asked) const {
  double sum = 0.0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < asked.question.count; ++i) {
    const bool known = known_[asked.question.first + i] != 0;
    sum += known ? std::fabs(asked.angle[i]) / (2.0 * std::numbers::pi) : 0.0;
    seen += known ? 1 : 0;
  }
  return seen > 0 ? std::optional(sum / static_cast<double>(seen)) : std::nullopt;
}

std::vector<std::optional<double>> SwarmMotion::answers() const {
  std::vector<std::optional<double>> result;
  for (const Asked& asked : asked_) {
    std::optional<double> answer;
    if (asked.question.kind == Kind::kTurns) {
      answer = turns(asked);
    } else if (asked.start) {
      answer = asked.sum;
    } else if (asked.ticks > 0) {
      answer = asked.sum / static_cast<double>(asked.ticks);
    }
    result.push_back(answer);
  }
  return result;
}

}  // namespace mayfly
