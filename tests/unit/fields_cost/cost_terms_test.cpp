#include "fields/cost_terms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "fields/goal.hpp"
#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

const Grid kGrid{{-1.0F, 2.0F, 0.5F}, 0.5F, {13, 9, 7}};

struct Positions {
  std::vector<float> x, y, z;

  void add(glm::vec3 p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
};

std::vector<float> density_of(const Positions& p, const Grid& grid = kGrid) {
  std::vector<float> density(grid.size(), -7.0F);  // what stood there before does not count
  EXPECT_TRUE(bin_density(p.x, p.y, p.z, grid, density));
  return density;
}

double agents_in(const std::vector<float>& density, const Grid& grid = kGrid) {
  return std::accumulate(density.begin(), density.end(), 0.0) * std::pow(static_cast<double>(grid.cell), 3);
}

glm::vec3 any_place(std::mt19937& random, const Grid& grid) {
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  return grid.origin +
         grid.cell * glm::vec3(grid.cells) * glm::vec3(share(random), share(random), share(random));
}

TEST(Density, CountsEveryAgentOnceWhereverItIs) {
  std::mt19937 random(1);
  for (const glm::ivec3 cells : {kGrid.cells, glm::ivec3(1, 1, 1), glm::ivec3(2, 1, 5)}) {
    const Grid grid{kGrid.origin, kGrid.cell, cells};
    Positions p;
    for (int agent = 0; agent < 100; ++agent) {
      p.add(any_place(random, grid));
    }
    p.add(grid.origin);
    p.add(grid.origin + grid.cell * glm::vec3(cells));
    EXPECT_NEAR(agents_in(density_of(p, grid), grid), 102.0, 1e-3);
  }
}

// Of one agent, against the spread written as an integral: a hat of two cells, then ¼ ½ ¼.
TEST(Density, SpreadsAsTheHatAndTheBinomialSay) {
  const auto hat = [](double u) { return std::max(0.0, 1.0 - std::abs(u)); };
  const auto weight = [&](double u) { return 0.25 * hat(u - 1) + 0.5 * hat(u) + 0.25 * hat(u + 1); };
  const glm::vec3 at(1.93F, 4.31F, 2.17F);
  Positions p;
  p.add(at);
  const std::vector<float> density = density_of(p);
  for (int k = 0; k < kGrid.cells.z; ++k) {
    for (int j = 0; j < kGrid.cells.y; ++j) {
      for (int i = 0; i < kGrid.cells.x; ++i) {
        const glm::dvec3 u = glm::dvec3(kGrid.center(i, j, k) - at) / 0.5;
        EXPECT_NEAR(density[kGrid.index(i, j, k)], 8.0 * weight(u.x) * weight(u.y) * weight(u.z), 1e-5);
      }
    }
  }
}

TEST(Density, AnAgentThatCrossesAFaceMakesNothingJump) {
  for (const float face : {0.0F, 0.5F, 1.0F}) {  // in cells: centres are at halves
    Positions before;
    Positions after;
    const glm::vec3 at = kGrid.center(5, 4, 3);
    before.add(at + glm::vec3((face - 1e-4F) * kGrid.cell, 0, 0));
    after.add(at + glm::vec3((face + 1e-4F) * kGrid.cell, 0, 0));
    const auto a = density_of(before);
    const auto b = density_of(after);
    for (std::size_t cell = 0; cell < a.size(); ++cell) {
      EXPECT_NEAR(a[cell], b[cell], 1e-3F * 8.0F);
    }
  }
}

TEST(Density, IsEvenForAnEvenCrowdUpToTheBorder) {
  Positions p;
  for (int k = 0; k < kGrid.cells.z; ++k) {
    for (int j = 0; j < kGrid.cells.y; ++j) {
      for (int i = 0; i < kGrid.cells.x; ++i) {
        p.add(kGrid.center(i, j, k));
      }
    }
  }
  for (const float density : density_of(p)) {
    EXPECT_NEAR(density, 8.0F, 1e-4F);
  }
}

TEST(Density, LeavesOutWhoIsOutsideOrNowhere) {
  Positions p;
  p.add({-1.01F, 4.0F, 2.0F});
  p.add({3.0F, 1e30F, 2.0F});
  p.add({3.0F, 4.0F, std::nanf("")});
  EXPECT_EQ(agents_in(density_of(p)), 0.0);
  EXPECT_EQ(agents_in(density_of({})), 0.0);
}

TEST(Density, RefusesColumnsOfDifferentLengths) {
  std::vector<float> density(kGrid.size());
  const std::vector<float> two(2);
  const std::vector<float> three(3);
  EXPECT_FALSE(bin_density(two, three, two, kGrid, density));
  EXPECT_FALSE(bin_density(two, two, three, kGrid, density));
  EXPECT_FALSE(bin_density(two, two, two, kGrid, std::span(density).first(5)));
  EXPECT_FALSE(add_density(1.0F, density, std::span(density).first(5)));
}

TEST(Brushes, AreTheBellOfWang14) {
  std::vector<float> extra(kGrid.size(), 1.0F);
  const CostBrush brush{{1.2F, 4.0F, 2.0F}, 1.3F, -0.7F};
  ASSERT_TRUE(add_brushes({{brush}}, kGrid, extra));
  for (int k = 0; k < kGrid.cells.z; ++k) {
    for (int j = 0; j < kGrid.cells.y; ++j) {
      for (int i = 0; i < kGrid.cells.x; ++i) {
        const double r = glm::length(glm::dvec3(kGrid.center(i, j, k)) - glm::dvec3(brush.center)) / 1.3;
        const double bell =
            r > 1 ? 0.0 : 1 - 4.0 / 9 * std::pow(r, 6) + 17.0 / 9 * std::pow(r, 4) - 22.0 / 9 * r * r;
        EXPECT_NEAR(extra[kGrid.index(i, j, k)], 1.0 - 0.7 * bell, 1e-5);
      }
    }
  }
}

TEST(Brushes, FarAwayOrHugeAreNoTrouble) {
  std::vector<float> extra(kGrid.size(), 0.0F);
  const std::vector<CostBrush> brushes{{glm::vec3(1e30F), 1.0F, 5.0F}, {glm::vec3(-1e9F), 1e3F, 5.0F}};
  ASSERT_TRUE(add_brushes(brushes, kGrid, extra));
  EXPECT_EQ(extra, std::vector<float>(kGrid.size(), 0.0F));
  ASSERT_TRUE(add_brushes({{{glm::vec3(0.0F), 1e9F, 5.0F}}}, kGrid, extra));
  EXPECT_NEAR(extra.back(), 5.0F, 1e-5F);
}

TEST(Brushes, RefusesBadOnesAndThenAddsNone) {
  const float nan = std::nanf("");
  std::vector<float> extra(kGrid.size(), 0.0F);
  const CostBrush good{{1.0F, 4.0F, 2.0F}, 1.0F, 1.0F};
  for (const CostBrush& bad :
       {CostBrush{glm::vec3(nan), 1.0F, 1.0F}, CostBrush{glm::vec3(0.0F), 0.0F, 1.0F},
        CostBrush{glm::vec3(0.0F), nan, 1.0F}, CostBrush{glm::vec3(0.0F), 1.0F, nan}}) {
    EXPECT_FALSE(add_brushes({{good, bad}}, kGrid, extra));
  }
  EXPECT_EQ(extra, std::vector<float>(kGrid.size(), 0.0F));
  EXPECT_FALSE(add_brushes({{good}}, kGrid, std::span(extra).first(3)));
}

const Grid kRoom = worlds::cube(20, 20.0F);

CostField with_extra(const std::vector<float>& extra, const CostParams& params = {}) {
  auto field = build_cost_field(worlds::obstacles(kRoom, worlds::nothing()),
                                worlds::goal(kRoom, worlds::sphere(glm::vec3(15.0F, 10.0F, 10.0F), 2.0F)),
                                params, 2, {}, {extra});
  EXPECT_TRUE(field);
  return std::move(*field);
}

TEST(CostTerms, AnEvenExtraIsALargerA) {
  const std::vector<float> extra(kRoom.size(), 0.3F);
  CostParams params;
  params.repulsion_weight = 0.0F;
  const glm::vec3 p = kRoom.center(2, 10, 10);
  const float plain = with_extra({}, params).cost_at(p);
  // Outside the goal, whose cells keep their depth.
  EXPECT_NEAR(with_extra(extra, params).cost_at(p) / plain, 0.9F / 0.6F, 0.05F);
}

TEST(CostTerms, NothingAddedIsNoTerm) {
  EXPECT_EQ(with_extra(std::vector<float>(kRoom.size(), 0.0F)).guide, with_extra({}).guide);
}

TEST(CostTerms, WaysLeadAroundWhatRepelsAndThroughWhatAttracts) {
  const glm::vec3 start = kRoom.center(3, 10, 10);
  const auto sideways = [&](float strength) {
    std::vector<float> extra(kRoom.size(), 0.0F);
    // Below the straight way.
    EXPECT_TRUE(add_brushes({{{{8.0F, 8.0F, 10.5F}, 5.0F, strength}}}, kRoom, extra));
    return with_extra(extra).guide[4 * kRoom.index(3, 10, 10) + 1];
  };
  EXPECT_GT(sideways(3.0F), sideways(0.0F) + 0.1F);
  EXPECT_LT(sideways(-0.5F), sideways(0.0F) - 0.1F);
  EXPECT_GT(start.x, 0.0F);
}

// However strong the attraction, a metre costs a tenth of A: costs go on rising away from the goal.
TEST(CostTerms, CannotMakeAMetreFree) {
  const CostField field = with_extra(std::vector<float>(kRoom.size(), -50.0F));
  const float near = field.cost_at(kRoom.center(10, 10, 10));
  const float far = field.cost_at(kRoom.center(5, 10, 10));
  EXPECT_NEAR(far - near, kLeastSlowness * 5.0F, 1e-3F);
}

TEST(CostTerms, RefusesWhatIsNoNumberOrOfAnotherSize) {
  const auto obstacles = worlds::obstacles(kRoom, worlds::nothing());
  const auto goal = worlds::goal(kRoom, worlds::sphere(glm::vec3(15.0F), 2.0F));
  std::vector<float> extra(kRoom.size(), 0.0F);
  extra[123] = std::nanf("");
  const auto field = build_cost_field(obstacles, goal, {}, 1, {}, {extra});
  ASSERT_FALSE(field);
  EXPECT_NE(field.error().message.find("cell 123"), std::string::npos) << to_string(field.error());
  extra[123] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(build_cost_field(obstacles, goal, {}, 1, {}, {extra}));
  extra.resize(5);
  EXPECT_FALSE(build_cost_field(obstacles, goal, {}, 1, {}, {extra}));
}

TEST(CostTerms, ArePartOfTheKeyWhenPresent) {
  const auto obstacles = worlds::obstacles(kRoom, worlds::nothing());
  const auto goal = worlds::goal(kRoom, worlds::sphere(glm::vec3(15.0F), 2.0F));
  std::vector<float> extra(kRoom.size(), 0.0F);
  const std::string plain = cost_key(obstacles, goal, {});
  EXPECT_EQ(plain, cost_key(obstacles, goal, {}, {}));
  const std::string zeros = cost_key(obstacles, goal, {}, {extra});
  extra[7] = 0.1F;
  EXPECT_NE(zeros, cost_key(obstacles, goal, {}, {extra}));
  EXPECT_NE(zeros, plain);
}

}  // namespace
}  // namespace mayfly::fields
