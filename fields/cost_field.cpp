#include "fields/cost_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <span>
#include <utility>

#include "fields/cost_parts.hpp"
#include "fields/eikonal.hpp"
#include "fields/hash.hpp"

namespace mayfly::fields {
namespace {

Result<CostField> solve(const DistanceField& obstacles, const GoalDistance& goal, const CostParams& params,
                        const CostTerms& terms, int threads, const Progress& progress) {
  const Grid& grid = obstacles.grid;
  std::vector<float> cost(grid.size());
  std::vector<std::size_t> small;
  if (auto placed = place_sources(obstacles.distance, goal, effective_clearance(params, grid), cost, small);
      !placed) {
    return fail(std::move(placed.error()));
  }
  std::vector<float> slowness(grid.size());
  fill_slowness(obstacles.distance, terms, params, grid, 0, grid.size(), slowness);
  const auto solved =
      solve_eikonal(grid, slowness, cost, static_cast<unsigned>(std::max(threads, 0)), [&](int sweeps) {
        if (progress) {
          // Nobody knows how many sweeps it takes; worlds without a maze need about sixteen.
          progress("cost: sweeps", static_cast<double>(sweeps) / (sweeps + 8.0));
        }
      });
  if (!solved) {
    return fail(solved.error());
  }
  CostField field;
  field.grid = grid;
  finish_cost_field(obstacles.distance, cost, params, {small, goal.middle}, threads, progress, field);
  return field;
}

std::string with_thousands(std::size_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ' ');
  }
  return digits;
}

}  // namespace

float effective_clearance(const CostParams& params, const Grid& grid) {
  return std::max(params.clearance, 0.5F * grid.cell) * (1.0F - 1e-3F);
}

Result<CostField> build_cost_field(const DistanceField& obstacles, const GoalDistance& goal,
                                   const CostParams& params, int threads, const Progress& progress,
                                   const CostTerms& terms) {
  if (auto good = check_params(params); !good) {
    return fail(good.error());
  }
  if (auto good = check_terms(terms, obstacles.grid); !good) {
    return fail(good.error());
  }
  try {
    return solve(obstacles, goal, params, terms, threads, progress);
  } catch (const std::bad_alloc&) {
    return fail(Cause::kEnvironment,
                "not enough memory for a cost field of " + with_thousands(obstacles.grid.size()) + " cells");
  }
}

CostField restore_cost_field(const DistanceField& obstacles, const CostParams& params,
                             std::vector<float> guide) {
  CostField field;
  field.grid = obstacles.grid;
  field.guide = std::move(guide);
  // The cost is the last of the guide's four numbers.
  set_kinds(obstacles.distance, std::span(field.guide).subspan(3), 4, kUnreachableGuide,
            effective_clearance(params, obstacles.grid), field);
  return field;
}

std::string cost_key(const DistanceField& obstacles, const GoalDistance& goal, const CostParams& params,
                     const CostTerms& terms) {
  const Grid& grid = obstacles.grid;
  ContentHash hash;
  hash.add(std::string_view("cost field 1"));  // raise it when the same input gives another guide
  for (int axis = 0; axis < 3; ++axis) {
    hash.add(grid.origin[axis]).add(grid.cells[axis]);
  }
  hash.add(grid.cell).add(params.length_weight).add(params.repulsion_weight);
  hash.add(influence_of(params, grid)).add(effective_clearance(params, grid));
  hash.add_all(std::span<const float>(obstacles.distance)).add_all(std::span<const float>(goal.distance));
  hash.add(goal.middle.has_value());
  for (int axis = 0; goal.middle && axis < 3; ++axis) {
    hash.add((*goal.middle)[axis]);
  }
  if (!terms.extra_slowness.empty()) {
    hash.add(std::string_view("extra")).add_all(terms.extra_slowness);
  }
  return "cost " + hash.hex();
}

float CostField::cost_at(glm::vec3 p) const {
  const glm::vec3 u = (p - grid.origin) / grid.cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(u[axis] >= 0.0F && u[axis] <= static_cast<float>(grid.cells[axis]))) {
      return kUnreachedCost;
    }
  }
  const Lattice cells = nested ? nested->lattice_at(p) : Lattice{grid, 0};
  const glm::vec3 local = (p - cells.grid.origin) / cells.grid.cell;
  const glm::ivec3 last = cells.grid.cells - 1;
  const glm::ivec3 home = glm::clamp(glm::ivec3(local), glm::ivec3(0), last);
  const glm::ivec3 corner = glm::ivec3(glm::floor(local - 0.5F));
  float nearest = std::numeric_limits<float>::infinity();
  float cost = kUnreachedCost;
  const auto consider = [&](glm::ivec3 at, float distance) {
    const std::size_t cell = cells.entry(at);
    if (kind[cell] != CellKind::kBlocked && distance < nearest) {
      nearest = distance;
      cost = kind[cell] == CellKind::kReached ? guide[4 * cell + 3] : kUnreachedCost;
    }
  };
  consider(home, 0.0F);
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 at = glm::clamp(corner + glm::ivec3(k & 1, k >> 1 & 1, k >> 2), glm::ivec3(0), last);
    consider(at, glm::distance(p, cells.center(at)));
  }
  return cost;
}

bool CostField::reaches(glm::vec3 p) const {
  return cost_at(p) != kUnreachedCost;
}

std::optional<glm::vec3> CostField::unreachable_in(const Box& region) const {
  std::optional<glm::vec3> first;
  if (unreachable > 0) {
    for_each_cell([&](std::size_t cell, glm::vec3 center, float) {
      if (!first && kind[cell] == CellKind::kUnreachable && region.contains(center)) {
        first = center;
      }
    });
  }
  return first;
}

std::string describe_unreachable(const CostField& field, std::string_view goal) {
  if (field.unreachable == 0) {
    return {};
  }
  const glm::vec3 p = field.unreachable_example.value_or(glm::vec3(0.0F));
  char where[96];
  std::snprintf(where, sizeof where, "(%g, %g, %g)", static_cast<double>(p.x), static_cast<double>(p.y),
                static_cast<double>(p.z));
  return with_thousands(field.unreachable) + " free cells cannot reach goal '" + std::string(goal) +
         "', for instance at " + where;
}

}  // namespace mayfly::fields
