// What the program says to a command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/program/process.hpp"
#include "tests/sim/program/scenario_file.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kScenarios = MAYFLY_SOURCE_DIR "/config/scenarios/";

TEST(CommandLine, HelpHasAnExampleEverywhere) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"--help"},
                                                  {"run", "--help"},
                                                  {"check", "--help"},
                                                  {"test", "--help"},
                                                  {"doctor", "--help"},
                                                  {"bench", "--help"}}) {
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("Example:\n  mayfly "));
  }
}

TEST(CommandLine, MistakesAreBadInput) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{},
                                                  {"run"},
                                                  {"run", "x.yaml", "--engine", "cuda"},
                                                  {"run", "x.yaml", "--threads", "-1"},
                                                  {"run", "x.yaml", "--nonsense"},
                                                  {"run", "x.yaml", "--set", "no_equals_sign"},
                                                  {"check"},
                                                  {"bench", "nois"},
                                                  {"bench", "noise", "--agents", "0"},
                                                  {"bench", "noise", "--figure", "/nowhere/noise.png"}}) {
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.exit_code, 2) << ::testing::PrintToString(command) << outcome.error;
    EXPECT_THAT(outcome.error, Not(IsEmpty()));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

TEST(CommandLine, UnknownCommandsSayWhatThereIs) {
  EXPECT_THAT(run_program({"chekc"}).error, HasSubstr("did you mean 'check'?"));
  const Outcome later = run_program({"plan", "x.yaml"});
  EXPECT_EQ(later.exit_code, 2);
  EXPECT_THAT(later.error,
              HasSubstr("not available yet: 'plan'; wanted run, check, test, guard, doctor or bench"));
}

TEST(CommandLine, AMissingFileIsNamed) {
  const Outcome outcome = run_program({"check", "nowhere.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("nowhere.yaml"));
}

TEST(CommandLine, AnUnknownHalIsNamed) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program({"run", write_small_scenario(folder.path()), "--fast", "--hal", "sin"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("did you mean 'sim'?"));
}

TEST(CommandLine, CheckTellsEachScenario) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program({"check", kScenarios + "two_blocks_passage.yaml", "nowhere.yaml",
                                       kScenarios + "two_blocks_around.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("two_blocks_passage: ok (300 agents, 268 800 cells, 24 triangles; fields "),
                    HasSubstr("two_blocks_around: ok (")));
}

TEST(CommandLine, CheckTellsWhatIsOdd) {
  const Outcome outcome = run_program({"check", kScenarios + "chasing.yaml"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.error, HasSubstr("less than two radii"));
  EXPECT_THAT(run_program({"check", kScenarios + "two_blocks_passage.yaml"}).error, IsEmpty());
}

TEST(CommandLine, DoctorLooksAtTheMachine) {
  const Outcome outcome = run_program({"doctor"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("processors"), HasSubstr("OpenCL device"),
                                 HasSubstr("real-time priority"), HasSubstr("timers"), HasSubstr("cache")));
}

TEST(CommandLine, BenchListsWhatThereIsAndDrawsIt) {
  EXPECT_THAT(run_program({"bench"}).out, HasSubstr("noise"));
  EXPECT_THAT(run_program({"bench", "nois"}).error, HasSubstr("did you mean 'noise'?"));
  const TemporaryFolder folder;
  const auto figure = folder.path() / "noise.png";
  const Outcome outcome = run_program(
      {"bench", "noise", "--agents", "8", "--duration", "1", "--seeds", "1", "--figure", figure.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("path  curl"));
  EXPECT_GT(std::filesystem::file_size(figure), 10'000U);
}

}  // namespace
}  // namespace mayfly::test
