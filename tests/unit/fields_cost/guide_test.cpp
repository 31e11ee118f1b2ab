// An agent that follows the interpolated guide gets to the goal, and through no wall.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

struct World {
  Grid grid;
  worlds::Phi phi;
  worlds::Phi goal;
};

// Trilinear and normalised, in double precision, as an agent's kernel has it.
glm::dvec3 direction_at(const CostField& field, glm::dvec3 p) {
  const Grid& grid = field.grid;
  const glm::dvec3 last(grid.cells - 1);
  const glm::dvec3 u =
      glm::clamp((p - glm::dvec3(grid.origin)) / static_cast<double>(grid.cell) - 0.5, glm::dvec3(0.0), last);
  const glm::ivec3 low(u);
  const glm::dvec3 t = u - glm::dvec3(low);
  glm::dvec3 sum(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::ivec3 at = glm::min(low + side, grid.cells - 1);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      weight *= side[axis] != 0 ? t[axis] : 1.0 - t[axis];
    }
    const float* g = &field.guide[4 * grid.index(at.x, at.y, at.z)];
    sum += weight * glm::dvec3(g[0], g[1], g[2]);
  }
  const double length = glm::length(sum);
  return length < 1e-9 ? glm::dvec3(0.0) : sum / length;
}

struct Flight {
  bool arrived = false;
  float closest = kNoObstacle;  // to an obstacle, m
  float length = 0.0F;          // m
  glm::vec3 end{0.0F};
};

Flight follow(const World& world, const CostField& field, glm::vec3 start) {
  Flight flight;
  const double step = 0.05 * static_cast<double>(world.grid.cell);
  const float longest = 3.0F * field.cost_at(start) + 20.0F * world.grid.cell;
  glm::dvec3 p(start);
  for (; flight.length < longest; flight.length += static_cast<float>(step)) {
    flight.end = glm::vec3(p);
    flight.closest = std::min(flight.closest, world.phi(flight.end));
    if (world.goal(flight.end) <= 0.0F) {
      flight.arrived = true;
      break;
    }
    p += step * direction_at(field, p);
  }
  return flight;
}

// `starts` random points of which an agent of that clearance may start.
void expect_all_arrive(const World& world, const CostParams& params, int starts, unsigned seed) {
  const auto field = build_cost_field(worlds::obstacles(world.grid, world.phi),
                                      worlds::goal(world.grid, world.goal), params, 2, {});
  if (!field) {
    return;  // the goal is buried
  }
  std::mt19937 random(seed);
  const glm::vec3 size = world.grid.cell * glm::vec3(world.grid.cells);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (int n = 0; n < starts; ++n) {
    const glm::vec3 start = world.grid.origin + size * glm::vec3(unit(random), unit(random), unit(random));
    if (world.phi(start) < effective_clearance(params, world.grid) || !field->reaches(start)) {
      continue;
    }
    const Flight flight = follow(world, *field, start);
    EXPECT_TRUE(flight.arrived) << "seed " << seed << " from " << start.x << ' ' << start.y << ' ' << start.z
                                << " stuck at " << flight.end.x << ' ' << flight.end.y << ' ' << flight.end.z;
    EXPECT_GT(flight.closest, 0.0F) << "seed " << seed << " from " << start.x << ' ' << start.y << ' '
                                    << start.z;
  }
}

CostParams plain() {
  CostParams params;
  params.repulsion_weight = 0.0F;
  return params;
}

TEST(Guide, RandomBoxWorlds) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    const World world{worlds::cube(24, 12.0F), worlds::unite(worlds::random_boxes(random, 12.0F, 10)),
                      worlds::sphere(glm::vec3(10.0F, 9.0F, 6.0F), 1.0F)};
    expect_all_arrive(world, {}, 60, seed);
    expect_all_arrive(world, plain(), 60, seed);
  }
}

TEST(Guide, AroundABoxCornerWithoutRepulsion) {
  const World world{worlds::cube(30, 15.0F),
                    worlds::box(glm::vec3(5.0F, -1.0F, -1.0F), glm::vec3(9.0F, 10.0F, 16.0F)),
                    worlds::sphere(glm::vec3(12.0F, 2.0F, 7.5F), 1.0F)};
  expect_all_arrive(world, plain(), 400, 1);
}

TEST(Guide, AroundASphere) {
  const World world{worlds::cube(30, 15.0F), worlds::sphere(glm::vec3(7.5F, 7.6F, 7.4F), 3.5F),
                    worlds::sphere(glm::vec3(13.0F, 7.5F, 7.5F), 1.0F)};
  expect_all_arrive(world, plain(), 400, 2);
  expect_all_arrive(world, {}, 400, 2);
}

TEST(Guide, AroundAWallThinnerThanACell) {
  for (const float at : {7.0F, 7.13F, 7.25F, 7.4F}) {
    const World world{worlds::cube(30, 15.0F),
                      worlds::box(glm::vec3(at, -1.0F, -1.0F), glm::vec3(at + 0.05F, 10.0F, 16.0F)),
                      worlds::sphere(glm::vec3(12.0F, 2.0F, 7.5F), 1.0F)};
    expect_all_arrive(world, plain(), 200, 3);
    expect_all_arrive(world, {}, 200, 3);
  }
}

TEST(Guide, ThroughAHoleOneCellWide) {
  const World world{worlds::cube(30, 15.0F),
                    worlds::unite({worlds::box(glm::vec3(7, -1, -1), glm::vec3(8, 7.5F, 16)),
                                   worlds::box(glm::vec3(7, 8.0F, -1), glm::vec3(8, 16, 16)),
                                   worlds::box(glm::vec3(7, -1, -1), glm::vec3(8, 16, 7)),
                                   worlds::box(glm::vec3(7, -1, 7.5F), glm::vec3(8, 16, 16))}),
                    worlds::sphere(glm::vec3(12.0F, 2.0F, 7.5F), 1.0F)};
  expect_all_arrive(world, plain(), 300, 4);
  expect_all_arrive(world, {}, 300, 4);
}

TEST(Guide, ABodyOfSeveralCells) {
  const World world{worlds::cube(30, 15.0F),
                    worlds::box(glm::vec3(5.0F, -1.0F, -1.0F), glm::vec3(9.0F, 10.0F, 16.0F)),
                    worlds::sphere(glm::vec3(12.0F, 2.0F, 7.5F), 1.5F)};
  CostParams stout = plain();
  stout.clearance = 1.6F;
  expect_all_arrive(world, stout, 300, 5);
}

}  // namespace
}  // namespace mayfly::fields
