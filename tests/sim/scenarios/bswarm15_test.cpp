// The behaviours of BSwarm15 and Ren16: each scenario is flown as its file says, on several seeds, and held
// to its own `expect` lines.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

class BSwarm15 : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(BSwarm15, IsFlownAsItExpects) {
  const auto& [name, seed] = GetParam();
  const Flown flown = fly(scenario_file(name), {"--seed", std::to_string(seed)});
  ASSERT_LE(flown.exit_code, 1);
  expect_kept(flown);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, BSwarm15,
                         ::testing::Combine(::testing::Values("aggregation_midges", "bats", "escape",
                                                              "fruit_flies", "locust_migration", "mating",
                                                              "midges", "phase_transition",
                                                              "phase_transition_sparse", "phototaxis_moths"),
                                            ::testing::Values(1, 2, 3)),
                         [](const auto& row) {
                           return std::string(std::get<0>(row.param)) + "_seed_" +
                                  std::to_string(std::get<1>(row.param));
                         });

// Too dear for three seeds, or for their full number.
TEST(BSwarm15Dense, ThreeThousandMidgesGather) {
  expect_kept(fly(scenario_file("aggregation_midges_3000"), {"--duration", "20"}));
}

TEST(BSwarm15Dense, ATenthOfTheLocustsSetsOut) {
  expect_kept(
      fly(scenario_file("locust_migration_200k"), {"--set", "swarms.0.count=20000", "--duration", "1"}));
}

}  // namespace
}  // namespace mayfly::test
