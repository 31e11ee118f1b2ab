// What tells of breaches has to see them: each fires just beyond its limit, and not just within.
#include "bench/faults/breach_watch.hpp"

#include <gtest/gtest.h>

namespace mayfly::bench {
namespace {

PromisedLimits limits() {
  return {0.1F, 2.0F, 4.0F, {glm::vec3(0.0F), glm::vec3(10.0F)}};
}

// Two robots, the second this far along x from the first.
std::uint64_t seen(Breach breach, float apart, float z = 5.0F) {
  BreachWatch watch(2, limits());
  const std::array<float, 2> x{2.0F, 2.0F + apart};
  const std::array<float, 2> y{5.0F, 5.0F};
  const std::array<float, 2> height{z, z};
  sim_hal::PoseView view;
  view.columns = {x, y, height, y, y, y};
  watch.on_step(view);
  return watch.breaches()[static_cast<std::size_t>(breach)];
}

TEST(BreachWatch, SeesBodiesTouch) {
  EXPECT_EQ(seen(Breach::kSeparation, 0.1999F), 1U);
  EXPECT_EQ(seen(Breach::kSeparation, 0.2001F), 0U);
}

TEST(BreachWatch, SeesBodiesOutside) {
  EXPECT_EQ(seen(Breach::kFence, 1.0F, 0.0999F), 2U);
  EXPECT_EQ(seen(Breach::kFence, 1.0F, 0.1001F), 0U);
  EXPECT_EQ(seen(Breach::kFence, 7.9001F), 1U);
  EXPECT_EQ(seen(Breach::kFence, 1.0F, std::numeric_limits<float>::quiet_NaN()), 2U);
}

class Commands {
 public:
  void tell(float vx, CommandKind kind = CommandKind::kVelocity) {
    const std::array<CommandKind, 1> kinds{kind};
    const std::array<float, 1> x{vx};
    const std::array<float, 1> zero{0.0F};
    watch.on_command(now, {kinds, x, zero, zero, now, 1});
    now += std::chrono::milliseconds(20);
  }
  std::uint64_t seen(Breach breach) const { return watch.breaches()[static_cast<std::size_t>(breach)]; }

  BreachWatch watch{1, limits()};
  Time now = std::chrono::seconds(3);
};

TEST(BreachWatch, SeesCommandsThatAreTooFast) {
  Commands commands;
  commands.tell(2.0F);
  EXPECT_EQ(commands.seen(Breach::kSpeed), 0U);
  commands.tell(2.001F);
  EXPECT_EQ(commands.seen(Breach::kSpeed), 1U);
  commands.tell(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(commands.seen(Breach::kSpeed), 2U);
}

TEST(BreachWatch, SeesCommandsThatAreTooSudden) {
  Commands commands;
  commands.tell(0.0F);
  commands.tell(0.0799F);
  EXPECT_EQ(commands.seen(Breach::kAcceleration), 0U);
  commands.tell(0.1701F);
  EXPECT_EQ(commands.seen(Breach::kAcceleration), 1U);
}

TEST(BreachWatch, KnowsWhenARobotWasToldToStop) {
  Commands commands;
  for (int i = 0; i < 100; ++i) {
    commands.tell(i < 50 || i == 60 ? 1.0F : 0.0F);
  }
  // From 0.5 s on: moving until 1 s and once at 1.2 s.
  const auto after = commands.watch.stopped_after(0, std::chrono::milliseconds(500));
  ASSERT_TRUE(after);
  EXPECT_NEAR(*after, 0.72, 1e-9);
  commands.tell(1.0F);
  EXPECT_FALSE(commands.watch.stopped_after(0, std::chrono::milliseconds(1800)));
}

}  // namespace
}  // namespace mayfly::bench
