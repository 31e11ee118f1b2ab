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

std::optional<double> mean_distance(const LastSeen& seen, const MotionQuestion& question,
                                    glm::dvec3 from) noexcept {
  double sum = 0.0;
  const auto count = for_each_known(seen, question.agents(),
                                    [&](std::size_t i) { sum += glm::distance(seen.place(i), from); });
  return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

}  // namespace

SwarmMotion::SwarmMotion(std::vector<MotionQuestion> questions, std::uint64_t ticks) : flight_ticks_(ticks) {
  for (MotionQuestion& question : questions) {
    Asked asked{std::move(question), {}, {}, {}, {}};
    if (asked.question.kind == Kind::kTurns) {
      asked.heading.assign(asked.question.count, glm::dvec2(0.0));
      asked.angle.assign(asked.question.count, 0.0);
      asked.met.assign(asked.question.count, 0);
    }
    asked_.push_back(std::move(asked));
  }
}

void SwarmMotion::observe(const LastSeen& seen) noexcept {
  for (Asked& asked : asked_) {
    observe_one(asked, seen);
  }
  ++tick_;
}

void SwarmMotion::observe_one(Asked& asked, const LastSeen& seen) noexcept {
  const MotionQuestion& question = asked.question;
  std::optional<double> value;
  if (question.kind == Kind::kTurns) {
    turn(asked, seen);
  } else if (question.kind == Kind::kDistance && 2 * (tick_ + 1) > flight_ticks_ && question.place) {
    value = mean_distance(seen, question, question.place());
  } else if (question.kind == Kind::kSpread && 10 * (tick_ + 1) > 9 * flight_ticks_) {
    value = gyration(seen, question.agents());
  } else if (question.kind == Kind::kCentreDrift) {
    const auto middle = centre_of(seen, question.agents());
    asked.start = asked.start ? asked.start : middle;
    asked.sum = middle ? std::max(asked.sum, glm::distance(*middle, *asked.start)) : asked.sum;
  }
  if (value) {
    asked.sum += *value;
    ++asked.ticks;
  }
}

void SwarmMotion::turn(Asked& asked, const LastSeen& seen) noexcept {
  const MotionQuestion& question = asked.question;
  const glm::dvec3 axis = question.place ? question.place() : glm::dvec3(0.0);
  for_each_known(seen, question.agents(), [&](std::size_t agent) {
    const std::size_t i = agent - question.first;
    asked.met[i] = 1;
    const glm::dvec3 from = seen.place(agent) - axis;
    const glm::dvec2 now(from.x, from.y);
    if (glm::dot(now, now) < kOnAxis * kOnAxis) {
      return;
    }
    const glm::dvec2 before = asked.heading[i];
    const bool had_angle = before.x != 0.0 || before.y != 0.0;
    asked.angle[i] +=
        had_angle ? std::atan2(before.x * now.y - before.y * now.x, glm::dot(before, now)) : 0.0;
    asked.heading[i] = now;
  });
}

std::optional<double> SwarmMotion::turns(const Asked& asked) {
  double sum = 0.0;
  std::size_t met = 0;
  for (std::size_t i = 0; i < asked.question.count; ++i) {
    sum += std::fabs(asked.angle[i]) / (2.0 * std::numbers::pi);
    met += asked.met[i];
  }
  return met > 0 ? std::optional(sum / static_cast<double>(met)) : std::nullopt;
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
