#include "fields/cost_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/allocation_count.hpp"
#include "tests/reference/eikonal_reference.hpp"
#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

const Grid kGrid{{-3.0F, 1.0F, 0.0F}, 0.8F, {26, 21, 19}};
const PlacedShape kGoal{SphereShape{{10.0F, 8.0F, 7.0F}, 2.3F}, {"scene.yaml", 7, 3}};

worlds::Phi rooms() {
  return worlds::unite({worlds::box({2, -9, -9}, {3, 10, 40}), worlds::box({6, 5, -9}, {7, 40, 40}),
                        worlds::sphere({-1, 12, 8}, 2.0F)});
}

CostSolver solver_for(const PlacedShape& goal = kGoal) {
  auto solver = CostSolver::make(kGrid, goal, {});
  EXPECT_TRUE(solver);
  return std::move(*solver);
}

// What a flight would get that began there.
CostField from_nothing(const DistanceField& obstacles, const PlacedShape& goal, glm::vec3 offset,
                       const CostTerms& terms = {}) {
  const auto region = build_goal_distance(goal, kGrid, 1, {}, offset);
  EXPECT_TRUE(region);
  auto field = build_cost_field(obstacles, *region, {}, 1, {}, terms);
  EXPECT_TRUE(field) << to_string(field.error());
  return std::move(*field);
}

void expect_same(const CostField& a, const CostField& b) {
  EXPECT_EQ(a.guide, b.guide);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.blocked, b.blocked);
  EXPECT_EQ(a.unreachable, b.unreachable);
  EXPECT_EQ(a.unreachable_example, b.unreachable_example);
}

TEST(CostSolver, AMovedGoalGivesTheBitsOfAFreshField) {
  const DistanceField obstacles = worlds::obstacles(kGrid, rooms());
  const std::vector<PlacedShape> goals{kGoal,
                                       {BoxShape{{{8, 3, 3}, {11, 6, 9}}}, {}},
                                       {CylinderShape{{9, 4, 4}, {11, 9, 6}, 1.0F}, {}},
                                       {SphereShape{{10.1F, 8.2F, 7.3F}, 0.05F}, {}},  // holds no centre
                                       {HalfSpaceShape{{1, 0, 0}, 1.0F}, {}}};
  for (const PlacedShape& goal : goals) {
    CostSolver solver = solver_for(goal);
    CostField field = solver.make_field();
    for (const glm::vec3 offset : {glm::vec3(0), {0.3F, 4, -2}, {-1.5F, 3, 1}, {-0.7F, 0, 0}, {0, 0, 0}}) {
      for (const int threads : {1, 3}) {
        const auto stats = solver.solve({obstacles.distance, offset, {}}, threads, field);
        ASSERT_TRUE(stats) << to_string(stats.error());
        expect_same(field, from_nothing(obstacles, goal, offset));
      }
    }
  }
}

TEST(CostSolver, TermsGiveTheBitsOfAFreshField) {
  const DistanceField obstacles = worlds::obstacles(kGrid, rooms());
  std::vector<float> extra(kGrid.size(), 0.0F);
  ASSERT_TRUE(add_brushes({{{{4, 8, 7}, 5.0F, 2.0F}}}, kGrid, extra));
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  ASSERT_TRUE(solver.solve({obstacles.distance, {}, {extra}}, 2, field));
  expect_same(field, from_nothing(obstacles, kGoal, {}, {extra}));
}

TEST(CostSolver, AsksForNoMemory) {
  const DistanceField obstacles = worlds::obstacles(kGrid, rooms());
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  const std::uint64_t before = allocation_count();
  bool good = true;
  for (const float x : {0.0F, 1.0F, -9.0F}) {
    good &= solver.solve({obstacles.distance, {x, 0, 0}, {}}, 1, field).has_value();
  }
  EXPECT_EQ(allocation_count() - before, 0U);
  EXPECT_TRUE(good);
}

TEST(CostSolver, ErrorsLeaveTheFieldAsItWas) {
  const DistanceField obstacles = worlds::obstacles(kGrid, rooms());
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  ASSERT_TRUE(solver.solve({obstacles.distance, {}, {}}, 2, field));
  const CostField before = field;
  const auto outside = solver.solve({obstacles.distance, {0, 500, 0}, {}}, 2, field);
  ASSERT_FALSE(outside);
  EXPECT_NE(to_string(outside.error()).find("scene.yaml:7:3: the goal lies outside the world"),
            std::string::npos);
  const auto buried = worlds::obstacles(kGrid, worlds::box({5, 3, 2}, {15, 13, 12}));
  const auto inside = solver.solve({buried.distance, {}, {}}, 2, field);
  ASSERT_FALSE(inside);
  EXPECT_NE(inside.error().message.find("inside obstacles"), std::string::npos);
  EXPECT_FALSE(solver.solve({std::span(obstacles.distance).first(9), {}, {}}, 2, field));
  EXPECT_FALSE(solver.solve({obstacles.distance, {}, {std::span(obstacles.distance).first(9)}}, 2, field));
  EXPECT_FALSE(solver.solve({obstacles.distance, glm::vec3(std::nanf("")), {}}, 2, field));
  expect_same(before, field);
  // And the next solve is right again.
  ASSERT_TRUE(solver.solve({obstacles.distance, {0, 1, 0}, {}}, 2, field));
  expect_same(field, from_nothing(obstacles, kGoal, {0, 1, 0}));
}

TEST(CostSolver, RefusesBadParametersGoalsAndGrids) {
  EXPECT_FALSE(CostSolver::make(kGrid, kGoal, {-1.0F}));
  EXPECT_FALSE(CostSolver::make(kGrid, {SphereShape{{0, 0, 0}, -1.0F}, {}}, {}));
  EXPECT_FALSE(CostSolver::make({{}, 1.0F, {3, 0, 2}}, kGoal, {}));
}

// Costs in m, as fast marching in double finds them; guides as far as rounding lets them be compared.
void expect_near(const CostField& local, const CostField& full) {
  ASSERT_EQ(local.kind, full.kind);
  for (std::size_t cell = 0; cell < local.kind.size(); ++cell) {
    const float a = local.guide[4 * cell + 3];
    const float b = full.guide[4 * cell + 3];
    ASSERT_NEAR(a, b, 2e-6F * (1.0F + std::abs(b)));
  }
}

// A ball that flies through the rooms, away from the goal: dozens of local solves in a row must not drift.
TEST(CostSolver, LocalSolvesEqualFullOnes) {
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  int local = 0;
  for (int step = 0; step < 40; ++step) {
    const float x = -2.0F + 0.2F * static_cast<float>(step);
    const auto obstacles =
        worlds::obstacles(kGrid, worlds::unite({rooms(), worlds::sphere({x, 12.0F - 0.5F * x, 8.0F}, 1.5F)}));
    const auto stats = solver.solve({obstacles.distance, {}, {}}, 2, field);
    ASSERT_TRUE(stats);
    local += stats->local ? 1 : 0;
    expect_near(field, from_nothing(obstacles, kGoal, {}));
  }
  EXPECT_GT(local, 20);
}

// Slowness at random, changed at random places: no shape is special.
TEST(CostSolver, LocalSolvesEqualFullOnesOnRandomTerms) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(0.0F, 3.0F);
  std::uniform_int_distribution<std::size_t> place(0, kGrid.size() - 1);
  const DistanceField obstacles = worlds::obstacles(kGrid, rooms());
  std::vector<float> extra(kGrid.size());
  for (float& e : extra) {
    e = value(random);
  }
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  int local = 0;
  for (int round = 0; round < 40; ++round) {
    const auto stats = solver.solve({obstacles.distance, {}, {extra}}, 1 + round % 3, field);
    ASSERT_TRUE(stats);
    local += stats->local ? 1 : 0;
    expect_near(field, from_nothing(obstacles, kGoal, {}, {extra}));
    for (int change = 0; change < 1 + round % 4; ++change) {
      extra[place(random)] = value(random);
    }
  }
  EXPECT_GT(local, 5);
}

// A wall that closes and opens a room: costs become infinite and finite again.
TEST(CostSolver, LocalSolvesSeeDoorsCloseAndOpen) {
  const auto wall = worlds::box({2, -9, -9}, {3, 10, 40});
  const auto door = worlds::box({2, 9, -9}, {3, 40, 40});
  const auto open = worlds::obstacles(kGrid, wall);
  const auto closed = worlds::obstacles(kGrid, worlds::unite({wall, door}));
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  for (const DistanceField* obstacles : {&open, &closed, &open, &open, &closed}) {
    const auto stats = solver.solve({obstacles->distance, {}, {}}, 2, field);
    ASSERT_TRUE(stats);
    expect_near(field, from_nothing(*obstacles, kGoal, {}));
    EXPECT_EQ(field.unreachable > 0, obstacles == &closed);
  }
}

TEST(CostSolver, NothingChangedIsNothingToSolve) {
  const DistanceField obstacles = worlds::obstacles(kGrid, rooms());
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  ASSERT_TRUE(solver.solve({obstacles.distance, {}, {}}, 2, field));
  const CostField first = field;
  const auto stats = solver.solve({obstacles.distance, {}, {}}, 2, field);
  ASSERT_TRUE(stats);
  EXPECT_TRUE(stats->local);
  EXPECT_EQ(stats->sweeps, 1);
  expect_same(first, field);
}

// Against the independent reference, not only against ourselves.
TEST(CostSolver, LocalSolvesAgreeWithFastMarching) {
  std::vector<float> extra(kGrid.size(), 0.0F);
  const DistanceField empty = worlds::obstacles(kGrid, worlds::nothing());
  CostSolver solver = solver_for();
  CostField field = solver.make_field();
  ASSERT_TRUE(solver.solve({empty.distance, {}, {extra}}, 1, field));
  std::vector<float> sources(kGrid.size(), worlds::kInfinity);
  for (std::size_t cell = 0; cell < kGrid.size(); ++cell) {
    const float cost = field.guide[4 * cell + 3];
    sources[cell] = cost <= 0.0F ? cost : worlds::kInfinity;
  }
  ASSERT_TRUE(add_brushes({{{{0, 8, 7}, 4.0F, 1.5F}}}, kGrid, extra));
  const auto stats = solver.solve({empty.distance, {}, {extra}}, 1, field);
  ASSERT_TRUE(stats);
  EXPECT_TRUE(stats->local);
  std::vector<float> slowness(kGrid.size());
  for (std::size_t cell = 0; cell < kGrid.size(); ++cell) {
    slowness[cell] = 1.0F + extra[cell] / 0.6F;
  }
  const auto truth = reference::fast_marching(26, 21, 19, static_cast<double>(kGrid.cell), slowness, sources);
  for (std::size_t cell = 0; cell < kGrid.size(); ++cell) {
    ASSERT_NEAR(field.guide[4 * cell + 3], truth[cell], 1e-4);
  }
}

}  // namespace
}  // namespace mayfly::fields
