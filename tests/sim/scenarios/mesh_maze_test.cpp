// mesh_maze with every mesh that scripts/fetch-meshes takes from Debian, its elephant among them: any closed
// mesh in its place must fly as well.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

class MeshMaze : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshMaze, IsFlownAsItExpects) {
  const std::string mesh = std::string(GetParam()) + ".off";
  if (!std::filesystem::exists(MAYFLY_SOURCE_DIR "/config/meshes/" + mesh)) {
    GTEST_SKIP() << "config/meshes/" << mesh << " is missing: run scripts/fetch-meshes";
  }
  const Flown flown = fly(scenario_file("mesh_maze"), {"--set", "world.obstacles.0.mesh=../meshes/" + mesh});
  ASSERT_LE(flown.exit_code, 1);
  expect_kept(flown);
  std::printf("%s: reached %.4g, separation %.4f m, %g penetrations, %g collisions\n", GetParam(),
              flown.number("reached_fraction"), flown.number("min_separation_m"),
              flown.number("penetrations"), flown.number("collisions"));
}

INSTANTIATE_TEST_SUITE_P(Meshes, MeshMaze,
                         ::testing::Values("elephant", "bunny00", "cactus", "cow", "eight", "elk", "hand",
                                           "knot1", "sphere"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace mayfly::test
