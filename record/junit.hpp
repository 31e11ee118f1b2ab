// JUnit XML: what CI systems read of a test run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mayfly::record {

struct JUnitCase {
  std::string suite;  // the scenario
  std::string name;   // "seed 3"
  double seconds = 0.0;
  std::string failure;  // what does not hold; empty where all does
  std::string error;    // why it did not fly; empty where it did
};

// One document with a suite for each name, in the order in which they come first. What XML 1.0 cannot hold is
// replaced by '?'.
std::string to_junit(std::string_view name, const std::vector<JUnitCase>& cases);

}  // namespace mayfly::record
