// Cost that knows of crowds spreads a swarm around a sharp obstacle (Wang14 Fig. 15).
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <tuple>

#include "tests/sim/fields_in_flight/worlds.hpp"

namespace mayfly::test {
namespace {

// The most agents that were ever in one cube of 2 m, of those that pass the obstacle's edge.
class Crowd final : public Observer {
 public:
  void on_tick(const TickView& view) noexcept override {
    if (view.tick % 10 != 0) {
      return;
    }
    std::map<std::tuple<int, int, int>, int> cubes;
    for (std::size_t a = 0; a < view.x.size(); ++a) {
      if (view.x[a] > 10.0F && view.x[a] < 16.0F) {
        const auto cube = [](float v) { return static_cast<int>(v / 2.0F); };
        peak = std::max(peak, ++cubes[{cube(view.x[a]), cube(view.y[a]), cube(view.z[a])}]);
      }
    }
  }
  int peak = 0;
};

int peak_of(float weight) {
  // A wall from floor to ceiling: the only ways are around its one sharp end.
  Scenario scenario = hall_with(
      "{box: {min: [13, -1, -1], max: [14, 11, 13]}}", "exit: {box: {min: [22, 2, 2], max: [28, 10, 10]}}",
      "count: 400, start: {box: {min: [1, 1, 2], max: [8, 12, 10]}}, goal: exit", 25);
  scenario.swarms[0].cost.density_weight = weight;
  Crowd crowd;
  const std::array<Observer*, 1> observers{&crowd};
  const Summary summary = flown(scenario, {.threads = 1, .observers = observers});
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_EQ(summary.fields.has_value(), weight > 0.0F);
  return crowd.peak;
}

TEST(Density, SpreadsASwarmAroundASharpObstacle) {
  const int without = peak_of(0.0F);
  const int with = peak_of(1.0F);
  std::printf("density: at most %d agents in 8 m³ without it, %d with it\n", without, with);
  EXPECT_LT(with, 0.8 * without);
}

}  // namespace
}  // namespace mayfly::test
