// Every file of tests/bad_input must be refused with exactly the errors that its own first lines promise:
//   # expect: LINE:COLUMN a piece of the message | another piece
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

namespace fs = std::filesystem;

struct Expected {
  int line = 0;
  int column = 0;
  std::vector<std::string> pieces;
};

std::vector<fs::path> bad_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(MAYFLY_SOURCE_DIR) / "tests" / "bad_input")) {
    if (entry.path().extension() == ".yaml") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Expected> expected_of(const fs::path& file) {
  std::vector<Expected> all;
  std::ifstream stream(file);
  const std::string head = "# expect: ";
  for (std::string line; std::getline(stream, line) && line.starts_with(head);) {
    std::istringstream words(line.substr(head.size()));
    Expected expected;
    char colon = 0;
    words >> expected.line >> colon >> expected.column;
    std::string rest;
    std::getline(words, rest);
    for (std::size_t start = 1, bar = 0; start < rest.size(); start = bar + 3) {
      bar = std::min(rest.find(" | ", start), rest.size());
      expected.pieces.push_back(rest.substr(start, bar - start));
    }
    all.push_back(expected);
  }
  return all;
}

class BadInput : public testing::TestWithParam<fs::path> {};

TEST_P(BadInput, IsRefusedWhereItIsWrong) {
  const std::vector<Expected> expected = expected_of(GetParam());
  ASSERT_FALSE(expected.empty()) << "the file does not say what is wrong with it";
  const auto result = load_scenario(GetParam());
  ASSERT_FALSE(result) << "it loads";
  const std::string text = test::all_text(result.error());
  ASSERT_EQ(result.error().size(), expected.size()) << text;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Error& error = result.error()[i];
    ASSERT_TRUE(error.place) << text;
    EXPECT_EQ(error.place->line, expected[i].line) << text;
    EXPECT_EQ(error.place->column, expected[i].column) << text;
    EXPECT_EQ(error.place->file, GetParam().string());
    EXPECT_EQ(error.cause, Cause::kCaller);
    for (const std::string& piece : expected[i].pieces) {
      EXPECT_THAT(to_string(error), testing::HasSubstr(piece));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BadInput, testing::ValuesIn(bad_files()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(BadInputFiles, AreAtLeastFortyFive) {
  EXPECT_GE(bad_files().size(), 45U);
}

// Those that only fail once fields are built must get past this stage, or they would test something else.
TEST(BadWorlds, LoadAsScenarios) {
  int count = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(MAYFLY_SOURCE_DIR) / "tests" / "bad_input" / "world")) {
    const auto result = load_scenario(entry.path());
    EXPECT_TRUE(result) << (result ? "" : test::all_text(result.error()));
    EXPECT_FALSE(expected_of(entry.path()).empty()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 7);
}

}  // namespace
}  // namespace mayfly
