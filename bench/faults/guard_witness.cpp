#include "bench/faults/guard_witness.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace mayfly::bench {
namespace {

constexpr double kMoving = 0.05;                         // m/s
constexpr Time kGoesOn = std::chrono::milliseconds(10);  // two plant steps

}  // namespace

GuardWitness::GuardWitness(sim_hal::StepWatcher& next, const simulate::BreachWatch& breaches,
                           std::size_t robots, std::size_t ticks, float tube)
    : next_(next),
      breaches_(breaches),
      robots_(robots),
      tube_(static_cast<double>(tube)),
      truth_(robots, glm::dvec3(0.0)) {
  times_.reserve(ticks);
  seen_.reserve(ticks * robots);
}

void GuardWitness::on_step(const sim_hal::PoseView& truth) noexcept {
  next_.on_step(truth);
  for (std::size_t i = 0; i < robots_; ++i) {
    truth_[i] = glm::dvec3(truth.columns[0][i], truth.columns[1][i], truth.columns[2][i]);
  }
}

void GuardWitness::on_command(Time now, const CommandColumns& commands) noexcept {
  next_.on_command(now, commands);
  times_.push_back(now);
  for (std::size_t i = 0; i < robots_; ++i) {
    seen_.push_back(look(i, commands));
  }
}

GuardWitness::Seen GuardWitness::look(std::size_t robot, const CommandColumns& commands) const noexcept {
  Seen seen;
  if (guard_ == nullptr) {
    return seen;
  }
  const Guard& guard = guard_->guard();
  const Symptoms symptoms = guard.symptoms()[robot];
  seen.suspended = symptoms.has(Symptom::kTrackingError) || symptoms.has(Symptom::kStalePose);
  const GovernorReference reference = guard.reference(static_cast<RobotIndex>(robot));
  const bool flies = commands.kind[robot] == CommandKind::kVelocity;
  seen.off = flies && reference.known && glm::distance(reference.body, truth_[robot]) > tube_;
  const glm::dvec3 told(commands.vx[robot], commands.vy[robot], commands.vz[robot]);
  seen.moves = flies && glm::length(told) > kMoving;
  return seen;
}

bool GuardWitness::is_suspended(std::size_t robot, Time at, Time late) const {
  // The last command before it counts, and those up to `late` after it.
  const auto after = std::upper_bound(times_.begin(), times_.end(), at);
  const auto first = static_cast<std::size_t>(after - times_.begin());
  for (std::size_t tick = first > 0 ? first - 1 : 0; tick < times_.size() && times_[tick] <= at + late;
       ++tick) {
    if (seen(tick, robot).suspended) {
      return true;
    }
  }
  return false;
}

// Two that met while nothing was promised of them may need longer to part than one of them to be found again.
simulate::BreachCounts GuardWitness::suspended(Time late) const {
  simulate::BreachCounts counts{};
  std::map<std::tuple<simulate::Breach, std::uint32_t, std::uint32_t>, Time>
      until;  // of those that were suspended
  for (const simulate::Incident& incident : breaches_.incidents()) {
    const auto [known, is_new] =
        until.try_emplace({incident.breach, incident.first, incident.second}, Time::min());
    const bool goes_on = !is_new && incident.at <= known->second;
    if (goes_on || is_suspended(incident.first, incident.at, late) ||
        is_suspended(incident.second, incident.at, late)) {
      known->second = incident.at + kGoesOn;
      ++counts[static_cast<std::size_t>(incident.breach)];
    }
  }
  return counts;
}

std::optional<double> GuardWitness::left_tube(std::size_t robot, double at) const {
  for (std::size_t tick = 0; tick < times_.size(); ++tick) {
    const double time = to_seconds(times_[tick] - times_.front());
    if (time >= at && seen(tick, robot).off) {
      return time;
    }
  }
  return std::nullopt;
}

double GuardWitness::told_to_move(std::size_t robot, double from, double until) const {
  double moved = 0.0;
  for (std::size_t tick = 1; tick < times_.size(); ++tick) {
    const double begin = std::max(from, to_seconds(times_[tick - 1] - times_.front()));
    const double end = std::min(until, to_seconds(times_[tick] - times_.front()));
    moved += seen(tick - 1, robot).moves ? std::max(0.0, end - begin) : 0.0;
  }
  return moved;
}

}  // namespace mayfly::bench
