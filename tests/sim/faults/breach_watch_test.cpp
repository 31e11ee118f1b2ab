// What tells of breaches has to see them: each fires just beyond its limit, and not just within.
#include "simulate/breach_watch.hpp"

#include <gtest/gtest.h>

#include "bench/faults/command_watch.hpp"

namespace mayfly::simulate {
namespace {

Promise promise(std::size_t robots) {
  Promise promise;
  promise.robots.assign(robots, {0.1F, 2.0F, 4.0F, true});
  promise.fence = {glm::vec3(0.0F), glm::vec3(10.0F)};
  return promise;
}

// Two robots, the second so far along x from the first.
struct Two {
  explicit Two(Promise promised = promise(2)) : watch(std::move(promised)) {}
  void at(float apart, float z = 5.0F) {
    const std::array<float, 2> x{2.0F, 2.0F + apart};
    const std::array<float, 2> y{5.0F, 5.0F};
    const std::array<float, 2> height{z, z};
    sim_hal::PoseView view;
    view.columns = {x, y, height, y, y, y};
    watch.on_step(view);
  }
  std::uint64_t seen(Breach breach) const { return watch.breaches()[static_cast<std::size_t>(breach)]; }
  BreachWatch watch;
};

TEST(BreachWatch, SeesBodiesTouch) {
  Two two;
  two.at(1.0F);
  two.at(0.2001F);
  EXPECT_EQ(two.seen(Breach::kSeparation), 0U);
  two.at(0.1999F);
  EXPECT_EQ(two.seen(Breach::kSeparation), 1U);
  EXPECT_NEAR(two.watch.least_gap(), -0.0001, 1e-6);
}

TEST(BreachWatch, TwoThatTouchAtTheStartMayUntilTheyAreApartButNoNearer) {
  Two two;
  for (const float apart : {0.15F, 0.16F, 0.15F}) {
    two.at(apart);
  }
  EXPECT_EQ(two.seen(Breach::kSeparation), 0U);
  two.at(0.149F);
  EXPECT_EQ(two.seen(Breach::kSeparation), 1U) << "nearer than at the start";
  two.at(0.21F);
  two.at(0.19F);
  EXPECT_EQ(two.seen(Breach::kSeparation), 2U) << "they were apart";
}

TEST(BreachWatch, SeesBodiesOutside) {
  for (const auto& [apart, z, breaches] :
       {std::tuple{1.0F, 0.0999F, 2U}, std::tuple{1.0F, 0.1001F, 0U}, std::tuple{7.9001F, 5.0F, 1U},
        std::tuple{1.0F, std::numeric_limits<float>::quiet_NaN(), 2U}}) {
    Two two;
    two.at(1.0F);
    two.at(apart, z);
    EXPECT_EQ(two.seen(Breach::kFence), breaches) << apart << " " << z;
  }
}

TEST(BreachWatch, OneThatStartsOutsideMayComeInButGoNoFartherOut) {
  Two two;
  for (const float apart : {8.5F, 8.3F, 8.5F}) {
    two.at(apart);
  }
  EXPECT_EQ(two.seen(Breach::kFence), 0U);
  two.at(8.501F);
  EXPECT_EQ(two.seen(Breach::kFence), 1U);
  two.at(7.8F);
  two.at(7.91F);
  EXPECT_EQ(two.seen(Breach::kFence), 2U) << "it was inside";
}

TEST(BreachWatch, PlanesAreFenceAsWell) {
  Promise leaning = promise(2);
  leaning.planes = {{glm::vec3(0, 0, 1), 5.0F}};
  Two two(leaning);
  two.at(1.0F, 4.0F);
  two.at(1.0F, 4.899F);
  EXPECT_EQ(two.seen(Breach::kFence), 0U);
  two.at(1.0F, 4.901F);
  EXPECT_EQ(two.seen(Breach::kFence), 2U);
}

TEST(BreachWatch, NothingIsPromisedOfWhomTheGovernorDoesNotHave) {
  Promise one = promise(2);
  one.robots[1].governed = false;
  Two two(one);
  two.at(1.0F);
  two.at(0.1F);
  two.at(9.0F);
  EXPECT_EQ(two.watch.breaches(), BreachCounts{});
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
  std::uint64_t seen(Breach breach) const { return breaches.breaches()[static_cast<std::size_t>(breach)]; }

  BreachWatch breaches{promise(1)};
  bench::CommandWatch watch{1, 200, 4.0, breaches};
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

TEST(CommandWatch, KnowsWhenARobotWasToldToStop) {
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

TEST(CommandWatch, KnowsWhenARobotWasToldWhatIsSafe) {
  Commands commands;
  for (const float speed : {1.0F, 1.08F, 1.05F, 1.02F, 0.97F, 0.5F, 0.6F}) {
    commands.tell(speed);
  }
  const auto after = [&](int command) {
    return commands.watch.safe_after(0, command * std::chrono::milliseconds(20));
  };
  EXPECT_EQ(after(0), 4U) << "0.04 m/s less a tick is braking, 0.03 is not";
  EXPECT_EQ(after(4), 0U);
  EXPECT_EQ(after(5), 0U) << "slow enough";
  EXPECT_FALSE(after(6));
  commands.tell(2.0F, CommandKind::kHold);
  EXPECT_EQ(after(6), 1U);
}

}  // namespace
}  // namespace mayfly::simulate
