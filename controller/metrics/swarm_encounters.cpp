#include "controller/metrics/swarm_encounters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mayfly {
namespace {

using Kind = MotionQuestion::Kind;

}  // namespace

SwarmEncounters::SwarmEncounters(std::vector<MotionQuestion> questions, std::uint64_t ticks)
    : flight_ticks_(ticks) {
  for (MotionQuestion& question : questions) {
    asked_.push_back({std::move(question)});
  }
}

void SwarmEncounters::observe(const LastSeen& seen) noexcept {
  for (Asked& asked : asked_) {
    const Kind kind = asked.question.kind;
    if (kind == Kind::kArrived || kind == Kind::kClearing || kind == Kind::kParting ||
        kind == Kind::kClosing) {
      observe_one(asked, seen);
    }
  }
  ++tick_;
}

void SwarmEncounters::observe_one(Asked& asked, const LastSeen& seen) noexcept {
  const MotionQuestion& question = asked.question;
  const glm::dvec3 place = question.place ? question.place() : glm::dvec3(0.0);
  std::size_t near = 0;
  for_each_known(seen, question.agents(), [&](std::size_t i) {
    const double distance = glm::distance(seen.place(i), place);
    asked.least = std::min(asked.least.value_or(distance), distance);
    near += distance <= question.within ? 1U : 0U;
  });
  if (question.kind == Kind::kArrived && tick_ <= question.at_tick && question.count > 0) {
    asked.arrived = static_cast<double>(near) / static_cast<double>(question.count);
  }
  if (near > 0 && !asked.start) {
    asked.start = gyration(seen, question.agents());
  }
  if (asked.start && (question.kind == Kind::kParting || question.kind == Kind::kClosing)) {
    observe_spread(asked, seen);
  }
}

void SwarmEncounters::observe_spread(Asked& asked, const LastSeen& seen) noexcept {
  const auto spread = gyration(seen, asked.question.agents());
  if (!spread) {
    return;
  }
  asked.largest = std::max(asked.largest, *spread);
  if (10 * (tick_ + 1) > 9 * flight_ticks_) {
    asked.sum += *spread;
    ++asked.ticks;
  }
}

std::vector<std::optional<double>> SwarmEncounters::answers() const {
  std::vector<std::optional<double>> result;
  for (const Asked& asked : asked_) {
    const bool met = asked.start && *asked.start > 0.0;
    std::optional<double> answer;
    switch (asked.question.kind) {
      case Kind::kArrived:
        answer = asked.arrived;
        break;
      case Kind::kClearing:
        answer = asked.least;
        break;
      case Kind::kParting:
        answer = met ? std::optional(asked.largest / *asked.start) : std::nullopt;
        break;
      case Kind::kClosing:
        answer = met && asked.ticks > 0
                     ? std::optional(asked.sum / static_cast<double>(asked.ticks) / *asked.start)
                     : std::nullopt;
        break;
      default:
        break;
    }
    result.push_back(answer);
  }
  return result;
}

}  // namespace mayfly
