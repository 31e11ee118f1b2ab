#include "bench/governor/wishes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mayfly::bench {
namespace {

constexpr std::uint64_t kPhase = 150;       // ticks that a hostile idea lasts
constexpr float kReached = 0.25F;           // m from a goal
constexpr float kAvoidanceRadius = 0.155F;  // m: half the separation and a little
constexpr float kFar = 1e4F;                // m
constexpr float kPeriod = 0.01F;            // s

}  // namespace

Wisher::Wisher(const TrialPlan& plan, glm::vec3 arena, float most_speed)
    : plan_(plan),
      arena_(arena),
      most_speed_(most_speed),
      random_(plan.seed * 7919 + 1),
      goals_(plan.agents),
      wishes_(plan.agents) {
  for (std::size_t i = 0; i < plan.agents; ++i) {
    goals_.set(i, somewhere());
  }
}

Result<void> Wisher::prepare() {
  if (plan_.wishes == Wishes::kHostile) {
    return {};
  }
  engine_ = make_native_engine(1);
  const std::vector<SwarmModel> models{model()};
  return engine_->prepare(models, plan_.agents);
}

SwarmModel Wisher::model() const {
  SwarmModel model;
  model.count = plan_.agents;
  model.walls = walls_;
  model.guide = guide_;
  model.rest = {goals_.x, goals_.y, goals_.z};
  model.avoidance = {1, kAvoidanceRadius, 2.0F, 1.0F, 2.0F, 12, most_speed_, 0};
  kernels::MfField& f = model.field;
  f.grid = {-kFar, -kFar, -kFar, 2 * kFar, 0.5F / kFar, 1, 1, 1, 0};
  f.cruise_speed = 0.75F * most_speed_;
  f.most_speed = most_speed_;
  f.slow_down = 0.5F;
  f.goal_margin = 0.1F;
  f.radius = 0.2F;
  f.approach_rate = 5.0F;
  f.low_x = f.low_y = f.low_z = 0.2F;
  f.high_x = arena_.x - 0.2F;
  f.high_y = arena_.y - 0.2F;
  f.high_z = arena_.z - 0.2F;
  return model;
}

const Columns& Wisher::wish(std::uint64_t tick, const Columns& places, const Columns& velocities) {
  if (tick % kPhase == 0) {
    point_ = somewhere();
  }
  if (plan_.wishes == Wishes::kHostile) {
    wish_hostile(tick, places);
    return wishes_;
  }
  renew_goals(places);
  engine_->compute({places.x, places.y, places.z, velocities.x, velocities.y, velocities.z},
                   {tick, static_cast<double>(tick) * static_cast<double>(kPeriod), kPeriod},
                   {wishes_.x, wishes_.y, wishes_.z});
  return wishes_;
}

void Wisher::wish_hostile(std::uint64_t tick, const Columns& places) {
  const bool stale = tick / kPhase % 6 == 5;  // what was wished last is wished on and on
  for (std::size_t i = 0; i < plan_.agents && !stale; ++i) {
    wishes_.set(i, hostile(tick, i, places));
  }
}

glm::vec3 Wisher::hostile(std::uint64_t tick, std::size_t agent, const Columns& places) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  switch (tick / kPhase % 6) {
    case 0:
      return jerk();
    case 1:
      return to_nearest(agent, places);
    case 2:
      return 10.0F * (point_ - places.at(agent));
    case 3:
      return tick % 3 == 0 ? glm::vec3(kNone, 1.0F, std::numeric_limits<float>::infinity()) : jerk();
    default:  // everybody something else
      return agent % 3 == 0
                 ? glm::vec3(1e30F, 0.0F, -std::numeric_limits<float>::max())
                 : (agent % 3 == 1 ? to_nearest(agent, places) : 10.0F * (point_ - places.at(agent)));
  }
}

glm::vec3 Wisher::to_nearest(std::size_t agent, const Columns& places) const {
  const glm::vec3 mine = places.at(agent);
  glm::vec3 nearest(0.0F);
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t j = 0; j < plan_.agents; ++j) {
    const glm::vec3 way = places.at(j) - mine;
    const float squared = glm::dot(way, way);
    if (j != agent && squared < least) {
      least = squared;
      nearest = way;
    }
  }
  return 20.0F * nearest;
}

void Wisher::renew_goals(const Columns& places) {
  for (std::size_t i = 0; i < plan_.agents; ++i) {
    switch (plan_.wishes) {
      case Wishes::kCentre:
        goals_.set(i, 0.5F * arena_);
        break;
      case Wishes::kChase:
        goals_.set(i, places.at(i) + to_nearest(i, places));
        break;
      default:
        if (glm::distance(places.at(i), goals_.at(i)) < kReached) {
          ++reached_;
          goals_.set(i, somewhere());
        }
    }
  }
}

glm::vec3 Wisher::somewhere() {
  std::uniform_real_distribution<float> share(0.1F, 0.9F);
  return {share(random_) * arena_.x, share(random_) * arena_.y, share(random_) * arena_.z};
}

glm::vec3 Wisher::jerk() {
  std::normal_distribution<float> normal(0.0F, 3.0F);
  return {normal(random_), normal(random_), normal(random_)};
}

}  // namespace mayfly::bench
