// Ctrl-C stops the swarm first, then the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/sim/program/process.hpp"
#include "tests/sim/program/scenario_file.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

// m/s, of the fastest agent in the last recorded frame
double last_speed(const std::string& recording) {
  std::istringstream lines(recording);
  std::string last_tick;
  double fastest = 0.0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || std::isdigit(static_cast<unsigned char>(line[0])) == 0) {
      continue;
    }
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(cell);
    }
    fastest = row[0] == last_tick ? fastest : 0.0;
    last_tick = row[0];
    fastest = std::max(fastest, std::hypot(std::stod(row[6]), std::stod(row[7]), std::stod(row[8])));
  }
  return fastest;
}

struct Stopped {
  Outcome outcome;
  nlohmann::json summary;
  double speed = 0.0;
};

Stopped stop_a_flight(const std::vector<int>& signals) {
  const TemporaryFolder folder;
  Process program({"run", write_small_scenario(folder.path()), "--set", "record.rate=100", "--duration",
                   "600", "--record", folder.file("r.csv"), "--summary", folder.file("s.json")});
  EXPECT_TRUE(program.read_until("Ctrl-C stops the swarm"));
  for (const int signal : signals) {
    program.send(signal);
  }
  Stopped stopped{program.wait(), {}, 0.0};
  stopped.summary = nlohmann::json::parse(text_of(folder.file("s.json")), nullptr, false);
  stopped.speed = last_speed(text_of(folder.file("r.csv")));
  return stopped;
}

TEST(Stop, InterruptBringsTheSwarmToRestThenEnds) {
  const Stopped stopped = stop_a_flight({SIGINT});
  EXPECT_EQ(stopped.outcome.exit_code, 128 + SIGINT) << stopped.outcome.error;
  EXPECT_LT(stopped.summary["simulated_s"].get<double>(), 600.0);
  EXPECT_LT(stopped.speed, 0.06);
  EXPECT_THAT(stopped.outcome.out, ::testing::HasSubstr("stopped by the user"));
}

TEST(Stop, TerminationIsLikeAnInterrupt) {
  const Stopped stopped = stop_a_flight({SIGTERM});
  EXPECT_EQ(stopped.outcome.exit_code, 128 + SIGTERM) << stopped.outcome.error;
  EXPECT_LT(stopped.speed, 0.06);
}

}  // namespace
}  // namespace mayfly::test
