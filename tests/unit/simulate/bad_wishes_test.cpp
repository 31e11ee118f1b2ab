// What a guard is handed while its planner fails.
#include "simulate/bad_wishes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/guard/wish.hpp"

namespace mayfly::test {
namespace {

struct Handed {
  std::vector<float> vx;
  Time deadline{0};
  std::uint64_t sequence = 0;
};

class Guard final : public GuardPort {
 public:
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return "guard"; }
  void ask_to_stop(int level) noexcept override { asked = level; }
  void set_present(std::span<const std::uint8_t>) noexcept override {}
  void acknowledge() noexcept override {}
  Severity severity() const noexcept override { return Severity::kNone; }
  CommandColumns written() const noexcept override { return {}; }
  std::uint64_t reactions() const noexcept override { return 0; }
  GuardReport report() const override { return {}; }
  std::vector<GuardEvent> events() const override { return {}; }

  std::vector<Handed> handed;
  int refused = 0;
  int asked = 0;

 private:
  Result<void> do_configure() override { return {}; }
  Result<void> do_activate(Time) override { return {}; }
  Result<void> do_deactivate(Time) override { return {}; }
  HalResult do_read(Time, const StateColumns&) noexcept override { return {}; }
  HalResult do_write(Time, const CommandColumns& wish) noexcept override {
    handed.push_back({{wish.vx.begin(), wish.vx.end()}, wish.deadline, wish.sequence});
    return {};
  }
  void on_refused() noexcept override { ++refused; }
  std::vector<RobotInfo> infos_{{"flies_0", "sim"}, {"flies_1", "sim"}};
};

// Ticks of 10 ms; wishes of v = the tick's number, good for 50 ms.
struct Planner {
  explicit Planner(FaultKind kind, double size = 0.0) {
    FaultSpec fault;
    fault.kind = kind;
    fault.agents = {{1, 1}};
    fault.at = 0.1;
    fault.length = 0.1;
    fault.size = size;
    scenario.faults = {fault};
    between.emplace(scenario, guard);
    EXPECT_TRUE(between->configure());
    EXPECT_TRUE(between->activate(now));
  }
  // Up to `tick`, which is written last.
  void fly(std::uint64_t tick) {
    for (; sequence <= tick; ++sequence) {
      const WishOf wish(2, {static_cast<float>(sequence), 0, 0});
      between->write(now, wish.columns(now + 5 * kTick, sequence + 1));
      now += kTick;
    }
  }
  const Handed& last() const { return guard.handed.back(); }

  Scenario scenario;
  Guard guard;
  std::optional<simulate::BadWishes> between;
  Time now{std::chrono::seconds(7)};
  std::uint64_t sequence = 0;
};

TEST(BadWishes, AStalledPlannersLastWishStaysWithItsDeadline) {
  Planner planner(FaultKind::kPlannerStall);
  planner.fly(9);
  EXPECT_EQ(planner.last().vx[0], 9.0F);
  const Time deadline = planner.last().deadline;
  for (std::uint64_t tick = 10; tick < 20; ++tick) {
    planner.fly(tick);
    EXPECT_EQ(planner.last().vx[0], 9.0F);
    EXPECT_EQ(planner.last().deadline, deadline);
  }
  planner.fly(20);
  EXPECT_EQ(planner.last().vx[0], 20.0F) << "it goes on";
  EXPECT_EQ(planner.guard.handed.size(), 21U) << "one a tick";
}

TEST(BadWishes, AReplayedWishHasItsOldNumberAndComesBeforeTheNewOne) {
  Planner planner(FaultKind::kCommandReplay, 0.05);
  planner.fly(9);
  EXPECT_EQ(planner.guard.refused, 0);
  planner.fly(19);
  EXPECT_EQ(planner.guard.refused, 10);
  EXPECT_EQ(planner.last().vx[0], 19.0F) << "the new one is handed over all the same";
  planner.fly(30);
  EXPECT_EQ(planner.guard.refused, 10);
}

TEST(BadWishes, NothingIsReplayedThatIsNotSoOld) {
  Planner planner(FaultKind::kCommandReplay, 0.15);
  planner.fly(14);
  EXPECT_EQ(planner.guard.refused, 0);
  planner.fly(15);
  EXPECT_EQ(planner.guard.refused, 1);
}

TEST(BadWishes, AbsurdAndNanStrikeWhomTheyNameAndNobodyElse) {
  for (const FaultKind kind : {FaultKind::kPlannerAbsurd, FaultKind::kPlannerNan}) {
    Planner planner(kind, 1e6);
    for (std::uint64_t tick = 0; tick < 25; ++tick) {
      planner.fly(tick);
      const bool is_on = tick >= 10 && tick < 20;
      EXPECT_EQ(planner.last().vx[0], static_cast<float>(tick));
      EXPECT_EQ(planner.last().vx[1] == static_cast<float>(tick), !is_on) << tick;
      EXPECT_EQ(std::isnan(planner.last().vx[1]), is_on && kind == FaultKind::kPlannerNan);
    }
  }
}

TEST(BadWishes, AnOperatorGoesPastThem) {
  Planner planner(FaultKind::kPlannerStall);
  planner.fly(15);
  planner.between->ask_to_stop(2);
  EXPECT_EQ(planner.guard.asked, 2);
}

}  // namespace
}  // namespace mayfly::test
