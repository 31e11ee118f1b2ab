// The table as data, and the page that is written from it.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "controller/safety/reaction_table.hpp"

namespace mayfly::test {
namespace {

TEST(FaultTable, PageIsTheTable) {
  std::ifstream file(MAYFLY_SOURCE_DIR "/docs/reference/fault-table.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), fault_table_page())
      << "write it anew: build/dev/controller/safety/mayfly_fault_table_gen .";
}

TEST(FaultTable, EverySymptomHasANameOfItsOwnACauseAndARow) {
  std::set<std::string_view> names;
  for (std::size_t s = 0; s < kSymptoms; ++s) {
    const auto symptom = static_cast<Symptom>(s);
    EXPECT_TRUE(names.insert(info_of(symptom).name).second) << info_of(symptom).name;
    EXPECT_FALSE(info_of(symptom).cause.empty());
    bool has_row = false;
    for (const ReactionRow& row : reaction_table()) {
      has_row = has_row || row.symptom == symptom;
    }
    EXPECT_TRUE(has_row) << info_of(symptom).name;
  }
}

TEST(FaultTable, EverySeverityHasAName) {
  std::set<std::string_view> names;
  for (std::size_t s = 0; s < kSeverities; ++s) {
    EXPECT_TRUE(names.insert(name_of(static_cast<Severity>(s))).second);
  }
}

}  // namespace
}  // namespace mayfly::test
