// Fields that would not fit: said before anything is built, with a cell that would.
#include "controller/scenario/memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/scenario/build.hpp"
#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

using testing::HasSubstr;

Scenario scenario_of(glm::vec3 size, float cell) {
  Scenario scenario;
  scenario.world.bounds.max = size;
  scenario.world.cell = cell;
  scenario.world.goals.resize(1);
  scenario.swarms.resize(1);
  return scenario;
}

std::vector<Error> said_of(const Scenario& scenario, std::optional<double> available) {
  Findings findings;
  check_memory(Values(nullptr, "world"), scenario, available, findings);
  return findings.errors;
}

double suggested_cell(const Error& error) {
  const std::string words = "cell of ";
  const std::size_t at = error.wanted.find(words);
  return at == std::string::npos ? 0.0 : std::stod(error.wanted.substr(at + words.size()));
}

TEST(Memory, SuggestedCellFitsAndHardlyLess) {
  for (const glm::vec3 size : {glm::vec3(20.0F), glm::vec3(7000.0F, 31.0F, 20.0F), glm::vec3(9999.0F)}) {
    for (const double available : {1e30, 1e9, 1e6}) {
      const auto errors = said_of(scenario_of(size, 0.001F), available);
      ASSERT_EQ(errors.size(), 1U);
      const auto cell = static_cast<float>(suggested_cell(errors[0]) * (1.0 + 1e-6));
      EXPECT_TRUE(said_of(scenario_of(size, cell), available).empty()) << size.x << " " << available;
      EXPECT_FALSE(said_of(scenario_of(size, 0.8F * cell), available).empty()) << size.x << " " << available;
    }
  }
}

TEST(Memory, SaysHowManyBytesAndWhoHasToAct) {
  const Scenario scenario = scenario_of(glm::vec3(100.0F), 1.0F);  // a million cells
  const double bytes = 1e6 * field_bytes_per_cell(scenario);
  EXPECT_TRUE(said_of(scenario, std::nullopt).empty());
  EXPECT_TRUE(said_of(scenario, 2.0 * bytes).empty());
  const auto errors = said_of(scenario, bytes);  // the whole of what is left is too much
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].cause, Cause::kEnvironment);
  EXPECT_THAT(errors[0].message, HasSubstr("larger than the memory"));
  EXPECT_THAT(errors[0].found, HasSubstr("40000000 bytes"));
  EXPECT_EQ(said_of(scenario, 0.0).at(0).wanted, "a machine with more memory");
  EXPECT_EQ(said_of(scenario_of(glm::vec3(100.0F), 0.1F), bytes).at(0).cause, Cause::kCaller);
}

TEST(Memory, EverySwarmThatDiffersAndWhatIsSolvedInFlightCostMore) {
  Scenario scenario = scenario_of(glm::vec3(100.0F), 1.0F);
  const double one = field_bytes_per_cell(scenario);
  scenario.swarms.resize(2);
  EXPECT_EQ(field_bytes_per_cell(scenario), one);  // the same field
  scenario.swarms[1].goal = "other";
  EXPECT_GT(field_bytes_per_cell(scenario), one);
  scenario.swarms.resize(1);
  scenario.swarms[0].cost.density_weight = 0.1F;
  EXPECT_GT(field_bytes_per_cell(scenario), one);
}

TEST(Memory, NestedGridIsJudgedByItsCoarseCells) {
  Scenario scenario = scenario_of(glm::vec3(1000.0F), 1.0F);
  EXPECT_FALSE(said_of(scenario, 1e30).empty());
  scenario.world.coarse_cell = 8.0F;
  EXPECT_TRUE(said_of(scenario, 1e30).empty());
}

TEST(Memory, IsReadFromWhatTheMachineSays) {
  EXPECT_EQ(available_in("MemTotal:  100 kB\nMemAvailable:    50 kB\nBuffers: 1 kB\n"), 51200.0);
  for (const char* text : {"", "MemTotal: 100 kB\n", "MemAvailable: lots\n", "MemAvailable: 5\n 7 kB"}) {
    EXPECT_FALSE(available_in(text)) << text;
  }
  const auto here = available_memory();
  EXPECT_TRUE(!here || *here > 0.0);
}

}  // namespace
}  // namespace mayfly
