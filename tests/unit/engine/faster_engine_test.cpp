#include "controller/engine/faster_engine.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mayfly {
namespace {

// Takes as many rounds of work as it is told, and may have a fault or refuse to be prepared.
class MadeEngine final : public Engine {
 public:
  MadeEngine(std::string_view name, int rounds) : name_(name), rounds_(rounds) {}
  std::string_view name() const noexcept override { return name_; }
  Result<void> prepare(std::span<const SwarmModel>, std::size_t) override {
    if (rounds_ < 0) {
      return fail(Cause::kEnvironment, std::string(name_) + " is not there");
    }
    return {};
  }
  TickCounts compute(const AgentColumns& at, const TickTime&, const VelocityColumns& out) noexcept override {
    for (int round = 0; round < rounds_; ++round) {
      for (std::size_t a = 0; a < at.x.size(); ++a) {
        out.x[a] += at.x[a] * at.x[a];
      }
    }
    return {};
  }
  void move_stimuli(std::size_t, std::span<const glm::vec3>) noexcept override {}
  void replace_fields(std::size_t, const SwarmFields&) noexcept override {}
  std::string_view fault() const noexcept override { return name_ == "faulty" ? "it failed" : ""; }

 private:
  std::string_view name_;
  int rounds_;
};

Result<std::unique_ptr<Engine>> best_of(std::vector<std::unique_ptr<Engine>> engines) {
  const std::vector<float> column(4096, 1.0F);
  return faster_engine(std::move(engines), {}, {column, column, column}, 0.01F);
}

std::vector<std::unique_ptr<Engine>> two(std::unique_ptr<Engine> a, std::unique_ptr<Engine> b) {
  std::vector<std::unique_ptr<Engine>> engines;
  engines.push_back(std::move(a));
  engines.push_back(std::move(b));
  return engines;
}

TEST(FasterEngine, IsTheOneThatTakesLessTime) {
  // A thousand times the work: no busy machine turns that round.
  const auto slow_first =
      best_of(two(std::make_unique<MadeEngine>("slow", 2000), std::make_unique<MadeEngine>("fast", 2)));
  ASSERT_TRUE(slow_first);
  EXPECT_EQ((*slow_first)->name(), "fast");
  const auto fast_first =
      best_of(two(std::make_unique<MadeEngine>("fast", 2), std::make_unique<MadeEngine>("slow", 2000)));
  ASSERT_TRUE(fast_first);
  EXPECT_EQ((*fast_first)->name(), "fast");
}

TEST(FasterEngine, LeavesOutWhatFails) {
  const auto faulty =
      best_of(two(std::make_unique<MadeEngine>("faulty", 0), std::make_unique<MadeEngine>("slow", 20)));
  ASSERT_TRUE(faulty);
  EXPECT_EQ((*faulty)->name(), "slow");
  const auto absent =
      best_of(two(std::make_unique<MadeEngine>("absent", -1), std::make_unique<MadeEngine>("slow", 20)));
  ASSERT_TRUE(absent);
  EXPECT_EQ((*absent)->name(), "slow");
}

TEST(FasterEngine, TellsTheFirstErrorWhereNoneIsLeft) {
  const auto none =
      best_of(two(std::make_unique<MadeEngine>("absent", -1), std::make_unique<MadeEngine>("faulty", 0)));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "absent is not there");
}

}  // namespace
}  // namespace mayfly
