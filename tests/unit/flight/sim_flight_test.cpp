// The loop of a flight on the simulated HAL, with the faults it can have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim_hal/sim_hal.hpp"
#include "tests/unit/flight/sortie.hpp"

namespace mayfly::test {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class Truth final : public GroundTruth {
 public:
  explicit Truth(sim_hal::SimHal& hal) : hal_(hal) {}
  void truth(const StateColumns& to) const noexcept override {
    const sim_hal::PoseView from = hal_.truth();
    const std::array<std::span<float>, 6> columns{to.x, to.y, to.z, to.vx, to.vy, to.vz};
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::copy(from.columns[c].begin(), from.columns[c].end(), columns[c].begin());
    }
    std::fill(to.stamp.begin(), to.stamp.end(), from.stamp);
    std::fill(to.valid.begin(), to.valid.end(), std::uint8_t{1});
  }

 private:
  sim_hal::SimHal& hal_;
};

// Paths, bit for bit, and how many samples were said to be old.
class Watcher final : public Observer {
 public:
  void on_tick(const TickView& view) noexcept override {
    path.insert(path.end(), view.y.begin(), view.y.end());
    stale += static_cast<std::size_t>(std::count(view.valid.begin(), view.valid.end(), std::uint8_t{0}));
    holds += static_cast<std::size_t>(std::count(view.kind.begin(), view.kind.end(), CommandKind::kHold));
    samples += view.valid.size();
  }
  std::vector<float> path;
  std::size_t stale = 0, holds = 0, samples = 0;
};

struct SimSortie : Sortie {
  explicit SimSortie(const Scenario& flown, const sim_hal::Faults& faults = {})
      : Sortie(flown), robots(config_of(scenario, world, faults)), known(robots) {}

  static sim_hal::SimHalConfig config_of(const Scenario& scenario, const World& world,
                                         const sim_hal::Faults& faults) {
    sim_hal::SimHalConfig config;
    config.positions = start_places(scenario, world);
    for (std::size_t robot = 0; robot < config.positions.size(); ++robot) {
      config.robot_names.push_back("flies_" + std::to_string(robot));
    }
    config.plant = scenario.hals[0].sim.plant == PlantKind::kVelocityLag ? sim_hal::Plant::kVelocityLag
                                                                         : sim_hal::Plant::kIdeal;
    config.backend = sim_hal::Backend::kNative;
    config.faults = faults;
    config.seed = scenario.seed;
    return config;
  }

  Result<Summary> fly() {
    const std::array<Observer*, 1> watching{&watcher};
    return mayfly::fly({.scenario = scenario,
                        .world = world,
                        .engine = *engine,
                        .hal = robots,
                        .truth = &known,
                        .clock = clock,
                        .observers = watching,
                        .stop = &stop});
  }

  sim_hal::SimHal robots;
  Truth known;
  Watcher watcher;
};

Scenario across(PlantKind plant) {
  Scenario scenario = walled_hall(12);
  scenario.duration = 30;
  scenario.hals[0].sim.plant = plant;
  return scenario;
}

TEST(SimFlight, ReachesTheGoalWithEitherPlant) {
  for (const PlantKind plant : {PlantKind::kIdeal, PlantKind::kVelocityLag}) {
    SimSortie sortie(across(plant));
    const auto summary = sortie.fly();
    ASSERT_TRUE(summary) << to_string(summary.error());
    EXPECT_EQ(summary->reached_fraction, 1.0);
    EXPECT_EQ(summary->penetrations, 0U);
    EXPECT_EQ(summary->collisions, 0U);
    EXPECT_GE(summary->min_separation_m.value_or(0), 0.2);
    EXPECT_THAT(summary->faults, IsEmpty());
    EXPECT_EQ(sortie.watcher.stale, 0U);
  }
}

TEST(SimFlight, GivesTheSameBitsTwice) {
  sim_hal::Faults faults;
  faults.pose_noise = 0.01F;
  faults.dropout = 0.05F;
  faults.nan = 0.01F;
  SimSortie once(across(PlantKind::kVelocityLag), faults);
  SimSortie again(across(PlantKind::kVelocityLag), faults);
  ASSERT_TRUE(once.fly());
  ASSERT_TRUE(again.fly());
  EXPECT_EQ(once.watcher.path, again.watcher.path);
}

TEST(SimFlight, GoesOnThroughSamplesThatAreLost) {
  sim_hal::Faults faults;
  faults.dropout = 0.3F;
  SimSortie sortie(across(PlantKind::kVelocityLag), faults);
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->reached_fraction, 1.0);
  EXPECT_EQ(summary->penetrations, 0U);
  const double lost = static_cast<double>(sortie.watcher.stale) / static_cast<double>(sortie.watcher.samples);
  EXPECT_NEAR(lost, 0.3, 0.02) << "watchers are told which samples are old";
}

TEST(SimFlight, NamesARobotWhoseStateIsNotANumber) {
  sim_hal::Faults faults;
  faults.nan = 0.001F;
  SimSortie sortie(across(PlantKind::kVelocityLag), faults);
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  ASSERT_THAT(summary->faults, Not(IsEmpty()));
  for (const FaultEvent& fault : summary->faults) {
    EXPECT_THAT(fault.robot, StartsWith("flies_"));
    EXPECT_EQ(fault.link, "sim");
  }
  EXPECT_EQ(summary->reached_fraction, 1.0);
  EXPECT_EQ(summary->penetrations, 0U);
}

TEST(SimFlight, HoldsEverybodyWhereNobodyIsEverHeard) {
  sim_hal::Faults faults;
  faults.dropout = 1.0F;
  Scenario scenario = hall(5);
  scenario.duration = 2;
  SimSortie sortie(scenario, faults);
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_EQ(sortie.watcher.holds, sortie.watcher.samples);
  EXPECT_EQ(summary->max_speed_mps, 0.0);
}

TEST(SimFlight, StopsALaggingSwarmBeforeItEnds) {
  Scenario scenario = across(PlantKind::kVelocityLag);
  SimSortie sortie(scenario);
  class Request final : public Observer {
   public:
    explicit Request(StopRequest& stop) : stop_(stop) {}
    void on_tick(const TickView& view) noexcept override {
      stop_ = view.tick >= 100 ? 1 : 0;
      fastest = 0;
      for (std::size_t a = 0; a < view.vx.size(); ++a) {
        fastest = std::max(fastest, std::hypot(view.vx[a], view.vy[a], view.vz[a]));
      }
    }
    float fastest = 0;

   private:
    StopRequest& stop_;
  } request(sortie.stop);
  const std::array<Observer*, 1> watching{&request};
  const auto summary = mayfly::fly({.scenario = sortie.scenario,
                                    .world = sortie.world,
                                    .engine = *sortie.engine,
                                    .hal = sortie.robots,
                                    .truth = &sortie.known,
                                    .clock = sortie.clock,
                                    .observers = watching,
                                    .stop = &sortie.stop});
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->stopped_by_user);
  EXPECT_LT(request.fastest, 0.05F);
  // 1.5 m/s fall below 0.05 m/s in ln 30 time constants of 0.1 s.
  EXPECT_GT(summary->ticks, 110U);
  EXPECT_LT(summary->ticks, 160U);
}

}  // namespace
}  // namespace mayfly::test
