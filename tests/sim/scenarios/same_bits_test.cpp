// The same recording, bit for bit, whatever computes it.
#include <gtest/gtest.h>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

class SameBits : public ::testing::TestWithParam<const char*> {
 protected:
  std::string recording(std::vector<std::string> more) {
    more.insert(more.end(), {"--record", folder_.file("r.csv"), "--seed", "7"});
    engine_ = fly(scenario_file(GetParam()), more).summary["engine"];
    return text_of(folder_.file("r.csv"));
  }
  std::string engine_;

 private:
  TemporaryFolder folder_;
};

TEST_P(SameBits, OnOneThreadOnTwoAndOnceMore) {
  const std::string one = recording({"--threads", "1"});
  ASSERT_GT(one.size(), 1'000'000U);
  EXPECT_TRUE(one == recording({"--threads", "2"})) << "two threads";
  EXPECT_TRUE(one == recording({"--threads", "1"})) << "once more";
}

// Ten seconds are 300 000 commands, curl and minimum distance among them.
TEST_P(SameBits, FromBothEngines) {
  const std::string native = recording({"--duration", "10", "--engine", "native"});
  EXPECT_EQ(engine_, "native");
  const std::string opencl = recording({"--duration", "10", "--engine", "opencl"});
  EXPECT_EQ(engine_.rfind("opencl", 0), 0U) << engine_;
  ASSERT_GT(native.size(), 1'000'000U);
  EXPECT_TRUE(native == opencl);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, SameBits, ::testing::Values("two_blocks_passage", "two_blocks_around"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace mayfly::test
