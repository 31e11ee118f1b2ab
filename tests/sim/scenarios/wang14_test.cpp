// The scenarios of Wang14's Table 1, beyond the two blocks, and those that lift its limitations: each is
// flown as its file says, on several seeds, and held to its own `expect` lines.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

struct Case {
  std::string name;   // of the file
  std::string label;  // of the test
  std::vector<std::string> options;
};

class Wang14 : public ::testing::TestWithParam<std::tuple<Case, int>> {};

TEST_P(Wang14, IsFlownAsItExpects) {
  const auto& [what, seed] = GetParam();
  std::vector<std::string> options = what.options;
  options.insert(options.end(), {"--seed", std::to_string(seed)});
  const Flown flown = fly(scenario_file(what.name), options);
  ASSERT_LE(flown.exit_code, 1);
  expect_kept(flown);
  std::printf("%s, seed %d: separation %.4f m, MDE %.4f %%\n", what.label.c_str(), seed,
              flown.number("min_separation_m"), flown.number("mde_percent"));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Wang14,
                         ::testing::Combine(::testing::Values(Case{"crossing_swarms", "crossing_swarms", {}}),
                                            ::testing::Values(1, 2, 3)),
                         [](const auto& row) {
                           return std::get<0>(row.param).label + "_seed_" +
                                  std::to_string(std::get<1>(row.param));
                         });

}  // namespace
}  // namespace mayfly::test
