#include "fields/nested_cost.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "fields/cost_parts.hpp"
#include "fields/eikonal.hpp"
#include "fields/nested_distance.hpp"
#include "fields/nested_guide.hpp"
#include "fields/nested_march.hpp"
#include "fields/parallel.hpp"

namespace mayfly::fields {
namespace {

// Fine cells from the goal beyond which differences between cells tell its direction well enough.
constexpr float kFar = 8.0F;

struct Build {
  const NestedGrid& nested;
  std::span<const float> distance;
  const Geometry& goal;
  std::span<const float> goal_distance;
  Slowness slowness;
  float room;  // m from obstacles from which on a metre costs a metre
  int threads;
  const Progress& progress;

  bool is_free(std::size_t entry) const { return !(distance[entry] < slowness.clearance); }

  // ∇φ of the goal; shorter than 1 where several of its points are equally near.
  glm::vec3 outwards(const NestedGrid::Leaf& leaf) const {
    const float cell = nested.cell();
    const bool differences = leaf.side == cell && std::fabs(goal_distance[leaf.entry]) > kFar * cell;
    const float h = differences ? cell : 0.25F * cell;
    constexpr std::size_t kStride[3] = {1, NestedGrid::kBrickSide,
                                        NestedGrid::kBrickSide * NestedGrid::kBrickSide};
    glm::vec3 gradient(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 step(0.0F);
      step[axis] = h;
      const float high =
          differences ? goal_distance[leaf.entry + kStride[axis]] : goal.signed_distance(leaf.center + step);
      const float low =
          differences ? goal_distance[leaf.entry - kStride[axis]] : goal.signed_distance(leaf.center - step);
      gradient[axis] = (high - low) / (2.0F * h);
    }
    const float length = glm::length(gradient);
    return length > 1.0F ? gradient / length : gradient;
  }

  // Sets a cell in the goal, or one from which the straight way there is clear.
  void look(const NestedGrid::Leaf& leaf, const NestedSight& sight, NestedCosts& costs,
            std::span<float> guide) const {
    const float level = goal_distance[leaf.entry];
    if (!is_free(leaf.entry) || (level > 0.0F && distance[leaf.entry] < room)) {
      return;
    }
    const glm::vec3 out = outwards(leaf);
    const float length = glm::length(out);
    const glm::vec3 direction = length > 1e-3F ? -out / length : glm::vec3(0.0F);
    const glm::vec3 nearest = leaf.center + direction * level;
    // Negated: where several points are nearest, the way to none of them is known.
    if (level > 0.0F && (!(length > 0.9F) || !sight.clear(leaf.center, nearest))) {
      return;
    }
    costs.cost[leaf.entry] = level;
    costs.fixed[leaf.entry] = 1;
    for (int axis = 0; axis < 3; ++axis) {
      guide[4 * leaf.entry + static_cast<std::size_t>(axis)] = direction[axis];
    }
    if (leaf.side > nested.cell()) {
      costs.rays[leaf.entry] = level > 0.0F ? Ray{nearest, 0.0F} : Ray{leaf.center, level};
    }
  }

  Result<void> place_sources(NestedCosts& costs, std::span<float> guide) const {
    const NestedSight sight(nested, distance, room);
    parallel_for(static_cast<std::size_t>(nested.coarse.cells.z), threads, "cost: straight ways", progress,
                 [&](std::size_t z) {
                   nested.for_each_in_plane(static_cast<int>(z), [&](glm::ivec3 at) {
                     nested.for_each_leaf_in(
                         at, [&](const NestedGrid::Leaf& leaf) { look(leaf, sight, costs, guide); });
                   });
                 });
    NestedGrid::Leaf nearest{};
    NestedGrid::Leaf nearest_free{};
    float least = std::numeric_limits<float>::infinity();
    float least_free = least;
    nested.for_each_leaf([&](const NestedGrid::Leaf& leaf) {
      const float level = goal_distance[leaf.entry];
      if (level < least) {
        least = level;
        nearest = leaf;
      }
      if (level < least_free && is_free(leaf.entry)) {
        least_free = level;
        nearest_free = leaf;
      }
    });
    // Half the diagonal of a cell: a goal farther than that from every centre has no point in any cell.
    if (!(least <= 0.8661F * nearest.side)) {
      return fail(Cause::kCaller, "the goal lies outside the world");
    }
    if (!(least_free <= nested.cell())) {
      return fail(
          Error{Cause::kCaller,
                "the goal lies inside obstacles, or nearer to them than an agent can come",
                std::nullopt,
                "no free cell in it or within a cell side (" + std::to_string(nested.cell()) + " m) of it",
                {},
                {}});
    }
    // In a goal that holds no cell's centre, and that nobody sees.
    costs.cost[nearest_free.entry] = least_free;
    costs.fixed[nearest_free.entry] = 1;
    return {};
  }
};

void count_kinds(CostField& field) {
  field.for_each_cell([&](std::size_t entry, glm::vec3 center, float) {
    field.blocked += field.kind[entry] == CellKind::kBlocked ? 1U : 0U;
    if (field.kind[entry] == CellKind::kUnreachable) {
      if (field.unreachable == 0) {
        field.unreachable_example = center;
      }
      ++field.unreachable;
    }
  });
}

Result<CostField> solve(const NestedObstacles& obstacles, const Geometry& goal, const CostParams& params,
                        int threads, const Progress& progress) {
  const NestedGrid& nested = *obstacles.nested;
  const Grid fine = nested.fine();
  const Slowness slowness{params.repulsion_weight / params.length_weight, 1.0F / influence_of(params, fine),
                          effective_clearance(params, fine)};
  const float felt = params.repulsion_weight > 0.0F ? influence_of(params, fine) : 0.0F;
  auto goal_distance = sample_nested(goal, nested, threads, progress);
  if (!goal_distance) {
    return fail(std::move(goal_distance.error()));
  }
  const Build build{nested,   obstacles.distance,
                    goal,     *goal_distance,
                    slowness, std::max(felt, slowness.clearance),
                    threads,  progress};
  CostField field;
  field.grid = fine;
  field.nested = obstacles.nested;
  field.guide.resize(4 * nested.entries());
  NestedCosts costs{nested, obstacles.distance, std::vector<float>(nested.entries(), kUnreachedCost),
                    std::vector<std::uint8_t>(nested.entries(), 0), std::vector<Ray>(nested.coarse.size())};
  if (auto placed = build.place_sources(costs, field.guide); !placed) {
    return fail(std::move(placed.error()));
  }
  *goal_distance = {};  // its bytes are wanted for the rest
  NestedMarch(costs, slowness, NestedSight(nested, obstacles.distance, build.room)).run(progress);
  field.kind.resize(nested.entries(), CellKind::kBlocked);
  nested.for_each_leaf([&](const NestedGrid::Leaf& leaf) {
    if (build.is_free(leaf.entry)) {
      field.kind[leaf.entry] =
          costs.cost[leaf.entry] == kUnreachedCost ? CellKind::kUnreachable : CellKind::kReached;
    }
  });
  fill_nested_guide({costs, slowness.clearance}, threads, progress, field);
  count_kinds(field);
  return field;
}

}  // namespace

Result<CostField> build_nested_cost(const NestedObstacles& obstacles, const Geometry& goal,
                                    const CostParams& params, int threads, const Progress& progress) {
  if (auto good = check_params(params); !good) {
    return fail(good.error());
  }
  try {
    return solve(obstacles, goal, params, threads, progress);
  } catch (const std::bad_alloc&) {
    return fail(Cause::kEnvironment, "not enough memory for a cost field on a nested grid of " +
                                         std::to_string(obstacles.nested->entries()) + " cells");
  }
}

}  // namespace mayfly::fields
