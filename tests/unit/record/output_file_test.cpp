#include "record/output_file.hpp"

#include <gtest/gtest.h>

#include "tests/unit/record/frames.hpp"

namespace mayfly::record {
namespace {

TEST(OutputFile, AppearsWhenItIsWhole) {
  const test::Folder folder;
  const auto path = folder.path / "file";
  {
    auto file = OutputFile::create(path).value();
    ASSERT_TRUE(file.write("half"));
    EXPECT_FALSE(std::filesystem::exists(path));
    ASSERT_TRUE(file.write(" and half"));
    ASSERT_TRUE(file.commit());
  }
  EXPECT_EQ(test::text_of(path), "half and half");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "file.partial"));
}

TEST(OutputFile, LeavesNothingWithoutCommitAndTheOldFileAsItWas) {
  const test::Folder folder;
  ASSERT_TRUE(write_file(folder.path / "old", "old"));
  {
    auto file = OutputFile::create(folder.path / "old").value();
    auto other = OutputFile::create(folder.path / "new").value();
    ASSERT_TRUE(file.write("new"));
  }
  EXPECT_EQ(test::text_of(folder.path / "old"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

TEST(OutputFile, TheCallerIsToldOfAWrongPath) {
  const test::Folder folder;
  for (const auto& path : {folder.path / "nowhere" / "file", folder.path}) {
    const auto file = OutputFile::create(path);
    ASSERT_FALSE(file) << path;
    EXPECT_EQ(file.error().cause, Cause::kCaller);
  }
}

TEST(OutputFile, ADeviceIsWrittenAndNotReplaced) {
  EXPECT_TRUE(write_file("/dev/null", "text"));
  const auto full = write_file("/dev/full", "text");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().cause, Cause::kEnvironment);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(OutputFile, KeepsALinkAndReplacesItsTarget) {
  const test::Folder folder;
  ASSERT_TRUE(write_file(folder.path / "target", "old"));
  std::filesystem::create_symlink(folder.path / "target", folder.path / "link");
  ASSERT_TRUE(write_file(folder.path / "link", "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path / "link"));
  EXPECT_EQ(test::text_of(folder.path / "target"), "new");
}

}  // namespace
}  // namespace mayfly::record
