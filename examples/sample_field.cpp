// Fields of a world with one box in it: how far is the wall, and which way leads to the goal?
#include <cmath>
#include <cstdio>

#include "fields/cost_field.hpp"
#include "fields/make_grid.hpp"
#include "fields/spline.hpp"
#include "kernels/grid.h"

namespace fields = mayfly::fields;
namespace kernels = mayfly::kernels;

int main() {
  // 20 × 20 × 10 m in cells of half a metre; a block from wall to wall, but for a gap at large y.
  const auto grid = fields::make_grid({{0, 0, 0}, {20, 20, 10}}, 0.5F);
  const fields::PlacedShape block{fields::BoxShape{{{8, 0, 0}, {12, 14, 10}}}, {}};
  const fields::PlacedShape goal{fields::SphereShape{{17, 4, 5}, 2.0F}, {}};
  const auto solid = fields::Geometry::make({&block, 1}, 0.5F);
  if (!grid || !solid) return 1;

  const auto distance = fields::build_distance_field(*solid, *grid, 0, {});
  const auto region = fields::build_goal_distance(goal, *grid, 0, {});
  if (!distance || !region) return 1;
  fields::CostParams weights;
  weights.clearance = 0.2F;  // m: the body's radius
  const auto cost = fields::build_cost_field(*distance, *region, weights, 0, {});
  if (!cost) return std::fprintf(stderr, "%s\n", to_string(cost.error()).c_str()), 1;

  // As an agent samples them. Kernels take eight points at a time; here all eight are the same.
  const kernels::MfGrid table{grid->origin.x, grid->origin.y, grid->origin.z, grid->cell, 1.0F / grid->cell,
                              grid->cells.x,  grid->cells.y,  grid->cells.z,  0};
  const kernels::F3 p = kernels::mf3_splat(5.0F, 6.0F, 5.0F);
  const std::vector<float> spline = fields::spline_coefficients(*grid, distance->distance);
  const kernels::MfSurface wall = kernels::mf_surface(p, spline.data(), &table);
  const kernels::MfCube cube = kernels::mf_cube(p, &table);
  kernels::F sampled[4];
  kernels::mf_sample4(cost->guide.data(), &cube, sampled);
  const auto guide = [&](int channel) { return sampled[channel][0]; };

  std::printf("at (5, 6, 5): %.3f m from the wall (exactly: %.3f m), which lies along (%.2f, %.2f, %.2f)\n",
              wall.value[0], solid->signed_distance({5, 6, 5}), -wall.gradient.x[0], -wall.gradient.y[0],
              -wall.gradient.z[0]);
  std::printf("to the goal: along (%.2f, %.2f, %.2f), as cheap as %.1f m of free air; %zu cells cut off\n",
              guide(0), guide(1), guide(2), guide(3), cost->unreachable);

  const bool far_right =
      std::fabs(wall.value[0] - 3.0F) < 1e-3F && std::fabs(wall.gradient.x[0] + 1.0F) < 1e-3F;
  const bool goes_round = guide(1) > 0.8F;  // first to the gap, though the goal is at smaller y
  const bool costs_more = guide(3) > std::hypot(12.0F, 2.0F) - 2;  // than straight through the block
  return far_right && goes_round && costs_more && cost->unreachable == 0 ? 0 : 1;
}
