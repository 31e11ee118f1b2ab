#include "fields/cost_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <numbers>
#include <span>
#include <utility>

#include "fields/eikonal.hpp"
#include "fields/guide.hpp"
#include "fields/hash.hpp"
#include "kernels/ramp.h"

namespace mayfly::fields {
namespace {

float influence_of(const CostParams& params, const Grid& grid) {
  return params.influence > 0.0F ? params.influence : 2.0F * std::numbers::sqrt2_v<float> * grid.cell;
}

Result<void> check_params(const CostParams& params) {
  const auto refuse = [](const char* name, float value, const char* wanted) {
    return fail(
        Error{Cause::kCaller, std::string("cost field: bad ") + name, {}, std::to_string(value), wanted});
  };
  // Negated comparisons: NaN is refused.
  if (!(params.length_weight > 0.0F && params.length_weight <= 1e6F)) {
    return refuse("length weight", params.length_weight, "a number in (0, 1e6]");
  }
  if (!(params.repulsion_weight >= 0.0F && params.repulsion_weight <= 1e6F)) {
    return refuse("repulsion weight", params.repulsion_weight, "a number in [0, 1e6]");
  }
  if (!(params.influence >= 0.0F && params.influence <= 1e6F)) {
    return refuse("influence", params.influence, "metres in [0, 1e6]; 0 means 2√2 cells");
  }
  if (!(params.clearance >= 0.0F && params.clearance <= 1e6F)) {
    return refuse("clearance", params.clearance, "metres in [0, 1e6]");
  }
  return {};
}

// s = A + B·h(φ/influence) (Wang14 Eq. 7 with weights), +inf where blocked.
void fill_slowness(std::span<const float> distance, const CostParams& params, const Grid& grid,
                   std::span<float> slowness) {
  const float clearance = effective_clearance(params, grid);
  const float scale = 1.0F / influence_of(params, grid);
  for (std::size_t at = 0; at < distance.size(); at += MF_LANES) {
    const std::size_t count = std::min<std::size_t>(MF_LANES, distance.size() - at);
    float phi[MF_LANES] = {};
    std::copy_n(distance.begin() + static_cast<std::ptrdiff_t>(at), count, phi);
    const kernels::F lanes = kernels::mf_load(phi);
    const kernels::F s = params.length_weight + params.repulsion_weight * kernels::mf_bell(lanes * scale);
    const kernels::F open =
        kernels::mf_select(lanes < kernels::mf_splat(clearance), kernels::mf_splat(kUnreachedCost), s);
    kernels::mf_store_first(slowness.data() + at, open, static_cast<int>(count));
  }
}

CellKind kind_of(float distance, float clearance, bool reached) {
  if (distance < clearance) {
    return CellKind::kBlocked;
  }
  return reached ? CellKind::kReached : CellKind::kUnreachable;
}

glm::ivec3 place_of(const Grid& grid, std::size_t cell) {
  const auto nx = static_cast<std::size_t>(grid.cells.x);
  const auto ny = static_cast<std::size_t>(grid.cells.y);
  return {static_cast<int>(cell % nx), static_cast<int>(cell / nx % ny), static_cast<int>(cell / nx / ny)};
}

glm::vec3 center_of(const Grid& grid, std::size_t cell) {
  const glm::ivec3 at = place_of(grid, cell);
  return grid.center(at.x, at.y, at.z);
}

void count_kinds(CostField& field) {
  for (std::size_t cell = 0; cell < field.kind.size(); ++cell) {
    field.blocked += field.kind[cell] == CellKind::kBlocked ? 1U : 0U;
    if (field.kind[cell] == CellKind::kUnreachable) {
      if (field.unreachable == 0) {
        field.unreachable_example = center_of(field.grid, cell);
      }
      ++field.unreachable;
    }
  }
}

// Costs with A = 1: C/A, for A + B·g and (A·φ_goal) scale together.
Result<CostField> solve(const DistanceField& obstacles, const GoalDistance& goal, const CostParams& params,
                        int threads, const Progress& progress) {
  const Grid& grid = obstacles.grid;
  std::vector<float> cost(grid.size());
  const float clearance = effective_clearance(params, grid);
  const auto small = place_sources(obstacles, goal, clearance, cost);
  if (!small) {
    return fail(small.error());
  }
  std::vector<std::size_t> pointing;
  for (std::size_t cell = 0; *small && goal.middle && cell < cost.size(); ++cell) {
    if (cost[cell] != kUnreachedCost) {
      pointing.push_back(cell);
    }
  }
  std::vector<float> slowness(grid.size());
  const CostParams scaled{1.0F, params.repulsion_weight / params.length_weight, params.influence,
                          params.clearance};
  fill_slowness(obstacles.distance, scaled, grid, slowness);
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
  field.kind.resize(grid.size());
  for (std::size_t cell = 0; cell < cost.size(); ++cell) {
    field.kind[cell] = kind_of(obstacles.distance[cell], clearance, cost[cell] != kUnreachedCost);
  }
  count_kinds(field);
  field.guide = make_guide({grid, obstacles.distance, cost, field.kind, clearance}, threads, progress);
  if (!pointing.empty()) {
    point_at(*goal.middle, grid, pointing, field.guide);
  }
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
                                   const CostParams& params, int threads, const Progress& progress) {
  if (auto good = check_params(params); !good) {
    return fail(good.error());
  }
  try {
    return solve(obstacles, goal, params, threads, progress);
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
  field.kind.resize(obstacles.grid.size());
  const float clearance = effective_clearance(params, obstacles.grid);
  for (std::size_t cell = 0; cell < field.kind.size(); ++cell) {
    field.kind[cell] =
        kind_of(obstacles.distance[cell], clearance, field.guide[4 * cell + 3] < kUnreachableGuide);
  }
  count_kinds(field);
  return field;
}

std::string cost_key(const DistanceField& obstacles, const GoalDistance& goal, const CostParams& params) {
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
  return "cost " + hash.hex();
}

float CostField::cost_at(glm::vec3 p) const {
  const glm::vec3 u = (p - grid.origin) / grid.cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(u[axis] >= 0.0F && u[axis] <= static_cast<float>(grid.cells[axis]))) {
      return kUnreachedCost;
    }
  }
  const glm::ivec3 last = grid.cells - 1;
  const glm::ivec3 home = glm::min(glm::ivec3(u), last);
  const glm::ivec3 corner = glm::ivec3(glm::floor(u - 0.5F));
  float nearest = std::numeric_limits<float>::infinity();
  float cost = kUnreachedCost;
  const auto consider = [&](glm::ivec3 at, float distance) {
    const std::size_t cell = grid.index(at.x, at.y, at.z);
    if (kind[cell] != CellKind::kBlocked && distance < nearest) {
      nearest = distance;
      cost = kind[cell] == CellKind::kReached ? guide[4 * cell + 3] : kUnreachedCost;
    }
  };
  consider(home, 0.0F);
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 at = glm::clamp(corner + glm::ivec3(k & 1, k >> 1 & 1, k >> 2), glm::ivec3(0), last);
    consider(at, glm::distance(p, grid.center(at.x, at.y, at.z)));
  }
  return cost;
}

bool CostField::reaches(glm::vec3 p) const {
  return cost_at(p) != kUnreachedCost;
}

std::optional<glm::vec3> CostField::unreachable_in(const Box& region) const {
  for (std::size_t cell = 0; unreachable > 0 && cell < kind.size(); ++cell) {
    if (kind[cell] == CellKind::kUnreachable && region.contains(center_of(grid, cell))) {
      return center_of(grid, cell);
    }
  }
  return std::nullopt;
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
