#include "simulate/sabotage.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "simulate/bad_wishes.hpp"

namespace mayfly::simulate {
namespace {

std::vector<FaultSpec> faults_at(const Scenario& scenario, FaultPlace place) {
  std::vector<FaultSpec> faults;
  std::copy_if(scenario.faults.begin(), scenario.faults.end(), std::back_inserter(faults),
               [place](const FaultSpec& fault) { return fault_row(fault.kind).place == place; });
  return faults;
}

std::size_t agent(const FaultSpec& fault, std::size_t number) {
  for (const StruckAgents& range : fault.agents) {
    if (number < range.count) {
      return range.first + number;
    }
    number -= range.count;
  }
  return 0;
}

// Through the wall that the direction points at most.
void move_out(glm::vec3& place, const FaultSpec& fault, const Box& bounds) {
  int axis = 0;
  for (int other = 1; other < 3; ++other) {
    axis = std::fabs(fault.direction[other]) > std::fabs(fault.direction[axis]) ? other : axis;
  }
  const auto size = static_cast<float>(fault.size);
  place[axis] = fault.direction[axis] < 0.0F ? bounds.min[axis] - size : bounds.max[axis] + size;
}

}  // namespace

struct Sabotage::State {
  std::vector<FaultSpec> clock, operators;
  // When the flight began: known from its first plan on, which may be made in a thread of its own.
  std::atomic<Time> origin{Time::min()};
  StopRequest stop{0};
};

class Sabotage::BadClock final : public Clock {
 public:
  BadClock(Clock& clock, State& state, const StopRequest* stop)
      : clock_(clock), state_(state), stop_(stop), slept_(state.clock.size()) {}

  Time now() const noexcept override { return clock_.now(); }
  bool is_virtual() const noexcept override { return clock_.is_virtual(); }
  void sleep_until(Time deadline) noexcept override {
    clock_.sleep_until(deadline);
    if (state_.origin.load() == Time::min()) {
      return;
    }
    for (std::size_t i = 0; i < state_.clock.size(); ++i) {
      const FaultSpec& fault = state_.clock[i];
      if (fault.kind == FaultKind::kTickGap && slept_[i] == 0 && fault.is_on(flown())) {
        slept_[i] = 1;
        clock_.sleep_until(clock_.now() + from_seconds(fault.size));
      }
    }
    ask_to_stop();
  }

 private:
  double flown() const noexcept { return to_seconds(clock_.now() - state_.origin.load()); }
  void ask_to_stop() noexcept {
    int level = stop_ == nullptr ? 0 : stop_->load(std::memory_order_relaxed);
    for (const FaultSpec& fault : state_.operators) {
      if (flown() >= fault.at) {
        level = std::max(level, fault.kind == FaultKind::kEmergencyStop ? 2 : 1);
      }
    }
    state_.stop.store(level, std::memory_order_relaxed);
  }

  Clock& clock_;
  State& state_;
  const StopRequest* stop_;
  std::vector<std::uint8_t> slept_;  // of each gap, whether it has been
};

class Sabotage::BadEngine final : public Engine {
 public:
  BadEngine(Engine& engine, Clock& clock, State& state) : engine_(engine), clock_(clock), state_(state) {}

  std::string_view name() const noexcept override { return engine_.name(); }
  Result<void> prepare(std::span<const SwarmModel> swarms, std::size_t agents) override {
    return engine_.prepare(swarms, agents);
  }
  TickCounts compute(const AgentColumns& at, const TickTime& tick,
                     const VelocityColumns& out) noexcept override {
    if (state_.origin.load() == Time::min()) {
      state_.origin = clock_.now() - from_seconds(tick.time_s);
    }
    const TickCounts counts = engine_.compute(at, tick, out);
    for (const FaultSpec& fault : state_.clock) {
      if (fault.kind == FaultKind::kTickLate && fault.is_on(tick.time_s)) {
        clock_.sleep_until(clock_.now() + from_seconds(fault.size));
      }
    }
    return counts;
  }
  void move_stimuli(std::size_t swarm, std::span<const glm::vec3> places) noexcept override {
    engine_.move_stimuli(swarm, places);
  }
  void replace_fields(std::size_t swarm, const SwarmFields& fields) noexcept override {
    engine_.replace_fields(swarm, fields);
  }
  std::string_view fault() const noexcept override { return engine_.fault(); }

 private:
  Engine& engine_;
  Clock& clock_;
  State& state_;
};

Sabotage::Sabotage(const Scenario& scenario, Engine& engine, Clock& clock, const StopRequest* stop)
    : scenario_(scenario), engine_(engine), clock_(clock), stop_(stop), state_(std::make_unique<State>()) {
  state_->clock = faults_at(scenario, FaultPlace::kClock);
  state_->operators = faults_at(scenario, FaultPlace::kOperator);
  if (!state_->clock.empty() || !state_->operators.empty()) {
    bad_clock_ = std::make_unique<BadClock>(clock, *state_, stop);
    bad_engine_ = std::make_unique<BadEngine>(engine, clock, *state_);
  }
}

Sabotage::~Sabotage() = default;

Engine& Sabotage::engine() const {
  return bad_engine_ ? *bad_engine_ : engine_;
}
std::unique_ptr<GuardPort> Sabotage::before(GuardPort& guard) const {
  return BadWishes::has_any(scenario_) ? std::make_unique<BadWishes>(scenario_, guard) : nullptr;
}
Clock& Sabotage::clock() const {
  return bad_clock_ ? *bad_clock_ : clock_;
}
const StopRequest* Sabotage::stop() const {
  return state_->operators.empty() ? stop_ : &state_->stop;
}

std::vector<glm::vec3> start_places(const Scenario& scenario, std::span<const glm::vec3> places) {
  std::vector<glm::vec3> moved(places.begin(), places.end());
  for (const FaultSpec& fault : scenario.faults) {
    if (fault.kind == FaultKind::kStartTooNear) {
      moved[agent(fault, 1)] = moved[agent(fault, 0)] + static_cast<float>(fault.size) * fault.direction;
    } else if (fault.kind == FaultKind::kStartOutside) {
      for (const StruckAgents& range : fault.agents) {
        for (std::size_t a = range.first; a < range.first + range.count; ++a) {
          move_out(moved[a], fault, scenario.world.bounds);
        }
      }
    }
  }
  return moved;
}

}  // namespace mayfly::simulate
