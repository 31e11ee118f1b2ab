// How punctual this machine can be.
#pragma once

#include <string>
#include <vector>

namespace mayfly::app {

struct Finding {
  bool ok = true;
  std::string name;
  std::string what;    // what is there, or what is missing
  std::string remedy;  // empty where there is nothing to do
};

// Rights (priority, locked memory), limits, processors, and how late timers are just now: takes a third of a
// second.
std::vector<Finding> look_at_realtime();

}  // namespace mayfly::app
