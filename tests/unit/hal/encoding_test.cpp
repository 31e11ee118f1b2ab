// What a HAL encodes is decoded again and compared, whatever the HAL (I14 of docs/explanation/guard.md).
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "controller/composite_hal.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/scripted_hal.hpp"

namespace mayfly::contract {
namespace {

constexpr Time kNow = std::chrono::seconds(1);

// Three robots on a bus that carries velocities in steps of 1/64 m/s; its driver may have a bug.
class CodedHal final : public Hal {
 public:
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return "coded"; }

  float rounding = 0.5F / 64.0F;
  std::optional<RobotIndex> swapped;  // told as its neighbour is
  bool kind_lost = false;

 private:
  Result<void> do_configure() override { return {}; }
  Result<void> do_activate(Time) override { return {}; }
  Result<void> do_deactivate(Time) override { return {}; }
  HalResult do_read(Time, const StateColumns&) noexcept override { return {}; }
  HalResult do_write(Time, const CommandColumns& c) noexcept override {
    for (RobotIndex robot = 0; robot < 3; ++robot) {
      const RobotIndex from = swapped == robot ? (robot + 1) % 3 : robot;
      frames_[robot] = {c.kind[from], std::round(64.0F * c.vx[from]), std::round(64.0F * c.vy[from]),
                        std::round(64.0F * c.vz[from])};
    }
    return {};
  }
  std::optional<float> do_decode(const EchoColumns& to) noexcept override {
    for (RobotIndex robot = 0; robot < 3; ++robot) {
      const Frame& frame = frames_[robot];
      to.kind[robot] = kind_lost && robot == 2 ? CommandKind::kNone : frame.kind;
      to.vx[robot] = frame.vx / 64.0F;
      to.vy[robot] = frame.vy / 64.0F;
      to.vz[robot] = frame.vz / 64.0F;
    }
    return rounding;
  }

  struct Frame {
    CommandKind kind = CommandKind::kNone;
    float vx = 0, vy = 0, vz = 0;
  };
  std::vector<RobotInfo> infos_{{"a", "can0"}, {"b", "can0"}, {"c", "can0"}};
  std::array<Frame, 3> frames_;
};

struct Bus {
  Bus() {
    EXPECT_TRUE(hal.configure());
    EXPECT_TRUE(hal.activate(kNow));
    commands.vx = {0.7F, -0.3F, 0.1F};
  }
  HalResult write() { return hal.write(kNow, commands.columns(kNow, ++sequence)); }
  CodedHal hal;
  Commands commands{3};
  std::uint64_t sequence = 0;
};

TEST(Encoding, WhatIsRightButForItsRoundingPasses) {
  Bus bus;
  EXPECT_TRUE(bus.write().ok());
  EXPECT_EQ(bus.hal.counters().misencoded, 0U);
}

TEST(Encoding, OneThatIsOffByMoreThanItsRoundingIsTold) {
  Bus bus;
  bus.hal.rounding = 0.001F;  // 0.7 is 0.703 on this bus
  const HalResult result = bus.write();
  EXPECT_EQ(result.fault, HalFault::kMisencoded);
  EXPECT_EQ(result.robot, 0U);
  EXPECT_EQ(result.link, "can0");
  EXPECT_EQ(bus.hal.counters().misencoded, 1U);
}

TEST(Encoding, AnotherRobotsCommandIsTold) {
  Bus bus;
  bus.hal.swapped = 1;
  EXPECT_EQ(bus.write().robot, 1U);
  bus.commands.vx[1] = bus.commands.vx[2];
  EXPECT_TRUE(bus.write().ok()) << "no matter where two are told the same";
}

TEST(Encoding, AnotherKindIsTold) {
  Bus bus;
  bus.hal.kind_lost = true;
  EXPECT_EQ(bus.write().robot, 2U);
}

// The base class has made a hold of it: that is what was to be encoded.
TEST(Encoding, ACommandThatWasMendedIsComparedAsItWasMended) {
  Bus bus;
  bus.commands.vx[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(bus.write().fault, HalFault::kNotFinite);
  EXPECT_EQ(bus.hal.counters().misencoded, 0U);
}

TEST(Encoding, ThatOfAChildComesBeforeAllOtherFaults) {
  std::vector<std::unique_ptr<Hal>> children;
  auto first = std::make_unique<ScriptedHal>(2);
  first->write_result = {HalFault::kLinkDown, kEveryRobot, "wire", "cut"};
  auto second = std::make_unique<CodedHal>();
  second->kind_lost = true;
  children.push_back(std::move(first));
  children.push_back(std::move(second));
  CompositeHal hal("all", std::move(children));
  ASSERT_TRUE(hal.configure());
  ASSERT_TRUE(hal.activate(kNow));
  const Commands commands(5);
  const HalResult result = hal.write(kNow, commands.columns(kNow, 1));
  EXPECT_EQ(result.fault, HalFault::kMisencoded);
  EXPECT_EQ(result.robot, 4U);
}

}  // namespace
}  // namespace mayfly::contract
