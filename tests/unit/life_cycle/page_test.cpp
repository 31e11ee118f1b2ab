// docs/reference/life-cycle.md says what the program does, no more and no less.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "controller/life_cycle/transitions.hpp"

namespace mayfly {
namespace {

using Row = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  const std::size_t last = text.find_last_not_of(' ');
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

// The rows of the table below a heading, without its head.
std::set<Row> table_below(const std::string& heading) {
  std::ifstream in(MAYFLY_SOURCE_DIR "/docs/reference/life-cycle.md");
  std::set<Row> rows;
  std::string line;
  bool inside = false;
  int head = 2;
  while (std::getline(in, line)) {
    if (line.starts_with("## ")) {
      inside = line == "## " + heading;
    } else if (inside && line.starts_with('|') && head-- <= 0) {
      Row row;
      std::istringstream cells(line.substr(1));
      for (std::string cell; std::getline(cells, cell, '|');) {
        row.push_back(trimmed(cell));
      }
      rows.insert(row);
    }
  }
  return rows;
}

TEST(LifeCyclePage, HasEveryTransition) {
  std::set<Row> rows;
  for (const Transition& t : life_cycle::kTransitions) {
    rows.insert({std::string(name_of(t.from)), std::string(name_of(t.event)), std::string(name_of(t.to))});
  }
  EXPECT_EQ(table_below("Transitions"), rows);
}

TEST(LifeCyclePage, HasEveryCommandOfEveryState) {
  std::set<Row> rows;
  for (std::size_t s = 0; s < kRobotStates; ++s) {
    const auto state = static_cast<RobotState>(s);
    std::string allowed;
    for (std::size_t kind = 1; kind < 6; ++kind) {
      if (allows(state, static_cast<CommandKind>(kind))) {
        allowed += (allowed.empty() ? "" : ", ") + std::string(name_of(static_cast<CommandKind>(kind)));
      }
    }
    rows.insert({std::string(name_of(state)), allowed, std::string(name_of(own_command(state, false))),
                 std::string(name_of(own_command(state, true)))});
  }
  EXPECT_EQ(table_below("Commands"), rows);
}

}  // namespace
}  // namespace mayfly
