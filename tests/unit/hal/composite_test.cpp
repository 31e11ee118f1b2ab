#include <gtest/gtest.h>

#include "controller/composite_hal.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/scripted_hal.hpp"

namespace mayfly::contract {
namespace {

constexpr Time kNow = std::chrono::seconds(1);

struct Fixture {
  Fixture() {
    std::vector<std::unique_ptr<Hal>> children;
    for (const auto& [prefix, robots] : {std::pair{"a", 2}, {"b", 3}, {"c", 1}}) {
      auto scripted = std::make_unique<ScriptedHal>(robots, prefix);
      child.push_back(scripted.get());
      children.push_back(std::move(scripted));
    }
    hal = std::make_unique<CompositeHal>("all", std::move(children));
  }
  void make_active() {
    ASSERT_TRUE(hal->configure().has_value());
    ASSERT_TRUE(hal->activate(kNow).has_value());
  }
  std::vector<ScriptedHal*> child;
  std::unique_ptr<CompositeHal> hal;
  States states{6};
  Commands commands{6};
};

TEST(Composite, RobotsStandInTheOrderOfTheChildren) {
  Fixture f;
  f.make_active();
  ASSERT_EQ(f.hal->robots().size(), 6U);
  EXPECT_EQ(f.hal->robots()[1].name, "a1");
  EXPECT_EQ(f.hal->robots()[2].name, "b0");
  EXPECT_EQ(f.hal->robots()[5].name, "c0");
  f.commands.kind[4] = CommandKind::kLand;
  EXPECT_TRUE(f.hal->write(kNow, f.commands.columns(kNow, 1)).ok());
  EXPECT_EQ(f.child[1]->last_kinds[2], CommandKind::kLand);
  EXPECT_EQ(f.child[1]->last_size, 3U);
}

TEST(Composite, OneBrokenChildDoesNotBlockTheOthers) {
  Fixture f;
  f.make_active();
  f.child[1]->read_result = {HalFault::kRobotSilent, 1, "wire", "no answer"};
  f.child[1]->write_result = f.child[1]->read_result;
  f.child[2]->write_result = {HalFault::kLinkDown, kEveryRobot, "wire", "cut"};
  const HalResult read = f.hal->read(kNow, f.states.columns());
  EXPECT_EQ(read.fault, HalFault::kRobotSilent);
  EXPECT_EQ(read.robot, 3U);
  EXPECT_EQ(f.states.valid, (std::vector<std::uint8_t>{1, 1, 0, 0, 0, 1}));
  const HalResult write = f.hal->write(kNow, f.commands.columns(kNow, 1));
  EXPECT_EQ(write.fault, HalFault::kLinkDown) << "the graver of the two";
  EXPECT_EQ(f.child[0]->writes + f.child[1]->writes + f.child[2]->writes, 3);
}

TEST(Composite, AFaultOfAWholeLinkStaysOne) {
  Fixture f;
  f.make_active();
  f.child[2]->read_result = {HalFault::kLinkDown, kEveryRobot, "wire", "cut"};
  EXPECT_EQ(f.hal->read(kNow, f.states.columns()).robot, kEveryRobot);
}

TEST(Composite, EveryChildIsDeactivatedWhateverTheFirstSays) {
  Fixture f;
  f.make_active();
  f.child[0]->deactivate_fails = true;
  EXPECT_FALSE(f.hal->deactivate(kNow).has_value());
  EXPECT_EQ(f.child[1]->state(), HalState::kInactive);
  EXPECT_EQ(f.child[2]->state(), HalState::kInactive);
  f.child[0]->deactivate_fails = false;
  EXPECT_TRUE(f.hal->deactivate(kNow).has_value());
  EXPECT_EQ(f.child[0]->state(), HalState::kInactive);
  EXPECT_EQ(f.child[1]->deactivated, 1);
}

TEST(Composite, AFailedActivationLetsGoOfThoseThatWereActive) {
  Fixture f;
  ASSERT_TRUE(f.hal->configure().has_value());
  f.child[1]->activate_fails = true;
  EXPECT_FALSE(f.hal->activate(kNow).has_value());
  EXPECT_EQ(f.child[0]->state(), HalState::kInactive);
  EXPECT_EQ(f.child[2]->activated, 0);
  f.child[1]->activate_fails = false;
  EXPECT_TRUE(f.hal->activate(kNow).has_value());
}

TEST(Composite, AFailedConfigureMayBeTriedAgain) {
  Fixture f;
  f.child[2]->configure_fails = true;
  EXPECT_FALSE(f.hal->configure().has_value());
  f.child[2]->configure_fails = false;
  EXPECT_TRUE(f.hal->configure().has_value());
  EXPECT_EQ(f.child[0]->configured, 1);
  EXPECT_EQ(f.hal->robots().size(), 6U);
}

TEST(Composite, ANameTwiceIsRefused) {
  std::vector<std::unique_ptr<Hal>> children;
  children.push_back(std::make_unique<ScriptedHal>(1, "same"));
  children.push_back(std::make_unique<ScriptedHal>(2, "same"));
  CompositeHal hal("all", std::move(children));
  const auto done = hal.configure();
  ASSERT_FALSE(done.has_value());
  EXPECT_NE(done.error().message.find("same0"), std::string::npos);
}

}  // namespace
}  // namespace mayfly::contract
