// What is solved beside the loop must not make a flight depend on threads.
#include <array>
#include <vector>

#include "tests/sim/fields_in_flight/worlds.hpp"

namespace mayfly::test {
namespace {

class Paths final : public Observer {
 public:
  void on_tick(const TickView& view) noexcept override {
    at.insert(at.end(), view.x.begin(), view.x.end());
    at.insert(at.end(), view.z.begin(), view.z.end());
  }
  std::vector<float> at;
};

TEST(SameBits, OnOneThreadOnTwoAndOnceMore) {
  Scenario scenario = door(30, 12, true);
  scenario.swarms[0].cost.density_weight = 0.5F;
  std::vector<float> first;
  for (const int threads : {1, 2, 1}) {
    Paths paths;
    const std::array<Observer*, 1> observers{&paths};
    flown(scenario, {.threads = threads, .observers = observers});
    if (first.empty()) {
      first = paths.at;
      ASSERT_FALSE(first.empty());
    }
    EXPECT_TRUE(paths.at == first) << threads << " threads";
  }
}

}  // namespace
}  // namespace mayfly::test
