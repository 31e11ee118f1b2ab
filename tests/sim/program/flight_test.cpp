// Whole flights on the simulated HAL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/sim/program/process.hpp"
#include "tests/sim/program/scenario_file.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

using Arguments = std::vector<std::string>;

class Flight : public ::testing::Test {
 protected:
  Outcome fly(const Arguments& more) {
    Arguments arguments{"run", scenario_, "--fast"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  std::string recording(const std::string& name, const Arguments& more) {
    Arguments arguments{"--record", folder_.file(name), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = fly(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return text_of(folder_.file(name));
  }
  nlohmann::json summary(const Arguments& more) {
    Arguments arguments{"--summary", folder_.file("summary.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    fly(arguments);
    return nlohmann::json::parse(text_of(folder_.file("summary.json")));
  }

  TemporaryFolder folder_;
  std::string scenario_ = write_small_scenario(folder_.path());
};

TEST_F(Flight, IsTheSameBitsTwiceAndOnAnyNumberOfThreads) {
  const std::string one = recording("one.csv", {"--threads", "1"});
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1 + 40 * 60);  // 3 s at 20 Hz
  EXPECT_EQ(one, recording("again.csv", {"--threads", "1"}));
  EXPECT_EQ(one, recording("two.csv", {"--threads", "2"}));
  EXPECT_NE(one, recording("other.csv", {"--seed", "6"}));
}

TEST_F(Flight, HappensOnBothEngines) {
  const auto native = summary({"--engine", "native"});
  const auto opencl = summary({"--engine", "opencl"});
  EXPECT_EQ(native["engine"], "native");
  EXPECT_THAT(opencl["engine"].get<std::string>(), StartsWith("opencl"));
  EXPECT_EQ(native["ticks"], 300);
  EXPECT_EQ(opencl["ticks"], 300);
  EXPECT_EQ(native["penetrations"], 0);
  EXPECT_EQ(opencl["penetrations"], 0);
  EXPECT_NEAR(native["max_speed_mps"].get<double>(), opencl["max_speed_mps"].get<double>(), 0.1);
}

TEST_F(Flight, LeavesWhatWasAskedForAndNothingElse) {
  const Outcome outcome = fly({"--summary", folder_.file("s.json"), "--record", folder_.file("r.csv"),
                               "--plot", folder_.file("p.png")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(folder_.listing(), ::testing::ElementsAre("p.png", "r.csv", "s.json", "small.yaml"));
  EXPECT_THAT(text_of(folder_.file("p.png")), StartsWith("\x89PNG"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("40 agents"), HasSubstr("pass penetrations")));
}

TEST_F(Flight, IsQuietWhenAsked) {
  const Outcome outcome = fly({"--quiet"});
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.error, IsEmpty());
}

TEST_F(Flight, TakesValuesFromTheCommandLine) {
  const auto told = summary(
      {"--set", "swarms.flies.count=7", "--set", "name=renamed", "--duration", "0.5", "--seed", "99"});
  EXPECT_EQ(told["agents"], 7);
  EXPECT_EQ(told["scenario"], "renamed");
  EXPECT_EQ(told["ticks"], 50);
  EXPECT_EQ(told["seed"], 99);
}

TEST_F(Flight, SaysOneWhereAnExpectationIsBroken) {
  const Outcome outcome = fly({"--set", "expect=[{max_speed: \"<= 0.1\"}]"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("FAIL max_speed"));
}

TEST_F(Flight, SaysThreeWhereTheRecordingCannotBeWritten) {
  const Outcome outcome = fly({"--record", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("60 of 60 frames lost (No space left on device)"));
  EXPECT_THAT(outcome.out, HasSubstr("300 ticks")) << "a full disk must not touch the flight";
}

TEST_F(Flight, RefusesAFolderThatIsNotThereBeforeItFlies) {
  const Outcome outcome = fly({"--summary", folder_.file("s.json"), "--plot", folder_.file("nowhere/p.png")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("nowhere/p.png': No such file or directory"));
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(folder_.listing(), SizeIs(1));
}

}  // namespace
}  // namespace mayfly::test
