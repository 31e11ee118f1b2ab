// docs/README.md leads to every page, and no two decisions have one number.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/docs/page.hpp"

namespace mayfly::test {
namespace {

namespace fs = std::filesystem;

const fs::path kDocs = fs::path(MAYFLY_SOURCE_DIR) / "docs";

std::set<std::string> pages_below(const fs::path& folder) {
  std::set<std::string> pages;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".md") {
      pages.insert(fs::relative(entry.path(), kDocs).generic_string());
    }
  }
  return pages;
}

TEST(Index, LinksEveryPage) {
  const Page index = read_page(kDocs / "README.md");
  const std::set<std::string> linked(index.links.begin(), index.links.end());
  for (const std::string& page : pages_below(kDocs)) {
    EXPECT_TRUE(page == "README.md" || linked.contains(page)) << page << " is in no list of docs/README.md";
  }
}

TEST(Index, NumbersEachDecisionOnce) {
  std::set<std::string> numbers;
  const std::set<std::string> decisions = pages_below(kDocs / "decisions");
  EXPECT_FALSE(decisions.empty());
  for (const std::string& decision : decisions) {
    const std::string number = fs::path(decision).filename().string().substr(0, 4);
    EXPECT_EQ(number.find_first_not_of("0123456789"), std::string::npos) << decision;
    EXPECT_TRUE(numbers.insert(number).second) << decision << ": its number is taken";
  }
}

}  // namespace
}  // namespace mayfly::test
