// Tests neither sleep nor hide: time is injected, and what is not run is not a test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace mayfly::house {
namespace {

using ::testing::IsEmpty;

// In two halves, so that this file doesn't find itself.
const std::array<std::string, 5> kUnwanted = {std::string("sleep") + "_for", std::string("usle") + "ep(",
                                              std::string("nanosl") + "eep(", std::string("DISABLED") + "_",
                                              std::string("system") + "_clock"};

std::vector<std::string> unwanted_words(const std::string& text) {
  std::vector<std::string> found;
  for (const std::string& word : kUnwanted) {
    if (text.find(word) != std::string::npos) {
      found.push_back(word);
    }
  }
  return found;
}

TEST(TestSources, UnwantedWordsAreFound) {
  for (const std::string& word : kUnwanted) {
    EXPECT_EQ(unwanted_words("x " + word + " y"), std::vector<std::string>{word});
  }
  EXPECT_THAT(unwanted_words("clock.sleep_until(deadline);"), IsEmpty());
}

TEST(TestSources, NeitherSleepNorHide) {
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(MAYFLY_SOURCE_DIR) / "tests")) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".cpp" || ending == ".hpp") {
      std::ifstream in(entry.path());
      std::ostringstream text;
      text << in.rdbuf();
      EXPECT_THAT(unwanted_words(text.str()), IsEmpty()) << "in " << entry.path();
    }
  }
}

}  // namespace
}  // namespace mayfly::house
