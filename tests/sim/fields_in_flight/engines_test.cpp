// Both engines through a whole flight in which goals and obstacles move and crowds count: the same bits.
#include <array>
#include <vector>

#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/prepare.hpp"
#include "simulate/robots.hpp"
#include "tests/sim/fields_in_flight/worlds.hpp"

namespace mayfly::test {
namespace {

class Paths final : public Observer {
 public:
  void on_tick(const TickView& view) noexcept override {
    for (const auto& column : {view.x, view.y, view.z}) {
      at.insert(at.end(), column.begin(), column.end());
    }
  }
  std::vector<float> at;
};

struct Flown {
  std::vector<float> paths;
  Summary summary;
};

Flown flown_by(Engine& engine, const Scenario& scenario) {
  const auto ready = prepare(scenario, {.threads = 1});
  if (!ready) {
    ADD_FAILURE() << to_string(ready.error().front());
    return {};
  }
  EXPECT_TRUE(engine.prepare((*ready)->models.swarms, (*ready)->models.agents()));
  VirtualClock clock;
  const simulate::Robots robots = simulate::make_robots(scenario, (*ready)->places, clock);
  Paths paths;
  const std::array<Observer*, 1> observers{&paths};
  auto summary = fly({.scenario = scenario,
                      .world = (*ready)->world,
                      .engine = engine,
                      .hal = *robots.hal,
                      .truth = robots.truth.get(),
                      .clock = clock,
                      .observers = observers});
  EXPECT_TRUE(summary);
  return {std::move(paths.at), summary ? std::move(*summary) : Summary{}};
}

TEST(Engines, FlyTheSameBitsWhereFieldsAreReplaced) {
  Scenario scenario = chase(60, 4);
  scenario.world.obstacles[0].path = PathSpec{{{15, 10, 6}, {9, 10, 6}}, 1.0F, true, {}};
  scenario.swarms[0].cost.density_weight = 0.5F;
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  const Flown native = flown_by(*make_native_engine(2), scenario);
  const Flown device = flown_by(**opencl, scenario);
  ASSERT_FALSE(native.paths.empty());
  EXPECT_TRUE(native.paths == device.paths);
  ASSERT_TRUE(native.summary.fields && device.summary.fields);
  EXPECT_EQ(device.summary.fields->updates, 19U);
  EXPECT_TRUE(device.summary.faults.empty());

  // The fields that were swapped in, not the first ones.
  scenario.field_rate = 1.0F;
  EXPECT_FALSE(flown_by(**opencl, scenario).paths == device.paths);
}

}  // namespace
}  // namespace mayfly::test
