// Scenarios of the project, flown by the program as a user flies them.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/sim/program/process.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {

struct Flown {
  int exit_code = -1;
  std::string error;
  nlohmann::json summary;

  double number(const char* key) const {
    const auto& value = summary.at(key);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  }
};

inline std::string scenario_file(const std::string& name) {
  return MAYFLY_SOURCE_DIR "/config/scenarios/" + name + ".yaml";
}

// `mayfly run FILE --fast --quiet` and `more`; the summary is that of the file.
inline Flown fly(const std::string& file, const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"run",     file,        "--fast",
                                     "--quiet", "--summary", folder.file("summary.json")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_program(arguments);
  Flown flown{outcome.exit_code, outcome.error, {}};
  if (outcome.exit_code <= 1) {
    flown.summary = nlohmann::json::parse(text_of(folder.file("summary.json")));
  } else {
    ADD_FAILURE() << file << ": " << outcome.error;
  }
  return flown;
}

// Holds it to its own `expect` lines; prints those that it broke.
inline void expect_kept(const Flown& flown) {
  EXPECT_EQ(flown.exit_code, 0) << flown.error << flown.summary["expect"].dump(2);
  EXPECT_FALSE(flown.summary["expect"].empty()) << "a scenario that expects nothing shows nothing";
}

}  // namespace mayfly::test
