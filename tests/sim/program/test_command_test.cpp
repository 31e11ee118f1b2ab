// mayfly test
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/sim/program/process.hpp"
#include "tests/sim/program/scenario_file.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kBroken = "expect.0.penetrations=\"< 0\"";

TEST(TestCommand, SaysOneLineAFlight) {
  const TemporaryFolder folder;
  const std::string scenario = write_small_scenario(folder.path());
  const Outcome one = run_program({"test", scenario, "--set", "duration=1"});
  EXPECT_EQ(one.exit_code, 0) << one.error;
  EXPECT_THAT(one.out, HasSubstr("pass   small (seed 5): 1 line held in 1 s"));
  EXPECT_THAT(one.out, HasSubstr("1 of 1 passed\n"));
  EXPECT_THAT(one.error, IsEmpty());
  const Outcome several = run_program({"test", scenario, "--set", "duration=0.5", "--seeds", "7..9"});
  EXPECT_EQ(several.exit_code, 0) << several.error;
  const std::size_t first = several.out.find("(seed 7)");
  EXPECT_LT(first, several.out.find("(seed 8)"));
  EXPECT_LT(several.out.find("(seed 8)"), several.out.find("(seed 9)"));
  EXPECT_THAT(several.out, HasSubstr("3 of 3 passed\n"));
}

TEST(TestCommand, ABrokenLineIsSaidAndGivesOne) {
  const TemporaryFolder folder;
  const std::string scenario = write_small_scenario(folder.path());
  const Outcome broken = run_program({"test", scenario, "--set", "duration=0.5", "--set", kBroken});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.out, HasSubstr("FAIL   small (seed 5): penetrations 0, wanted < 0"));
  EXPECT_THAT(broken.out, HasSubstr("0 of 1 passed\n"));
}

TEST(TestCommand, BadInputIsToldAndTheOthersFly) {
  const TemporaryFolder folder;
  const std::string scenario = write_small_scenario(folder.path());
  const Outcome outcome =
      run_program({"test", folder.file("nowhere.yaml"), scenario, "--set", "duration=0.5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out, HasSubstr("error  nowhere"));
  EXPECT_THAT(outcome.out, HasSubstr("pass   small"));
  EXPECT_THAT(outcome.error, HasSubstr("nowhere.yaml"));
}

TEST(TestCommand, AScenarioThatExpectsNothingIsNoTest) {
  const TemporaryFolder folder;
  const std::string scenario = write_small_scenario(folder.path());
  const Outcome outcome = run_program({"test", scenario, "--set", "expect=[]"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error,
              HasSubstr("small.yaml: nothing is expected of this scenario; wanted a list 'expect'"));
}

TEST(TestCommand, WritesXmlForCi) {
  const TemporaryFolder folder;
  const std::string scenario = write_small_scenario(folder.path());
  const std::string file = folder.file("out.xml");
  const Outcome outcome = run_program({"test", scenario, folder.file("no<where.yaml"), "--set",
                                       "duration=0.5", "--set", kBroken, "--junit", file});
  EXPECT_EQ(outcome.exit_code, 2);
  const std::string xml = text_of(file);
  EXPECT_THAT(xml, HasSubstr("<testsuites name=\"mayfly test\" tests=\"2\" failures=\"1\" errors=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"small\" name=\"seed 5\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"penetrations 0, wanted &lt; 0\"/>"));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"no&lt;where\""));
  EXPECT_THAT(xml, HasSubstr("<error message="));
}

TEST(TestCommand, MistakesAreBadInput) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"test"},
                                                  {"test", "x.yaml", "--seeds", "3..1"},
                                                  {"test", "x.yaml", "--seeds", "a..b"},
                                                  {"test", "x.yaml", "--seeds", "1.."},
                                                  {"test", "x.yaml", "--seeds", "-1..3"},
                                                  {"test", "x.yaml", "--junit", "/nowhere/out.xml"}}) {
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.exit_code, 2) << ::testing::PrintToString(command);
    EXPECT_THAT(outcome.error, Not(IsEmpty()));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

}  // namespace
}  // namespace mayfly::test
