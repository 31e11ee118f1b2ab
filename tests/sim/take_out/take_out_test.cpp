// Robots that are taken out of a whole flight, and put back: nobody jumps, nobody comes too near, and the
// others arrive.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/prepare.hpp"
#include "controller/scenario/load.hpp"
#include "simulate/robots.hpp"

namespace mayfly::test {
namespace {

constexpr float kRadius = 0.1F;
constexpr float kSpeed = 2.0F;
constexpr float kTick = 0.01F;
constexpr std::size_t kPutBack = 2;    // out_2
constexpr std::size_t kStaysOut = 10;  // back_4

// The robots as they really are, those that are out included.
class Reality final : public sim_hal::StepWatcher {
 public:
  void on_step(const sim_hal::PoseView& truth) noexcept override {
    places.resize(truth.columns[0].size());
    for (std::size_t a = 0; a < places.size(); ++a) {
      places[a] = {truth.columns[0][a], truth.columns[1][a], truth.columns[2][a]};
      for (std::size_t b = 0; b < a; ++b) {
        nearest = std::min(nearest, glm::distance(places[a], places[b]));
      }
    }
  }
  void on_command(Time, const CommandColumns&) noexcept override {}

  std::vector<glm::vec3> places;
  float nearest = 1e9F;
};

// What the swarm sees: twins in the places of those that are out.
class Seen final : public Observer {
 public:
  explicit Seen(const Reality& reality) : reality_(reality) {}

  void on_tick(const TickView& tick) noexcept override {
    if (reality_.places.empty()) {
      return;  // no plant has taken a step yet
    }
    std::vector<glm::vec3> now(tick.x.size());
    for (std::size_t a = 0; a < now.size(); ++a) {
      now[a] = {tick.x[a], tick.y[a], tick.z[a]};
      if (!before_.empty()) {
        farthest_step = std::max(farthest_step, glm::distance(now[a], before_[a]));
      }
      for (std::size_t b = 0; b < a; ++b) {
        nearest = std::min(nearest, glm::distance(now[a], now[b]));
      }
      for (std::size_t b = 0; b < now.size(); ++b) {
        // Twins and robots, but not a twin and its own.
        nearest_mixed =
            a == b ? nearest_mixed : std::min(nearest_mixed, glm::distance(now[a], reality_.places[b]));
      }
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t robot = k == 0 ? kPutBack : kStaysOut;
      const float apart = glm::distance(now[robot], reality_.places[robot]);
      farthest_twin[k] = std::max(farthest_twin[k], apart);
      last_apart[k] = apart;
    }
    before_ = now;
  }

  float farthest_step = 0.0F;
  float nearest = 1e9F, nearest_mixed = 1e9F;
  std::array<float, 2> farthest_twin{}, last_apart{};

 private:
  const Reality& reality_;
  std::vector<glm::vec3> before_;
};

struct Flown {
  Result<Summary> summary;
  Reality reality;
  Seen seen{reality};
};

void fly_out(const Scenario& scenario, Flown& flown) {
  const auto ready = prepare(scenario, {.threads = 1});
  ASSERT_TRUE(ready) << to_string(ready.error().front());
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare((*ready)->models.swarms, (*ready)->models.agents()));
  VirtualClock clock;
  const simulate::Robots robots =
      simulate::make_robots(scenario, (*ready)->places, clock, sim_hal::Backend::kNative, &flown.reality);
  const std::array<Observer*, 1> watching{&flown.seen};
  flown.summary = mayfly::fly({.scenario = scenario,
                               .world = (*ready)->world,
                               .engine = *engine,
                               .hal = *robots.hal,
                               .truth = robots.truth.get(),
                               .clock = clock,
                               .observers = watching,
                               .exchange = robots.exchange.get()});
  ASSERT_TRUE(flown.summary) << to_string(flown.summary.error());
}

Scenario take_out() {
  auto scenario = load_scenario(MAYFLY_SOURCE_DIR "/config/scenarios/faults/take_out.yaml");
  EXPECT_TRUE(scenario);
  return scenario ? *scenario : Scenario{};
}

TEST(TakeOut, NobodyJumpsNobodyIsTooNearAndAllArrive) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Scenario scenario = take_out();
    scenario.seed = seed;
    Flown flown;
    ASSERT_NO_FATAL_FAILURE(fly_out(scenario, flown));
    // The twin and the robot that is put back meet within 5 cm (TwinConfig::most_distance).
    EXPECT_LE(flown.seen.farthest_step, kSpeed * kTick + 0.05F);
    EXPECT_GE(flown.reality.nearest, 2 * kRadius);
    EXPECT_GE(flown.seen.nearest, 2 * kRadius);
    EXPECT_GE(flown.seen.nearest_mixed, 2 * kRadius);
    EXPECT_GT(flown.seen.farthest_twin[0], 1.0F) << "the twin has flown on";
    EXPECT_LT(flown.seen.last_apart[0], 1e-3F) << "the robot was put back";
    EXPECT_GT(flown.seen.last_apart[1], 1.0F) << "this one is still out";
    for (const ExpectationResult& line : flown.summary->expect) {
      EXPECT_TRUE(line.pass) << line.name << ": " << line.value.value_or(-1.0);
    }
    for (const auto& [name, breaches] : flown.summary->safety.invariants) {
      EXPECT_EQ(breaches, 0U) << name;
    }
  }
}

// One step below: nobody is asked, and nobody is taken out.
TEST(TakeOut, WhoIsNotAskedStaysIn) {
  Scenario scenario = take_out();
  for (TwinSpec& twin : scenario.twins) {
    twin.from = scenario.duration;
  }
  Flown flown;
  ASSERT_NO_FATAL_FAILURE(fly_out(scenario, flown));
  EXPECT_LT(flown.seen.farthest_twin[0], 1e-3F);
  EXPECT_LT(flown.seen.farthest_twin[1], 1e-3F);
}

TEST(TakeOut, TheSameSeedGivesTheSameBits) {
  std::array<glm::vec3, 2> places;
  for (glm::vec3& place : places) {
    Flown flown;
    ASSERT_NO_FATAL_FAILURE(fly_out(take_out(), flown));
    place = flown.reality.places[kPutBack];
  }
  EXPECT_EQ(places[0], places[1]);
}

}  // namespace
}  // namespace mayfly::test
