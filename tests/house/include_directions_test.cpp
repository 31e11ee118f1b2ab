#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/house/include_directions.hpp"

namespace mayfly::house {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A tree with one file, which includes one thing.
class IncludeDirections : public ::testing::Test {
 protected:
  IncludeDirections() : top_(std::filesystem::path(::testing::TempDir()) / test_name()) {
    std::filesystem::remove_all(top_);
  }
  ~IncludeDirections() override { std::filesystem::remove_all(top_); }

  std::vector<std::string> check(const std::string& file, const std::string& line) {
    std::filesystem::create_directories((top_ / file).parent_path());
    std::ofstream(top_ / file) << "// a comment\n" << line << "\n";
    return wrong_includes(top_);
  }

 private:
  static std::string test_name() {
    return std::string("mayfly_includes_") + ::testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  std::filesystem::path top_;
};

TEST_F(IncludeDirections, HoldInThisTree) {
  EXPECT_THAT(wrong_includes(MAYFLY_SOURCE_DIR), IsEmpty());
}

TEST_F(IncludeDirections, DownwardsIsFine) {
  EXPECT_THAT(check("controller/a.cpp", "#include \"fields/b.hpp\""), IsEmpty());
}

TEST_F(IncludeDirections, UpwardsIsNamedWithFileAndLine) {
  EXPECT_THAT(check("core/deep/a.hpp", "#include \"controller/b.hpp\""),
              ElementsAre("core/deep/a.hpp:2: core/ may not look into controller/ ('controller/b.hpp')"));
}

TEST_F(IncludeDirections, KernelsMayNotUseFields) {
  EXPECT_THAT(check("kernels/a.h", "  #  include \"fields/b.hpp\""), ElementsAre(HasSubstr("kernels/a.h:2")));
}

TEST_F(IncludeDirections, OpenClFilesAreReadToo) {
  EXPECT_THAT(check("kernels/a.cl", "#include \"sim_hal/b.h\""), ElementsAre(HasSubstr("kernels/a.cl:2")));
}

TEST_F(IncludeDirections, DriversMayNotSeeTheController) {
  EXPECT_THAT(check("drivers/can/a.cpp", "#include \"controller/b.hpp\""),
              ElementsAre(HasSubstr("drivers/")));
}

TEST_F(IncludeDirections, NobodyLooksIntoTheProgram) {
  EXPECT_THAT(check("examples/a.cpp", "#include \"app/b.hpp\""), ElementsAre(HasSubstr("app/")));
  EXPECT_THAT(check("bench/noise/a.cpp", "#include \"app/b.hpp\""), SizeIs(2));
}

TEST_F(IncludeDirections, OnlyTheProgramLooksIntoBenchmarks) {
  EXPECT_THAT(check("app/a.cpp", "#include \"bench/noise/b.hpp\""), IsEmpty());
  EXPECT_THAT(check("examples/a.cpp", "#include \"bench/noise/b.hpp\""), ElementsAre(HasSubstr("bench/")));
}

TEST_F(IncludeDirections, NeighboursAreNamedFromTheTop) {
  EXPECT_THAT(check("core/a.cpp", "#include \"b.hpp\""), ElementsAre(HasSubstr("top of the tree")));
}

TEST_F(IncludeDirections, GeneratedTextHasNoFolder) {
  EXPECT_THAT(check("core/a.cpp", "#include \"table.inc\""), IsEmpty());
}

TEST_F(IncludeDirections, ClimbingOutIsRefused) {
  EXPECT_THAT(check("core/a.cpp", "#include \"core/../controller/b.hpp\""),
              ElementsAre(HasSubstr("top of the tree")));
}

TEST_F(IncludeDirections, LibrariesAreNobodysRoom) {
  EXPECT_THAT(check("core/a.cpp", "#include <vector>"), IsEmpty());
}

}  // namespace
}  // namespace mayfly::house
