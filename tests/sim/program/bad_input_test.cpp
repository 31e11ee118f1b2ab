// Every broken file of tests/bad_input: exit status 2, the message where and as the file's first line says
// ("# expect: LINE:COLUMN a piece | another"), and nothing left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "tests/sim/program/process.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::filesystem::path kFolder = std::filesystem::path(MAYFLY_SOURCE_DIR) / "tests/bad_input";

std::vector<std::string> broken_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kFolder)) {
    if (entry.path().extension() == ".yaml") {
      files.push_back(entry.path().lexically_relative(kFolder).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  const auto last = text.find_last_not_of(" \r\n");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string file_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class BadInput : public ::testing::TestWithParam<std::string> {};

TEST_P(BadInput, IsRefusedWithItsPlaceAndLeavesNothing) {
  const auto file = kFolder / GetParam();
  std::istringstream text(text_of(file));
  std::string expected;
  std::getline(text, expected);
  const std::string head = "# expect: ";
  ASSERT_EQ(expected.substr(0, head.size()), head)
      << "a broken file says on its first line what is wanted of it";

  const TemporaryFolder folder;
  const std::vector<std::string> environment{"MAYFLY_CACHE_DIR=" + folder.file("cache"),
                                             "TMPDIR=" + folder.file("")};
  const Outcome checked = run_program({"check", file.string()}, environment);
  EXPECT_EQ(checked.exit_code, 2) << checked.out << checked.error;
  EXPECT_THAT(checked.out, IsEmpty());
  std::istringstream wanted(expected.substr(head.size()));
  std::string place;
  wanted >> place;
  EXPECT_THAT(checked.error, HasSubstr(file.filename().string() + ":" + place + ": "));
  for (std::string piece; std::getline(wanted, piece, '|');) {
    EXPECT_THAT(checked.error, HasSubstr(trimmed(piece)));
  }

  const Outcome flown =
      run_program({"run", file.string(), "--fast", "--summary", folder.file("summary.json"), "--record",
                   folder.file("record.csv"), "--plot", folder.file("plot.png")},
                  environment);
  EXPECT_EQ(flown.exit_code, 2) << flown.out << flown.error;
  std::filesystem::remove_all(folder.file("cache"));  // the one thing that may stay
  EXPECT_THAT(folder.listing(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Files, BadInput, ::testing::ValuesIn(broken_files()), file_name);

TEST(BadInputs, AreAtLeastForty) {
  EXPECT_GE(broken_files().size(), 40U);
}

}  // namespace
}  // namespace mayfly::test
