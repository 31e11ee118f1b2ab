// config/scenarios/faults: each family of faults, held to its own lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "controller/scenario/load.hpp"
#include "tests/sim/program/process.hpp"

namespace mayfly::test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(MAYFLY_SOURCE_DIR) / "config" / "scenarios" / "faults";

std::vector<fs::path> families() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class FaultScenario : public testing::TestWithParam<fs::path> {};

TEST_P(FaultScenario, HoldsItsLines) {
  const Outcome outcome = run_program({"test", GetParam().string(), "--seeds", "1..3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.error;
}

INSTANTIATE_TEST_SUITE_P(Families, FaultScenario, testing::ValuesIn(families()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(FaultScenarios, TogetherHaveEveryFault) {
  std::set<FaultKind> kinds;
  for (const fs::path& file : families()) {
    const auto scenario = load_scenario(file, {});
    ASSERT_TRUE(scenario) << file;
    for (const FaultSpec& fault : scenario->faults) {
      kinds.insert(fault.kind);
    }
  }
  EXPECT_EQ(kinds.size(), kFaultKinds);
}

}  // namespace
}  // namespace mayfly::test
