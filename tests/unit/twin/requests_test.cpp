// An operator's thread asks while another flies.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "controller/twin/twin_hal.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/scripted_hal.hpp"

namespace mayfly {
namespace {

TEST(TwinRequests, FromAnotherThreadAreEachAnsweredOnce) {
  TwinConfig config;
  config.robots.resize(2);
  config.most_distance = config.most_speed = 1e6F;
  TwinHal hal(std::make_unique<contract::ScriptedHal>(2), config);
  ASSERT_TRUE(hal.configure());
  ASSERT_TRUE(hal.activate(Time{0}));
  std::atomic<bool> done{false};
  int taken_out = 0, put_back = 0, wrong = 0;
  std::thread asker([&] {
    for (int i = 0; i < 200; ++i) {
      const bool out = i % 2 == 0;
      wrong += (out ? hal.take_out(1) : hal.put_back(1)) ? 0 : 1;
      TwinReport report = hal.report(1);
      while (report.outcome == TwinOutcome::kPending) {
        report = hal.report(1);
      }
      taken_out += report.outcome == TwinOutcome::kTakenOut ? 1 : 0;
      put_back += report.outcome == TwinOutcome::kPutBack ? 1 : 0;
      wrong += hal.is_twin(1) == out ? 0 : 1;
    }
    done = true;
  });
  contract::States states(2);
  contract::Commands commands(2);
  std::uint64_t sequence = 0;
  for (Time now{0}; !done; now += std::chrono::milliseconds(1)) {
    ASSERT_TRUE(hal.read(now, states.columns()).ok());
    ASSERT_TRUE(hal.write(now, commands.columns(now + std::chrono::seconds(1), ++sequence)).ok());
  }
  asker.join();
  EXPECT_EQ(taken_out, 100);
  EXPECT_EQ(put_back, 100);
  EXPECT_EQ(wrong, 0);
  EXPECT_FALSE(hal.is_twin(0));
}

}  // namespace
}  // namespace mayfly
