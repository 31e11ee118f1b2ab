// The reader of pages itself: a check that finds nothing would pass everything.
#include "tests/docs/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(Page, HasBlocksAndLinks) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("page.md"))
      << "See [a](a.md), [b](../b.md#part) and [web](https://example.org).\n"
         "```sh run exit=2\nmayfly check x\n[no](link.md)\n```\n"
         "```\nplain\n```\n";
  const Page page = read_page(folder.file("page.md"));
  EXPECT_THAT(page.links, ElementsAre("a.md", "../b.md"));
  ASSERT_THAT(page.blocks, SizeIs(2));
  EXPECT_EQ(page.blocks[0].line, 2);
  EXPECT_EQ(page.blocks[0].text, "mayfly check x\n[no](link.md)\n");
  EXPECT_TRUE(page.blocks[0].is("sh") && page.blocks[0].has("run"));
  EXPECT_EQ(page.blocks[0].value("exit"), "2");
  EXPECT_FALSE(page.blocks[1].is("sh"));
}

TEST(Page, OutputIsFoundLineByLine) {
  EXPECT_TRUE(shows("one\n  two 2.5 s\nthree", "two … s"));
  EXPECT_TRUE(shows("one\ntwo", ""));
  EXPECT_FALSE(shows("one\ntwo", "one two"));
  EXPECT_FALSE(shows("two s", "two … s x"));
  EXPECT_FALSE(shows("two", "tow"));
}

TEST(Page, EveryPageIsFound) {
  EXPECT_GE(all_pages(MAYFLY_SOURCE_DIR).size(), 20U);
}

}  // namespace
}  // namespace mayfly::test
