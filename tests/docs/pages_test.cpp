// What the documentation tells a reader to type is typed here, and what it shows must come out.
//
//   ```sh run            is run by a shell at the top of a copy of the project, and must succeed;
//   ```sh run exit=2     must end with that status;
//   ```sh run needs=F    is left out, visibly, where the file F is not there;
//   ```sh not-run        is for what a test can't do (make, apt-get): its make targets must exist;
//   ```text output       must be found in what the block before it printed, line by line; "…" is anything.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/docs/page.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = MAYFLY_SOURCE_DIR;

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(' ') - first + 1);
}

class Pages : public ::testing::TestWithParam<fs::path> {
 protected:
  std::string at(const Block& block) const { return page_.file.string() + ':' + std::to_string(block.line); }

  // A project as a reader has it after a build.
  void make_copy() const {
    fs::copy(kTop / "config", folder_.path() / "config", fs::copy_options::recursive);
    fs::copy(kTop / "mayfly.project", folder_.path() / "mayfly.project");
    fs::create_directories(folder_.path() / "build/release");
    fs::create_symlink(MAYFLY_PROGRAM, folder_.path() / "build/release/mayfly");
  }

  void run(const Block& block) {
    std::ofstream(folder_.path() / ".block") << block.text;
    const std::string command = "cd '" + folder_.path().string() +
                                "' && PATH=\"$PWD/build/release:$PATH\" /bin/sh -eu .block >.output 2>&1";
    const int status = std::system(command.c_str());
    output_ = text_of(folder_.file(".output"));
    const std::string wanted = block.value("exit");
    EXPECT_EQ(WEXITSTATUS(status), wanted.empty() ? 0 : std::stoi(wanted)) << at(block) << "\n" << output_;
  }

  void compare(const Block& block) const {
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(shows(output_, trimmed(line))) << at(block) << ": '" << line << "' is not in\n" << output_;
    }
  }

  void expect_make_targets(const Block& block) const {
    static const std::regex kTarget(R"(\bmake ([a-z]+))");
    const std::string makefile = '\n' + text_of((kTop / "Makefile").string());
    for (std::sregex_iterator m(block.text.begin(), block.text.end(), kTarget), end; m != end; ++m) {
      EXPECT_NE(makefile.find('\n' + (*m)[1].str() + ':'), std::string::npos)
          << at(block) << ": " << m->str();
    }
  }

  Page page_ = read_page(GetParam());
  TemporaryFolder folder_;
  std::string output_;
};

TEST_P(Pages, CommandsDoWhatThePageSays) {
  make_copy();
  std::string missing;
  bool left_out = false;
  for (const Block& block : page_.blocks) {
    if (block.is("sh") && block.has("run")) {
      const std::string needs = block.value("needs");
      left_out = !needs.empty() && !fs::exists(folder_.path() / needs);
      if (left_out) {
        missing += " " + needs;
      } else {
        run(block);
      }
    } else if (block.is("text") && block.has("output") && !left_out) {
      compare(block);
    }
  }
  if (!missing.empty()) {
    GTEST_SKIP() << "a part of this page was left out; missing:" << missing << " (scripts/fetch-meshes)";
  }
}

TEST_P(Pages, NoCommandIsLeftUntested) {
  static const std::regex kCommand(R"((^|\n)(build/release/)?mayfly (run|check|doctor)\b)");
  for (const Block& block : page_.blocks) {
    if (block.is("sh")) {
      EXPECT_NE(block.has("run"), block.has("not-run")) << at(block) << ": say 'run' or 'not-run'";
      expect_make_targets(block);
    } else {
      EXPECT_FALSE(std::regex_search(block.text, kCommand)) << at(block) << ": a command outside ```sh";
    }
  }
}

TEST_P(Pages, LinksLeadSomewhere) {
  for (const std::string& link : page_.links) {
    EXPECT_TRUE(fs::exists(page_.file.parent_path() / link)) << page_.file << ": " << link;
  }
}

std::string name_of(const ::testing::TestParamInfo<fs::path>& info) {
  std::string name = fs::relative(info.param, kTop).replace_extension("").string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Docs, Pages, ::testing::ValuesIn(all_pages(kTop)), name_of);

}  // namespace
}  // namespace mayfly::test
