// The error against analytic distances falls at first order in the cell side, or faster.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec3.hpp>

#include "fields/cost_field.hpp"
#include "fields/eikonal.hpp"
#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

using Exact = std::function<double(glm::dvec3)>;

struct Errors {
  double mean = 0.0;
  double max = 0.0;
};

// Cells nearer than 5 % of the world to `skip` are left out: they are blocked at one resolution and free at
// another.
Errors errors(int n, const worlds::Phi& obstacle, const worlds::Phi& goal, const Exact& exact) {
  const Grid grid = worlds::cube(n, 10.0F);
  CostParams params;
  params.repulsion_weight = 0.0F;
  const auto field =
      build_cost_field(worlds::obstacles(grid, obstacle), worlds::goal(grid, goal), params, 2, {});
  EXPECT_TRUE(field);
  Errors e;
  double count = 0.0;
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const glm::vec3 p = grid.center(i, j, k);
        if (field->kind[grid.index(i, j, k)] == CellKind::kReached && goal(p) > 0.0F && obstacle(p) > 0.5F) {
          const double error =
              std::abs(static_cast<double>(field->guide[4 * grid.index(i, j, k) + 3]) - exact(glm::dvec3(p)));
          e.mean += error;
          e.max = std::max(e.max, error);
          count += 1.0;
        }
      }
    }
  }
  e.mean /= count;
  return e;
}

void expect_first_order(const char* name, const worlds::Phi& obstacle, const worlds::Phi& goal,
                        const Exact& exact, double least_order_max) {
  const Errors coarse = errors(25, obstacle, goal, exact);
  const Errors middle = errors(50, obstacle, goal, exact);
  const Errors fine = errors(100, obstacle, goal, exact);
  const double order_mean = std::log2(middle.mean / fine.mean);
  const double order_max = std::log2(middle.max / fine.max);
  std::printf("%s: mean error %.4f %.4f %.4f m, order %.2f; max %.4f %.4f %.4f m, order %.2f\n", name,
              coarse.mean, middle.mean, fine.mean, order_mean, coarse.max, middle.max, fine.max, order_max);
  EXPECT_GT(order_mean, 0.9);
  EXPECT_GT(order_max, least_order_max);
  EXPECT_GT(coarse.mean / middle.mean, std::pow(2.0, 0.8));
  EXPECT_LT(fine.max, 0.05 * 10.0);
}

TEST(Convergence, SphereGoalInAnEmptyBox) {
  const glm::vec3 c(3.1F, 4.2F, 5.3F);
  expect_first_order(
      "sphere goal", worlds::nothing(), worlds::sphere(c, 1.5F),
      [=](glm::dvec3 p) { return glm::distance(p, glm::dvec3(c)) - 1.5; }, 0.9);
}

TEST(Convergence, BoxGoalInAnEmptyBox) {
  const Box box{glm::vec3(2.03F, 3.07F, 4.01F), glm::vec3(4.09F, 6.0F, 5.55F)};
  expect_first_order(
      "box goal", worlds::nothing(), worlds::box(box.min, box.max),
      [=](glm::dvec3 p) {
        const glm::dvec3 q =
            glm::max(glm::max(glm::dvec3(box.min) - p, p - glm::dvec3(box.max)), glm::dvec3(0.0));
        return glm::length(q);
      },
      0.9);
}

// Round a sphere: along a tangent, an arc, and a tangent to the goal's middle.
double around(glm::dvec3 p, glm::dvec3 goal, glm::dvec3 center, double radius) {
  const glm::dvec3 a = p - center;
  const glm::dvec3 b = goal - center;
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double angle = std::acos(std::clamp(glm::dot(a, b) / (la * lb), -1.0, 1.0));
  const double arc = angle - std::acos(radius / la) - std::acos(radius / lb);
  if (arc <= 0.0) {
    return glm::distance(p, goal);
  }
  return std::sqrt(la * la - radius * radius) + std::sqrt(lb * lb - radius * radius) + radius * arc;
}

// In the shadow every path creeps along the obstacle, whose surface is a staircase of cells: the largest
// error, which is there, falls a little slower than the mean.
TEST(Convergence, AroundASphere) {
  const glm::vec3 goal(1.7F, 5.1F, 4.9F);
  const glm::vec3 center(5.5F, 5.0F, 5.0F);
  expect_first_order(
      "around a sphere", worlds::sphere(center, 2.0F), worlds::sphere(goal, 1.0F),
      [=](glm::dvec3 p) { return around(p, glm::dvec3(goal), glm::dvec3(center), 2.0) - 1.0; }, 0.7);
}

}  // namespace
}  // namespace mayfly::fields
