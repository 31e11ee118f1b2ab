#include "controller/scenario/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// outside/secret.obj, and beside it a project: top/{mayfly.project, meshes/tree.obj, flights/a.yaml}
class Files : public testing::Test {
 protected:
  Files() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    top_ = fs::canonical(testing::TempDir()) /
           (std::string("mayfly_files_") + info->name() + "_" + std::to_string(::getpid()));
    fs::remove_all(top_);
    fs::create_directories(top_ / "outside");
    fs::create_directories(top_ / "project" / "meshes");
    fs::create_directories(top_ / "project" / "flights");
    std::ofstream(top_ / "outside" / "secret.obj") << "v 0 0 0\n";
    std::ofstream(top_ / "project" / "meshes" / "tree.obj") << "v 0 0 0\n";
    std::ofstream(top_ / "project" / "mayfly.project");
  }
  ~Files() override { fs::remove_all(top_); }

  std::string resolve(const std::string& text, bool command_line = false) const {
    YamlNode node;
    node.kind = YamlNode::Kind::kScalar;
    node.text = text;
    node.mark.command_line = command_line;
    const auto file = resolve_file(node, find_roots(top_ / "project" / "flights" / "a.yaml"));
    return file ? file->string() : to_string(file.error());
  }

  fs::path top_;
};

TEST_F(Files, ProjectIsTheNearestMarkedFolder) {
  const FileRoots roots = find_roots(top_ / "project" / "flights" / "a.yaml");
  EXPECT_EQ(roots.project, top_ / "project");
  EXPECT_EQ(roots.scenario, top_ / "project" / "flights");
  fs::create_directory(top_ / "project" / "flights" / ".git");
  EXPECT_EQ(find_roots(top_ / "project" / "flights" / "a.yaml").project, top_ / "project" / "flights");
}

TEST_F(Files, MayBeAnywhereInTheProject) {
  EXPECT_EQ(resolve("../meshes/tree.obj"), (top_ / "project" / "meshes" / "tree.obj").string());
  EXPECT_EQ(resolve("./../flights/../meshes//tree.obj"), (top_ / "project" / "meshes" / "tree.obj").string());
}

TEST_F(Files, MayNotLeaveTheProject) {
  EXPECT_THAT(resolve("../../outside/secret.obj"), HasSubstr("leaves the project"));
  EXPECT_THAT(resolve("../../outside/does_not_exist.obj"), HasSubstr("leaves the project"));
  EXPECT_THAT(resolve("../../project"), HasSubstr("folder"));
  EXPECT_THAT(resolve(".."), HasSubstr("folder"));
  EXPECT_THAT(resolve("../.."), HasSubstr("leaves the project"));
  // A name that merely starts like the project's is another folder.
  fs::create_directory(top_ / "project2");
  std::ofstream(top_ / "project2" / "tree.obj") << "v 0 0 0\n";
  EXPECT_THAT(resolve("../../project2/tree.obj"), HasSubstr("leaves the project"));
}

TEST_F(Files, SymbolicLinksAreFollowedBeforeTheCheck) {
  fs::create_symlink(top_ / "outside", top_ / "project" / "way_out");
  fs::create_symlink(top_ / "outside" / "secret.obj", top_ / "project" / "meshes" / "link.obj");
  fs::create_symlink("tree.obj", top_ / "project" / "meshes" / "good.obj");
  EXPECT_THAT(resolve("../way_out/secret.obj"), HasSubstr("leaves the project"));
  EXPECT_THAT(resolve("../meshes/link.obj"), HasSubstr("leaves the project"));
  EXPECT_EQ(resolve("../meshes/good.obj"), (top_ / "project" / "meshes" / "tree.obj").string());
  fs::create_symlink("loop.obj", top_ / "project" / "meshes" / "loop.obj");
  EXPECT_THAT(resolve("../meshes/loop.obj"), HasSubstr("cannot be"));
}

TEST_F(Files, OnlyTheCommandLineMayNameAnyFile) {
  const std::string secret = (top_ / "outside" / "secret.obj").string();
  EXPECT_THAT(resolve(secret), HasSubstr("only be given on the command line"));
  EXPECT_EQ(resolve(secret, true), secret);
  EXPECT_THAT(resolve("../../outside/secret.obj", true), HasSubstr("leaves the project"));
  EXPECT_THAT(resolve("/dev/zero", true), HasSubstr("a device"));
}

TEST_F(Files, OnlyRegularFiles) {
  ASSERT_EQ(mkfifo((top_ / "project" / "meshes" / "pipe.obj").c_str(), 0600), 0);
  EXPECT_THAT(resolve("../meshes/pipe.obj"), HasSubstr("a pipe"));
  EXPECT_THAT(resolve("../meshes"), HasSubstr("folder"));
  EXPECT_THAT(resolve(std::string(5000, 'a')), HasSubstr("cannot be"));
  const auto pipe = load_scenario(top_ / "project" / "meshes" / "pipe.obj");
  ASSERT_FALSE(pipe);
  EXPECT_THAT(test::all_text(pipe.error()), HasSubstr("a pipe"));
}

TEST_F(Files, MissingOnesSuggestANeighbour) {
  EXPECT_THAT(resolve("../meshes/treee.obj"), HasSubstr("did you mean '../meshes/tree.obj'?"));
  const auto result = load_scenario(top_ / "project" / "mayfly.projekt");
  ASSERT_FALSE(result);
  EXPECT_THAT(test::all_text(result.error()),
              AllOf(HasSubstr("no such file"), HasSubstr("mayfly.project'?")));
}

TEST_F(Files, TooLargeAScenarioIsNotRead) {
  const fs::path file = top_ / "project" / "large.yaml";
  std::ofstream(file) << std::string(kMaxYamlBytes + 1, '#');
  const auto result = load_scenario(file);
  ASSERT_FALSE(result);
  EXPECT_THAT(test::all_text(result.error()), HasSubstr("too large"));
}

TEST_F(Files, PresetsOfTheProjectComeFirst) {
  fs::create_directories(top_ / "project" / "config" / "presets" / "own");
  std::ofstream(top_ / "project" / "config" / "presets" / "own" / "slow.yaml")
      << "cruise_speed: 0.5\nlimts: {}\n";
  std::ofstream(top_ / "project" / "flights" / "a.yaml")
      << test::changed("goal: exit", "goal: exit\n    preset: own/slow");
  const auto result = load_scenario(top_ / "project" / "flights" / "a.yaml");
  ASSERT_FALSE(result);
  EXPECT_THAT(test::all_text(result.error()),
              AllOf(HasSubstr("own/slow.yaml:2:1: unknown key 'limts'"), HasSubstr("'limits'")));
}

}  // namespace
}  // namespace mayfly
