#include "bench/governor/trial.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <utility>

#include "bench/governor/true_robot.hpp"
#include "bench/governor/wishes.hpp"
#include "controller/governor/governor.hpp"

namespace mayfly::bench {
namespace {

constexpr double kPeriod = 0.01;  // s
constexpr int kSubSamples = 4;
// The governor keeps a command's limits in double and rounds each coordinate to a float: that moves the
// command by at most 2⁻²⁴ of its length. Its own arithmetic and the one here, some tens of roundings of
// numbers below 10, add less than 10⁻¹².
constexpr double kRounding = 0x1p-24;  // relative
constexpr double kArithmetic = 1e-12;  // m/s

GovernorLimits limits_of(const TrialPlan& plan, int kind) {
  GovernorLimits limits;
  limits.speed = 2.0F;
  limits.acceleration = limits.braking = 4.0F;
  limits.radius = 0.1F;
  limits.tube = 0.05F;
  limits.latency = plan.latency;
  if (plan.uneven) {
    limits.speed = kind == 0 ? 2.0F : 1.0F;
    limits.braking = kind == 1 ? 3.0F : 4.0F;
    limits.radius = kind == 2 ? 0.15F : 0.1F;
    limits.downwash = kind == 2 ? 2.0F : 1.0F;
  }
  return limits;
}

class Trial {
 public:
  explicit Trial(const TrialPlan& plan)
      : plan_(plan),
        arena_(glm::vec3(8.0F, 8.0F, 3.0F) * std::cbrt(static_cast<float>(plan.agents) / 50.0F)),
        random_(plan.seed),
        wisher_(plan, arena_, 2.0F),
        places_(plan.agents),
        velocities_(plan.agents),
        sent_(plan.agents),
        known_(plan.agents, 1),
        kinds_(plan.agents) {
    result_.least_gap = std::numeric_limits<double>::infinity();
  }

  Result<TrialResult> run() {
    auto governor = Governor::make(config());
    if (!governor) {
      return fail(std::move(governor.error()));
    }
    if (auto ok = wisher_.prepare(); !ok) {
      return fail(std::move(ok.error()));
    }
    place_robots();
    for (std::uint64_t tick = 0; tick < plan_.ticks; ++tick) {
      measure(tick);
      command(*governor, tick, wisher_.wish(tick, places_, sent_));
      move();
    }
    result_.agent_ticks = plan_.ticks * plan_.agents;
    result_.goals = wisher_.goals_reached();
    auto middle = took_.begin() + static_cast<std::ptrdiff_t>(took_.size() / 2);
    std::nth_element(took_.begin(), middle, took_.end());
    result_.governor_seconds = took_.empty() ? 0.0 : *middle;
    return result_;
  }

 private:
  GovernorConfig config() {
    GovernorConfig config;
    config.period = from_seconds(kPeriod);
    config.fence = {glm::vec3(0.0F), arena_};
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      limits_.push_back(limits_of(plan_, static_cast<int>(i % 3)));
      config.groups.push_back({.first = i, .count = 1, .limits = limits_.back()});
    }
    return config;
  }

  double needed(std::size_t i, std::size_t j) const {
    return static_cast<double>(limits_[i].radius) + static_cast<double>(limits_[j].radius);
  }
  // The distance of two, heights shortened as the flatter of them wants it.
  double distance(std::size_t i, std::size_t j, const std::vector<glm::dvec3>& at) const {
    glm::dvec3 way = at[i] - at[j];
    way.z /= static_cast<double>(std::max(limits_[i].downwash, limits_[j].downwash));
    return glm::length(way);
  }

  void place_robots() {
    std::uniform_real_distribution<double> share(0.1, 0.9);
    std::vector<glm::dvec3> at;
    while (at.size() < plan_.agents) {
      at.push_back(glm::dvec3(arena_) * glm::dvec3(share(random_), share(random_), share(random_)));
      const std::size_t last = at.size() - 1;
      for (std::size_t j = 0; j < last; ++j) {
        if (distance(last, j, at) < needed(last, j) + 0.15) {
          at.pop_back();
          break;
        }
      }
    }
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      TrueRobot robot{.place = at[i], .acceleration = 4.0};
      const auto late = plan_.latency == 0 ? 0 : random_() % static_cast<std::uint64_t>(plan_.latency + 1);
      robot.waiting.assign(late, glm::dvec3(0.0));
      robots_.push_back(robot);
    }
  }

  void measure(std::uint64_t tick) {
    std::normal_distribution<double> noise(0.0, 1.0);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      known_[i] = tick > 0 && chance(random_) < plan_.dropout ? 0 : 1;
      const glm::dvec3 off =
          plan_.pose_noise > 0.0
              ? plan_.pose_noise * glm::dvec3(noise(random_), noise(random_), noise(random_))
              : glm::dvec3(0.0);
      places_.set(i, glm::vec3(robots_[i].place + (tick > 0 ? off : glm::dvec3(0.0))));
      velocities_.set(i, glm::vec3(robots_[i].velocity));
    }
  }

  void command(Governor& governor, std::uint64_t tick, const Columns& wishes) {
    const Columns before = sent_;
    if (plan_.governed) {
      const auto start = std::chrono::steady_clock::now();
      governor.govern(from_seconds(kPeriod * static_cast<double>(tick)),
                      {places_.x, places_.y, places_.z, velocities_.x, velocities_.y, velocities_.z, known_},
                      {wishes.x, wishes.y, wishes.z}, {kinds_, sent_.x, sent_.y, sent_.z});
      took_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    } else {
      sent_ = wishes;
    }
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      const glm::dvec3 w(sent_.at(i));
      const double rounding = kRounding * glm::length(w) + kArithmetic;
      result_.too_fast += !(glm::length(w) <= static_cast<double>(limits_[i].speed) + rounding) ? 1U : 0U;
      const double change = glm::length(w - glm::dvec3(before.at(i)));
      const double most = static_cast<double>(limits_[i].acceleration) * kPeriod;
      result_.too_sudden += !(change <= most + rounding) ? 1U : 0U;
    }
  }

  void move() {
    std::vector<glm::dvec3> told(plan_.agents);
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      told[i] = robots_[i].exchange(glm::dvec3(sent_.at(i)));
    }
    for (int sample = 1; sample <= kSubSamples; ++sample) {
      at_.clear();
      for (std::size_t i = 0; i < plan_.agents; ++i) {
        at_.push_back(robots_[i].after(told[i], kPeriod * sample / kSubSamples).place);
      }
      look();
    }
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      result_.travelled += glm::length(at_[i] - robots_[i].place);
      robots_[i] = robots_[i].after(told[i], kPeriod);
    }
  }

  void look() {
    ++result_.samples;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < plan_.agents; ++i) {
      const glm::dvec3 faces = glm::min(at_[i], glm::dvec3(arena_) - at_[i]);
      const double inside = std::min({faces.x, faces.y, faces.z});
      result_.outside += inside < static_cast<double>(limits_[i].radius) ? 1U : 0U;
      for (std::size_t j = 0; j < i; ++j) {
        least = std::min(least, distance(i, j, at_) - needed(i, j));
      }
    }
    result_.least_gap = std::min(result_.least_gap, least);
    result_.near_samples += least < 0.0 ? 1U : 0U;
  }

  TrialPlan plan_;
  glm::vec3 arena_;
  std::mt19937_64 random_;
  Wisher wisher_;
  std::vector<GovernorLimits> limits_;
  std::vector<TrueRobot> robots_;
  std::vector<glm::dvec3> at_;
  Columns places_, velocities_, sent_;
  std::vector<std::uint8_t> known_;
  std::vector<CommandKind> kinds_;
  std::vector<double> took_;
  TrialResult result_;
};

}  // namespace

Result<TrialResult> run_trial(const TrialPlan& plan) {
  return Trial(plan).run();
}

}  // namespace mayfly::bench
