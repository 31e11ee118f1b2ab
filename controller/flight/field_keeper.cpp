#include "controller/flight/field_keeper.hpp"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

#include "controller/flight/field_margin.hpp"
#include "controller/flight/swarm_cost.hpp"

namespace mayfly {
namespace {

// Below what a clock's rounding can shift a tick by, s.
constexpr double kHair = 1e-9;
// How often the solver looks whether a set was asked for, on the real clock: short beside a planner's period.
constexpr auto kSolverNap = std::chrono::milliseconds(2);

void copy_known(std::span<const float> from, std::vector<float>& to) noexcept {
  std::copy_n(from.begin(), std::min(from.size(), to.size()), to.begin());
}

std::optional<Spread> told(const LatencyHistogram& histogram) {
  if (histogram.count() == 0) {
    return std::nullopt;
  }
  return Spread{to_seconds(histogram.percentile(0.5)), to_seconds(histogram.percentile(0.99)),
                to_seconds(histogram.max())};
}

}  // namespace

Result<std::unique_ptr<FieldKeeper>> FieldKeeper::start(const Scenario& scenario, FieldSolver& solver,
                                                        Settings settings) try {
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the constructor is private
  std::unique_ptr<FieldKeeper> keeper(new FieldKeeper(scenario, solver, settings));
  keeper->thread_ = std::thread([raw = keeper.get()] { raw->work(); });
  return keeper;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for a second set of fields");
} catch (const std::system_error& error) {
  return fail(Cause::kEnvironment, std::string("no thread for solving fields: ") + error.what());
}

FieldKeeper::FieldKeeper(const Scenario& scenario, FieldSolver& solver, Settings settings)
    : scenario_(scenario),
      solver_(solver),
      settings_(settings),
      period_s_(field_period(scenario)),
      step_s_(period_s_),
      sets_{solver.make_set(), solver.make_set()} {
  std::size_t agents = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    agents += static_cast<std::size_t>(swarm.count);
    goal_of_.push_back(swarm.is_guided() ? goal_index(scenario, swarm) : scenario.world.goals.size());
    unreachable_text_.push_back("goal '" + swarm.goal + "' cannot be reached by all of swarm '" + swarm.name +
                                "': those that it is cut off from hold until it can");
  }
  for (std::vector<float>* column : {&inputs_.x, &inputs_.y, &inputs_.z}) {
    column->resize(agents);
  }
}

FieldKeeper::~FieldKeeper() {
  turn_.store(Turn::kEnd, std::memory_order_release);
  turn_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void FieldKeeper::work() noexcept {
  for (Turn turn = turn_.load(std::memory_order_acquire); turn != Turn::kEnd;
       turn = turn_.load(std::memory_order_acquire)) {
    if (turn != Turn::kSolver) {
      await_other(turn);
      continue;
    }
    const bool solved = solver_.solve(inputs_, settings_.threads, sets_[1 - flown_]).has_value();
    solved_.store(solved, std::memory_order_relaxed);
    // Unless the flight has ended meanwhile.
    turn_.compare_exchange_strong(turn, Turn::kReady, std::memory_order_acq_rel);
    turn_.notify_all();
  }
}

// On the real clock nobody wakes the solver, because waking is a system call, and control makes none.
void FieldKeeper::await_other(Turn turn) noexcept {
  if (settings_.waits) {
    turn_.wait(turn, std::memory_order_acquire);
  } else {
    std::this_thread::sleep_for(kSolverNap);
  }
}

void FieldKeeper::tick(double time_s, const PositionColumns& at, const Motion& motion,
                       Engine& engine) noexcept {
  if (time_s >= next_s_ - kHair) {
    while (settings_.waits && turn_.load(std::memory_order_acquire) == Turn::kSolver) {
      turn_.wait(Turn::kSolver, std::memory_order_acquire);
    }
    if (turn_.load(std::memory_order_acquire) != Turn::kSolver) {
      take_over(engine);
      ask(time_s, at);
    }
  }
  for (std::size_t s = 0; s < goal_of_.size(); ++s) {
    const std::size_t goal = goal_of_[s];
    if (goal < scenario_.world.goals.size() && scenario_.world.goals[goal].path) {
      const glm::vec3 velocity = scenario_.world.goals[goal].path->velocity(time_s);
      engine.replace_fields(s, {{}, {}, motion.goal(goal), velocity});
    }
  }
  ages_.record(from_seconds(time_s - flown_time_s_));
}

void FieldKeeper::take_over(Engine& engine) noexcept {
  if (turn_.load(std::memory_order_acquire) != Turn::kReady) {
    return;  // the first tick: nothing was asked for yet
  }
  turn_.store(Turn::kControl, std::memory_order_relaxed);
  failed_ = !solved_.load(std::memory_order_relaxed);
  if (failed_) {
    return;
  }
  flown_ = 1 - flown_;
  const FieldSet& set = sets_[flown_];
  flown_time_s_ = set.time_s;
  for (std::size_t s = 0; s < goal_of_.size(); ++s) {
    // Whoever is not led minds walls all the same.
    const std::size_t cost = solver_.cost_of(s);
    const bool is_led = cost != FieldSolver::kNone;
    if (is_led || solver_.walls_change()) {
      const std::span<const float> guide = is_led ? set.costs[cost].guide : std::span<const float>();
      engine.replace_fields(s, {set.walls, guide, glm::vec3(0.0F), glm::vec3(0.0F)});
    }
  }
  ++updates_;
  solves_.record(from_seconds(set.solve_s));
}

void FieldKeeper::ask(double time_s, const PositionColumns& at) noexcept {
  if (is_asked_) {
    step_s_ = std::max(period_s_, time_s - asked_s_);
  }
  is_asked_ = true;
  asked_s_ = time_s;
  next_s_ = std::max(next_s_ + period_s_, time_s);
  inputs_.time_s = time_s;
  inputs_.from_s = time_s + step_s_;
  inputs_.until_s = inputs_.from_s + step_s_ + (set_duration(scenario_) - period_s_);
  copy_known(at.x, inputs_.x);
  copy_known(at.y, inputs_.y);
  copy_known(at.z, inputs_.z);
  turn_.store(Turn::kSolver, std::memory_order_release);
  if (settings_.waits) {
    turn_.notify_all();
  }
}

HalResult FieldKeeper::state_of(std::size_t swarm) const noexcept {
  if (updates_ == 0 || sets_[flown_].cut_off[swarm] == 0) {
    return {};
  }
  return {HalFault::kLinkDown, kEveryRobot, "fields", unreachable_text_[swarm]};
}

HalResult FieldKeeper::solver_state() const noexcept {
  if (!failed_) {
    return {};
  }
  return {HalFault::kLinkDown, kEveryRobot, "fields",
          "the fields could not be solved again: no memory or no thread"};
}

FieldsSummary FieldKeeper::summary() const {
  return {updates_, told(ages_), told(solves_), unreachable_};
}

}  // namespace mayfly
