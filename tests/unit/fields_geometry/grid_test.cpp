#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/make_grid.hpp"

namespace mayfly::fields {
namespace {

TEST(MakeGrid, covers_the_box_with_whole_cells) {
  const Result<Grid> grid = make_grid({{1, 2, 3}, {61, 42.5F, 115}}, 1.0F);
  ASSERT_TRUE(grid) << to_string(grid.error());
  EXPECT_EQ(grid->cells, glm::ivec3(60, 41, 112));
  EXPECT_EQ(grid->origin, glm::vec3(1, 2, 3));
}

TEST(MakeGrid, a_multiple_in_decimal_needs_no_cell_more) {
  for (const float cell : {0.1F, 0.2F, 0.3F, 0.7F, 0.15F}) {
    for (const int count : {1, 10, 77, 400}) {
      const auto side = static_cast<float>(std::round(1e4 * static_cast<double>(cell) * count) / 1e4);
      const Result<Grid> grid = make_grid({glm::vec3(0.0F), {side, cell, cell}}, cell);
      ASSERT_TRUE(grid);
      EXPECT_EQ(grid->cells, glm::ivec3(count, 1, 1)) << side << " m of " << cell;
    }
  }
}

TEST(MakeGrid, refuses_a_grid_of_4_gigabytes_and_names_a_cell_that_fits) {
  const Box bounds{glm::vec3(0.0F), glm::vec3(1024.0F)};
  const Result<Grid> grid = make_grid(bounds, 1.0F);
  ASSERT_FALSE(grid);
  const std::string text = to_string(grid.error());
  EXPECT_NE(text.find("4 GiB"), std::string::npos) << text;
  EXPECT_NE(text.find("1.6 m"), std::string::npos) << text;
  EXPECT_TRUE(make_grid(bounds, 1.6F));
  EXPECT_FALSE(make_grid(bounds, 1e-30F));
  EXPECT_FALSE(make_grid({glm::vec3(-1e38F), glm::vec3(1e38F)}, 1.0F));
}

TEST(MakeGrid, refuses_what_is_no_box_and_no_cell) {
  const Box unit{glm::vec3(0.0F), glm::vec3(1.0F)};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float cell : {0.0F, -1.0F, nan, infinity}) {
    EXPECT_FALSE(make_grid(unit, cell)) << cell;
  }
  EXPECT_FALSE(make_grid({glm::vec3(0.0F), {1, 0, 1}}, 0.1F));
  EXPECT_FALSE(make_grid({glm::vec3(0.0F), {1, -1, 1}}, 0.1F));
  EXPECT_FALSE(make_grid({glm::vec3(0.0F), {1, nan, 1}}, 0.1F));
  EXPECT_FALSE(make_grid({glm::vec3(0.0F), {1, infinity, 1}}, 0.1F));
}

}  // namespace
}  // namespace mayfly::fields
