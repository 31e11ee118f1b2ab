// The scenarios of Wang14's Table 1, beyond the two blocks, and those that lift its limitations: each is
// flown as its file says, on several seeds, and held to its own `expect` lines.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <tuple>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

class Wang14 : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(Wang14, IsFlownAsItExpects) {
  const auto& [name, seed] = GetParam();
  const Flown flown = fly(scenario_file(name), {"--seed", std::to_string(seed)});
  ASSERT_LE(flown.exit_code, 1);
  expect_kept(flown);
  std::printf("%s, seed %d: separation %.4f m, MDE %.4f %%\n", name, seed, flown.number("min_separation_m"),
              flown.number("mde_percent"));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Wang14,
                         ::testing::Combine(::testing::Values("aggregation", "chasing", "crossing_swarms",
                                                              "locusts", "phototaxis", "phototaxis_300"),
                                            ::testing::Values(1, 2, 3)),
                         [](const auto& row) {
                           return std::string(std::get<0>(row.param)) + "_seed_" +
                                  std::to_string(std::get<1>(row.param));
                         });

}  // namespace
}  // namespace mayfly::test
