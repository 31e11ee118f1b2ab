// Whole flights under the traps: no tick allocates, locks, or calls the system.
#include <gtest/gtest.h>
#include <sys/syscall.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/prepare.hpp"
#include "controller/scenario/load.hpp"
#include "record/csv_recorder.hpp"
#include "sim_hal/sim_hal.hpp"
#include "simulate/robots.hpp"
#include "tests/reference/tick_traps.hpp"

namespace mayfly::test {
namespace {

// Two swarms in a hall with a wall; `rest` are further keys of the first, `more` of the scenario.
Scenario hall(const std::string& rest, const std::string& more, double duration) {
  const std::string text =
      "mayfly: 1\nduration: " + std::to_string(duration) +
      "\nworld:\n  bounds: {min: [0, 0, 0], max: [30, 20, 12]}\n  cell: 1.0\n"
      "  obstacles: [{box: {min: [14, 0, 0], max: [16, 12, 12]}}]\n"
      "  goals: {exit: {sphere: {center: [25, 10, 6], radius: 4}" +
      std::string(more.find("loop") == std::string::npos ? "" : ", " + more) +
      "}}\nswarms:\n"
      "  - {name: flies, count: 60, start: {box: {min: [2, 2, 2], max: [8, 18, 10]}}, goal: exit, " +
      rest +
      "}\n"
      "hal: {sim: {kind: sim, plant: velocity_lag, pose_noise: 0.01, dropout: 0.05, nan: 0.01}}\n";
  auto scenario = load_scenario_text(text, "hall.yaml");
  if (!scenario) {
    ADD_FAILURE() << to_string(scenario.error().front());
    return {};
  }
  return std::move(*scenario);
}

// Traps the control thread from its second tick on.
class Trapper final : public Observer {
 public:
  void on_tick(const TickView&) noexcept override {
    trapped = trapped || trap_system_calls();
    ++ticks;
  }
  bool trapped = false;
  int ticks = 0;
};

sim_hal::SimHalConfig robots_of(const Scenario& scenario, const Prepared& ready, Clock& clock) {
  sim_hal::SimHalConfig config;
  config.positions = ready.places;
  for (std::size_t robot = 0; robot < ready.places.size(); ++robot) {
    config.robot_names.push_back("r" + std::to_string(robot));
  }
  const SimHalSpec& spec = scenario.hals.front().sim;
  config.plant = sim_hal::Plant::kVelocityLag;
  config.faults = {spec.pose_noise, spec.delay, spec.dropout, spec.freeze, spec.freeze_time, spec.nan};
  config.backend = sim_hal::Backend::kNative;
  config.lock_step = clock.is_virtual();
  config.clock = &clock;
  return config;
}

// In a thread of its own, because a trap is for life.
void expect_clean(const Scenario& scenario, Clock& clock) {
  const auto ready = prepare(scenario, {.threads = 1, .in_real_time = !clock.is_virtual()});
  ASSERT_TRUE(ready) << to_string(ready.error().front());
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare((*ready)->models.swarms, (*ready)->models.agents()));
  sim_hal::SimHal hal(robots_of(scenario, **ready, clock));
  const auto file = std::filesystem::temp_directory_path() / "mayfly_armed_tick.csv";
  auto recorder = record::CsvRecorder::open(
      file, {60, 20.0, 100.0, true});  // with a thread that writes, as on the real clock
  ASSERT_TRUE(recorder);
  Trapper trapper;
  const std::array<Observer*, 2> watching{recorder->get(), &trapper};
  const TickOffences before = tick_offences();
  Result<Summary> flown;
  std::thread([&] {
    flown = fly({.scenario = scenario,
                 .world = (*ready)->world,
                 .engine = *engine,
                 .hal = hal,
                 .clock = clock,
                 .observers = watching});
  }).join();
  recorder->reset();
  std::filesystem::remove(file);
  ASSERT_TRUE(flown) << to_string(flown.error());
  const TickOffences after = tick_offences();
  EXPECT_EQ(after.allocations - before.allocations, 0U);
  EXPECT_EQ(after.locks - before.locks, 0U);
  EXPECT_EQ(after.system_calls - before.system_calls, 0U) << "the last was number " << after.last_system_call;
  EXPECT_TRUE(trapper.trapped || !kTrapsSystemCalls);
  EXPECT_GT(trapper.ticks, 5);
  EXPECT_EQ(flown->ticks, static_cast<std::uint64_t>(trapper.ticks));
}

// Allocates in one tick: an observer with a bug.
class Careless final : public Observer {
 public:
  void on_tick(const TickView& tick) noexcept override {
    if (tick.tick == 40) {
      kept = std::make_unique<int>(1);
    }
  }
  std::unique_ptr<int> kept;
};

std::uint64_t breaches_of(const Summary& summary, const std::string& invariant) {
  for (const auto& [name, count] : summary.safety.invariants) {
    if (name == invariant) {
      return count;
    }
  }
  ADD_FAILURE() << "there is no " << invariant;
  return 0;
}

TEST(ArmedTick, AnAllocationIsABreachThatHoldsEverybody) {
  for (const bool careless : {false, true}) {
    VirtualClock clock;
    const Scenario scenario = hall("model: field", "", 2.0);
    const auto ready = prepare(scenario, {.threads = 1});
    ASSERT_TRUE(ready) << to_string(ready.error().front());
    const auto engine = make_native_engine(1);
    ASSERT_TRUE(engine->prepare((*ready)->models.swarms, (*ready)->models.agents()));
    sim_hal::SimHal hal(robots_of(scenario, **ready, clock));
    Careless observer;
    const std::array<Observer*, 1> watching{&observer};
    std::vector<std::uint64_t> tape_ticks;
    const auto flown =
        fly({.scenario = scenario,
             .world = (*ready)->world,
             .engine = *engine,
             .hal = hal,
             .clock = clock,
             .observers = careless ? std::span<Observer* const>(watching) : std::span<Observer* const>(),
             .keep_tape = [&](const BlackBoxTape& tape) {
               tape_ticks.push_back(tape.frame(tape.size() - 1).sequence);
             }});
    ASSERT_TRUE(flown) << to_string(flown.error());
    EXPECT_EQ(breaches_of(*flown, "no_allocation"), careless ? 1U : 0U);
    EXPECT_EQ(flown->safety.severity_max == "hold_all", careless);
    // Observers see a tick after it was written: the guard sees what they did in its next.
    EXPECT_EQ(tape_ticks, careless ? std::vector<std::uint64_t>{42} : std::vector<std::uint64_t>{});
  }
}

TEST(ArmedTick, InLockStepIsClean) {
  VirtualClock clock;
  expect_clean(hall("model: field", "", 5.0), clock);
}

TEST(ArmedTick, InRealTimeBesideThePlantsThreadIsClean) {
  RealtimeClock clock;
  expect_clean(hall("model: field", "", 0.5), clock);
}

TEST(ArmedTick, WhereFieldsAreSolvedInFlightIsClean) {
  RealtimeClock clock;
  expect_clean(hall("model: field", "path: {points: [[25, 10, 6], [24, 9, 6]], speed: 0.5, loop: true}", 0.6),
               clock);
}

TEST(ArmedTick, BesideAPlannerIsClean) {
  RealtimeClock clock;
  Scenario scenario =
      hall("model: field", "path: {points: [[25, 10, 6], [24, 9, 6]], speed: 0.5, loop: true}", 0.6);
  scenario.planners = {{"curl_noise", 50.0F, {}, {}}};
  expect_clean(scenario, clock);
}

TEST(ArmedTick, OfEveryModelIsClean) {
  for (const std::string model :
       {"model: orca", "model: boids", "model: brownian", "model: forces", "model: field, governor: off"}) {
    SCOPED_TRACE(model);
    VirtualClock clock;
    expect_clean(hall(model, "", 2.0), clock);
  }
}

}  // namespace
}  // namespace mayfly::test
