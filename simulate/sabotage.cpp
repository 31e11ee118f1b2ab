#include "simulate/sabotage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace mayfly::simulate {
namespace {

std::vector<FaultSpec> faults_at(const Scenario& scenario, std::initializer_list<FaultPlace> places) {
  std::vector<FaultSpec> faults;
  for (const FaultSpec& fault : scenario.faults) {
    const FaultPlace place = fault_row(fault.kind).place;
    if (std::find(places.begin(), places.end(), place) != places.end()) {
      faults.push_back(fault);
    }
  }
  return faults;
}

bool is_of_the_link(const FaultSpec& fault) {
  return fault.kind == FaultKind::kPlannerStall || fault.kind == FaultKind::kCommandReplay;
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

// A direction of all, new at every tick and for every agent (SplitMix64's mixing, Steele et al. 2014).
std::array<float, 3> any_direction(std::uint64_t seed, std::uint64_t tick, std::uint64_t who) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15U * (tick + 1) + 0xD1B54A32D192ED03U * (who + 1);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  const double up = 2.0 * static_cast<double>(z >> 32U) * 0x1p-32 - 1.0;
  const double angle = 2.0 * std::numbers::pi * static_cast<double>(z & 0xFFFFFFFFU) * 0x1p-32;
  const double level = std::sqrt(std::max(0.0, 1.0 - up * up));
  return {static_cast<float>(level * std::cos(angle)), static_cast<float>(level * std::sin(angle)),
          static_cast<float>(up)};
}

}  // namespace

struct Sabotage::State {
  std::vector<FaultSpec> planner, clock, operators;
  std::uint64_t seed = 0;
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
    for (const FaultSpec& fault : state_.planner) {
      if (fault.is_on(tick.time_s)) {
        spoil(fault, tick, out);
      }
    }
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
  void spoil(const FaultSpec& fault, const TickTime& tick, const VelocityColumns& out) const noexcept {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    if (fault.kind != FaultKind::kPlannerNan && fault.kind != FaultKind::kPlannerAbsurd) {
      return;
    }
    for (const StruckAgents& range : fault.agents) {
      for (std::size_t a = range.first; a < range.first + range.count; ++a) {
        const auto size = static_cast<float>(fault.size);
        const auto way = any_direction(state_.seed, tick.number, a);
        const bool nan = fault.kind == FaultKind::kPlannerNan;
        out.x[a] = nan ? kNan : size * way[0];
        out.y[a] = nan ? kNan : size * way[1];
        out.z[a] = nan ? kNan : size * way[2];
      }
    }
  }

  Engine& engine_;
  Clock& clock_;
  State& state_;
};

Sabotage::Sabotage(const Scenario& scenario, Engine& engine, Hal& hal, Clock& clock, const StopRequest* stop)
    : engine_(engine), hal_(hal), clock_(clock), stop_(stop), state_(std::make_unique<State>()) {
  state_->planner = faults_at(scenario, {FaultPlace::kPlanner});
  state_->clock = faults_at(scenario, {FaultPlace::kClock});
  state_->operators = faults_at(scenario, {FaultPlace::kOperator});
  state_->seed = scenario.seed;
  const bool clocked = !state_->clock.empty() || !state_->operators.empty();
  if (clocked) {
    bad_clock_ = std::make_unique<BadClock>(clock, *state_, stop);
  }
  if (clocked || !state_->planner.empty()) {
    bad_engine_ = std::make_unique<BadEngine>(engine, clock, *state_);
  }
  if (std::any_of(state_->planner.begin(), state_->planner.end(), is_of_the_link)) {
    bad_link_ = std::make_unique<BadLink>(hal, state_->planner);
  }
}

Sabotage::~Sabotage() = default;

Engine& Sabotage::engine() const {
  return bad_engine_ ? *bad_engine_ : engine_;
}
Hal& Sabotage::hal() const {
  return bad_link_ ? *bad_link_ : hal_;
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
    }
  }
  return moved;
}

}  // namespace mayfly::simulate
